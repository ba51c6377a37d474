#pragma once
// One physics of the scene. It owns its state and reads that of others through const Views.
#include "base/base.hpp"
#include "coupling/clock.hpp"
#include "coupling/concerns.hpp"
#include "coupling/history_value.hpp"
#include "coupling/intervals.hpp"
#include "coupling/ledger.hpp"
#include "coupling/limits.hpp"
#include "coupling/task.hpp"
#include "io/field_list.hpp"
#include "io/scene.hpp"

#include <cstdint>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

namespace vug {

class SharedFields;

/// Nodes that have just turned from solid to fluid: fluid indices [first, last) of the list.
struct Births {
  int first = 0;
  int last = 0;
  bool solid_moved = false;  ///< some of them are opened pathways, whose solid has moved to other nodes
};

class Module {
 public:
  virtual ~Module() = default;
  virtual std::string_view name() const = 0;

  /// Brings the state to time zero where that needs computation; not called when a run is resumed or only checked.
  virtual void begin(const Exec&) {}
  /// Takes one lattice step: launches kernels, without fences, allocations or copies to the host.
  virtual void step(const Exec& exec, const Clock& clock) = 0;
  /// Adds the tasks of a step, in their order (tasks.cpp).
  virtual void tasks(std::vector<Task>& schedule) const = 0;
  /// Does the work that was delayed until somebody needs it or what drives it changes. Called by all ranks.
  virtual void catch_up(const Exec&) {}
  /// Gathers, before fields and state are read, on each rank what others hold of its part, and on the first rank sums
  /// and short lists. Called by all ranks, like all other functions, and only where there are several.
  virtual void gather(const Exec&) {}
  /// Calls visit(name in checkpoints, field, Shares) for all fields that ranks share out by nodes.
  virtual void visit_shares(const SharedFields&) const {}
  /// Adapts to new fluid nodes; called between steps, when the list of fluid nodes has grown.
  virtual void births(const Exec&, const Births&) {}
  /// Throws StabilityError when the state is out of bounds; called every guard interval, may wait for the device.
  virtual void guard(const Exec&, const Clock&) {}
  /// What is wrong with the state although the run goes on. Called by all ranks after each guard; may wait for the
  /// device.
  virtual std::vector<Concern> concerns(const Exec&) const { return {}; }
  /// Adds derived numbers with their safe ranges.
  virtual void limits(LimitTable&) const {}
  /// Adds conserved sums.
  virtual void ledger(Ledger&) const {}
  /// Adds its numbers to a row of history.csv.
  virtual void history(std::vector<HistoryValue>&) const {}
  /// Adds to a row of history.csv what crosses sides and openings and the forces on them, as far as the case requests
  /// it.
  virtual void surfaces(const Clock&, const OutputSection&, std::vector<HistoryValue>&) const {}
  /// Adds its fields for output.
  virtual void fields(FieldList&) const {}
  /// Shortens the intervals that are too long for it at this largest speed of the fluid (lattice units; nothing: the
  /// largest that the case can drive), where intervals are chosen during the run (accuracy.tolerance).
  virtual void bound(std::optional<double>, Intervals&) const {}
  /// Reports how much its results have changed since the last call; waits for the device.
  virtual void watch(const Exec&, const Clock&, Changes&) {}
  /// Uses other intervals from the step that follows, which must end both the present and the new ones.
  virtual void take(const Exec&, const Intervals&) {}
  /// Uses the intervals of a state that was just loaded.
  virtual void resume(const Exec&, const Intervals&) {}
  /// Adds what a checkpoint must contain. Called for every checkpoint, because the list of fluid nodes grows.
  virtual void state(StateList&) {}
};

}  // namespace vug
