#pragma once
// When the flow is steady it is held: not computed again until the pores change.
#include "coupling/clock.hpp"
#include "io/field_list.hpp"
#include "kernels/flow/guards.hpp"

namespace vug {

/// Looks every so many lattice steps whether the velocity still changes. Costs nothing at tolerance 0.
template <class T>
class SteadyFlow {
 public:
  SteadyFlow() = default;
  /// Holds when the largest change of velocity between two looks, over the largest velocity, is at most `tolerance`,
  /// and not before `earliest` (s), when the last pressure has been raised. Looks every `interval` lattice steps.
  SteadyFlow(double tolerance, double earliest, int interval)
      : tolerance_(tolerance), earliest_(earliest), interval_(interval) {}

  bool on() const { return tolerance_ > 0; }
  bool held() const { return held_; }
  /// Whether it has stopped changing as far as is asked for, new pores or not.
  bool settled() const { return held_ || change_ <= tolerance_; }
  /// Lattice steps for which the flow has been held so far.
  std::int64_t held_steps() const { return held_steps_; }
  /// Lattice steps since it was held last.
  std::int64_t age() const { return age_; }

  /// Called for every lattice step in which the flow is held.
  void pass() {
    ++held_steps_;
    ++age_;
  }
  /// The pores have changed; `capacity` is that of the fluid nodes now.
  void wake(const Exec& exec, int capacity) {
    if (!on()) return;
    held_ = comparable_ = false;
    Kokkos::resize(exec, previous_, capacity, 2);
  }
  /// Waits for the device at every look. `noise` is the share of the velocity that is rounding: what changes by no more
  /// does not change, whatever the tolerance.
  void look(const Exec& exec, const Clock& clock, const FluidNodes& nodes, const VectorField<T>& u, double noise) {
    if (!on() || held_ || clock.step % interval_ != 0) return;
    change_ = velocity_change(exec, nodes, u, previous_);
    if (change_ <= noise) change_ = 0;
    held_ = change_ <= tolerance_ && comparable_ && clock.time() >= earliest_;
    comparable_ = true;
    age_ = 0;
  }
  void state(StateList& list) {
    if (!on()) return;
    list.add("flow/steady/previous", previous_);
    list.add_value("flow/steady/comparable", comparable_);
    list.add_value("flow/steady/change", change_);
    list.add_value("flow/steady/held", held_);
    list.add_value("flow/steady/age", age_, {0, most_steps});
    list.add_value("flow/steady/held_steps", held_steps_, {0, most_steps});
  }

 private:
  double tolerance_ = 0, earliest_ = 0;
  int interval_ = 1;
  bool held_ = false;
  double change_ = 1;        ///< at the last look
  bool comparable_ = false;  ///< previous_ is of these pores
  std::int64_t age_ = 0, held_steps_ = 0;
  VectorField<T> previous_{"vug::flow::steady::previous", 0};  ///< (fluid, axis) velocity at the last look
};

}  // namespace vug
