#pragma once
// The loop over time: modules in their order, growth of the pores at its interval.
#include "coupling/build_modules.hpp"
#include "coupling/clock.hpp"
#include "coupling/interval_chooser.hpp"

namespace vug {

/// A running scene. Knows nothing of files, which `run.hpp` writes.
class Simulation {
 public:
  /// All ranks, which share the work, construct a Simulation of the same scene and call the same functions of it.
  explicit Simulation(const Scene& scene, const Ranks& ranks = {});

  /// Brings all modules to time zero (tectonic preload). Not called when a checkpoint is loaded instead.
  void begin();
  /// Takes one lattice step. Work that a module delays is done by catch_up().
  void step();
  /// Brings all modules to the present. Must be called before parts(), or fields listed earlier, are read; all
  /// functions below call it.
  void catch_up() const;
  /// Brings each rank what others hold for it. Must be called by all ranks before fields are read.
  void gather() const;
  /// Throws StabilityError when a module is out of bounds.
  void guard();

  const Clock& clock() const { return clock_; }
  const Parts& parts() const { return *parts_; }
  /// Null where the case gives the intervals.
  const IntervalChooser* chooser() const { return chooser_ ? &*chooser_ : nullptr; }
  /// Lattice-node updates of one step, all fields together, for MLUPS.
  double updates_per_step() const;
  LimitTable limits() const;
  /// The tasks of a step, in their order.
  std::vector<Task> schedule() const;
  Ledger ledger() const;
  /// A row of history.csv for the present: time, step, the numbers of the modules, the balances.
  std::vector<HistoryValue> history() const;
  FieldList fields() const;

  /// Everything that a restart needs, after any step. Called by all ranks, which all save and load all blocks.
  StateList state();
  /// Restores a state. `load` is called with several lists of blocks, one after the other, because room for a grown
  /// list of fluid nodes must be made first. Throws FileError for numbers that are impossible in this scene.
  void restore(const std::function<void(StateList&)>& load);

 private:
  StateList geometry_state();
  /// Gives back the memory of what other ranks compute, after something has filled it.
  void give_back();
  /// Called before a step. Where a look is due, it determines how fast things change, and the modules use the intervals
  /// that follow from it.
  void choose_intervals();
  /// The present intervals.
  Intervals intervals() const;
  void require_possible(const Kokkos::View<NodeType*>& type, const IndexList& node) const;

  Exec exec_;
  Scene scene_;
  Clock clock_;
  int update_interval_;
  std::unique_ptr<Parts> parts_;
  std::optional<IntervalChooser> chooser_;
  mutable bool whole_ = false;                ///< no step since the last gather()
  int fluid_count_ = 0, fluid_capacity_ = 0;  ///< as read from a checkpoint
};

}  // namespace vug
