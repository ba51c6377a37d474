#pragma once
// One physics of the scene: it owns its state, and reads that of others through const Views.
#include "coupling/clock.hpp"
#include "coupling/intervals.hpp"
#include "coupling/ledger.hpp"
#include "coupling/limits.hpp"
#include "coupling/task.hpp"
#include "io/field_list.hpp"
#include "io/scene.hpp"
#include "kernels/base/base.hpp"

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
  bool solid_moved = false;  ///< some of them are opened pathways, whose solid volume has gone to other nodes
};

/// A number of history.csv.
struct HistoryValue {
  std::string name;  ///< with its unit: "time_s"
  double value;
};

class Module {
 public:
  virtual ~Module() = default;
  virtual std::string_view name() const = 0;

  /// Brings the state to time zero where that takes computing; not called when a run is resumed or only checked.
  virtual void begin(const Exec&) {}
  /// One lattice step: launches kernels; no fence, no allocation, no copy to the host.
  virtual void step(const Exec& exec, const Clock& clock) = 0;
  /// Adds what a step does, in its order (tasks.cpp).
  virtual void tasks(std::vector<Task>& schedule) const = 0;
  /// Takes the work that it has put off until somebody looks or what drives it changes. Called by all ranks.
  virtual void catch_up(const Exec&) {}
  /// Brings to each rank what others hold of its part, and to the first one sums and short lists, before fields and
  /// state are looked at. Called by all ranks, as every other function, and only where there are several.
  virtual void gather(const Exec&) {}
  /// visit(name in checkpoints, field, Shares) of all that the ranks share out by nodes.
  virtual void visit_shares(const SharedFields&) const {}
  /// Takes up newborn fluid nodes; called between steps, when the list of fluid nodes has grown.
  virtual void births(const Exec&, const Births&) {}
  /// Throws StabilityError when the state has left its bounds; called every guard interval, may wait for the device.
  virtual void guard(const Exec&, const Clock&) {}
  /// Derived numbers with their safe ranges.
  virtual void limits(LimitTable&) const {}
  /// Conserved sums.
  virtual void ledger(Ledger&) const {}
  /// What it adds to a row of history.csv.
  virtual void history(std::vector<HistoryValue>&) const {}
  /// What crosses sides and openings and pushes on them, as far as the case wants it in a row of history.csv.
  virtual void surfaces(const Clock&, const OutputSection&, std::vector<HistoryValue>&) const {}
  /// What it offers for output.
  virtual void fields(FieldList&) const {}
  /// Shortens what it cannot step as seldom at this largest speed of the fluid (lattice units; nothing: that which the
  /// case can drive), where intervals are chosen as the run goes (accuracy.tolerance).
  virtual void bound(std::optional<double>, Intervals&) const {}
  /// How much of what it computes has changed since it was asked last; waits for the device.
  virtual void watch(const Exec&, const Clock&, Changes&) {}
  /// Goes on with other intervals from the step that follows, which ends all of theirs and of those until now.
  virtual void take(const Exec&, const Intervals&) {}
  /// Goes on with those to which a state that was just loaded belongs.
  virtual void resume(const Exec&, const Intervals&) {}
  /// What a checkpoint must hold. Called anew for every checkpoint: the list of fluid nodes grows.
  virtual void state(StateList&) {}
};

}  // namespace vug
