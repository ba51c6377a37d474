#pragma once
// The loop over time: modules in their order, growth of the pores at its interval.
#include "coupling/build_modules.hpp"
#include "coupling/clock.hpp"

namespace vug {

/// A scene in motion. Knows nothing of files: `run.hpp` writes what it offers.
class Simulation {
 public:
  explicit Simulation(const Scene& scene);

  /// Brings all modules to time zero (tectonic preload). Not called when a checkpoint is loaded instead.
  void begin();
  /// One lattice step.
  void step();
  /// Throws StabilityError when a module has left its bounds.
  void guard();

  const Clock& clock() const { return clock_; }
  const Parts& parts() const { return *parts_; }
  /// Lattice-node updates of one step, all fields together, for MLUPS.
  double updates_per_step() const;
  LimitTable limits() const;
  Ledger ledger() const;
  /// One row of history.csv at this moment: time, step, what the modules say, the balances.
  std::vector<HistoryValue> history() const;
  FieldList fields() const;

  /// True where a checkpoint may be taken: right after an update of the pores.
  bool may_checkpoint() const { return clock_.step % update_interval_ == 0; }
  /// Everything a restart needs; `restore` makes room for a grown list of fluid nodes first.
  StateList state();
  void restore(const std::function<void(StateList&)>& load);

 private:
  StateList geometry_state();

  Exec exec_;
  Scene scene_;
  Clock clock_;
  int update_interval_;
  std::unique_ptr<Parts> parts_;
  int fluid_count_ = 0, fluid_capacity_ = 0;  ///< as read from a checkpoint
};

}  // namespace vug
