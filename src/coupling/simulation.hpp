#pragma once
// The loop over time: modules in their order, growth of the pores at its interval.
#include "coupling/build_modules.hpp"
#include "coupling/clock.hpp"
#include "coupling/interval_chooser.hpp"

namespace vug {

/// A scene in motion. Knows nothing of files: `run.hpp` writes what it offers.
class Simulation {
 public:
  /// The ranks share the work: all of them make one of the same scene and call the same functions of it.
  explicit Simulation(const Scene& scene, const Ranks& ranks = {});

  /// Brings all modules to time zero (tectonic preload). Not called when a checkpoint is loaded instead.
  void begin();
  /// One lattice step; what a module has put off then is done by catch_up().
  void step();
  /// Brings all modules to now: before parts(), or fields listed earlier, are looked at. All that follows here does it.
  void catch_up() const;
  /// Brings each rank what others hold for it: to be called by all before fields are read.
  void gather() const;
  /// Throws StabilityError when a module has left its bounds.
  void guard();

  const Clock& clock() const { return clock_; }
  const Parts& parts() const { return *parts_; }
  /// Null where the case gives the intervals.
  const IntervalChooser* chooser() const { return chooser_ ? &*chooser_ : nullptr; }
  /// Lattice-node updates of one step, all fields together, for MLUPS.
  double updates_per_step() const;
  LimitTable limits() const;
  /// What a step does, in its order.
  std::vector<Task> schedule() const;
  Ledger ledger() const;
  /// One row of history.csv at this moment: time, step, what the modules say, the balances.
  std::vector<HistoryValue> history() const;
  FieldList fields() const;

  /// Everything a restart needs, after any step. Called by all ranks, which save and load all blocks alike.
  StateList state();
  /// Takes a state over, from `load`, which is called with one list of blocks after the other: it makes room for a
  /// grown list of fluid nodes first. Throws FileError for numbers that no state of this scene can have.
  void restore(const std::function<void(StateList&)>& load);

 private:
  StateList geometry_state();
  /// The memory of what other ranks compute, once something has filled it.
  void give_back();
  /// Before a step: where a look is due, sees how fast things change, and has the modules go on with the intervals that
  /// follow from it.
  void choose_intervals();
  /// Those that hold now.
  Intervals intervals() const;
  void require_possible(const Kokkos::View<NodeType*>& type, const IndexList& node) const;

  Exec exec_;
  Scene scene_;
  Clock clock_;
  int update_interval_;
  std::unique_ptr<Parts> parts_;
  std::optional<IntervalChooser> chooser_;
  mutable bool whole_ = false;                ///< no step since it was gathered
  int fluid_count_ = 0, fluid_capacity_ = 0;  ///< as read from a checkpoint
};

}  // namespace vug
