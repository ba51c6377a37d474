#pragma once
// A steady flow is held: it is not computed again until the pores change.
#include "coupling/clock.hpp"
#include "io/field_list.hpp"
#include "kernels/flow/guards.hpp"

#include <algorithm>
#include <cmath>

namespace vug {

/// What has entered through sides and openings between two looks, lattice units.
struct Crossed {
  double net = 0;       ///< gain of the pores
  double all = 0;       ///< sum of the absolute gains of all sides and openings
  double rounding = 0;  ///< of net
};

/// Checks at intervals ("looks") whether the velocity still changes. Costs nothing at tolerance 0.
template <class T>
class SteadyFlow {
 public:
  SteadyFlow() = default;
  /// The flow is held when three shares are at most `tolerance`: the largest change c_k of velocity between two looks,
  /// over the velocity there, or over the largest where it is less than `tolerance` of that (velocity_change); the sum
  /// of the changes to come when they continue to shrink like the last two, c_k^2/(c_(k-1) - c_k); and the net gain of
  /// the pores over what crosses their boundaries. It is not held before two looks have seen the flow under the final
  /// values of all boundaries, which these have from `earliest` (s) on. Looks every `interval` lattice steps.
  SteadyFlow(double tolerance, double earliest, int interval)
      : tolerance_(tolerance), earliest_(earliest), interval_(interval) {}

  bool on() const { return tolerance_ > 0; }
  int interval() const { return interval_; }  ///< lattice steps between looks
  bool held() const { return held_; }
  /// Whether the flow has stopped changing to within the tolerance, whether or not the pores are new.
  bool settled() const { return held_ || (change_ <= tolerance_ && left_ <= tolerance_ && balanced_); }
  /// Whether to look now.
  bool due(const Clock& clock) const { return on() && !held_ && clock.step % interval_ == 0; }
  /// Lattice steps for which the flow has been held so far.
  std::int64_t held_steps() const { return held_steps_; }
  /// Lattice steps for which the flow has been held since the last look.
  std::int64_t age() const { return age_; }

  /// Called for every lattice step in which the flow is held.
  void pass() {
    ++held_steps_;
    ++age_;
  }
  /// To be called when the pores have changed; `capacity` is the present one of the fluid nodes.
  void wake(const Exec& exec, int capacity) {
    if (!on()) return;
    held_ = false;
    looks_ = 0;
    Kokkos::resize(exec, previous_, capacity, 2);
  }
  /// Looks; to be called only when due. Waits for the device. `largest` is the largest speed, `noise` the share of it
  /// that is rounding: a change of at most this size counts as none, whatever the tolerance.
  void look(const Exec& exec, const Clock& clock, const FluidNodes& nodes, const VectorField<T>& u, double largest,
            double noise, const Crossed& crossed) {
    const double before = change_;
    change_ = velocity_change(exec, nodes, u, previous_, {largest, tolerance_, noise});
    if (change_ == 0)
      left_ = 0;
    else
      left_ = looks_ == most_looks && before > change_ ? std::min(change_ * change_ / (before - change_), all) : all;
    balanced_ = std::abs(crossed.net) <= tolerance_ * crossed.all + crossed.rounding;
    held_ = looks_ > 0 && settled() && (earliest_ == 0 || clock.time() >= earliest_ + unseen(clock));
    looks_ = std::min(looks_ + 1, most_looks);
    age_ = 0;
  }
  void state(StateList& list) {
    if (!on()) return;
    list.add("flow/steady/previous", previous_);
    list.add_value("flow/steady/looks", looks_, {0, most_looks});
    list.add_value("flow/steady/change", change_);
    list.add_value("flow/steady/left", left_, {0, all});
    list.add_value("flow/steady/balanced", balanced_);
    list.add_value("flow/steady/held", held_);
    list.add_value("flow/steady/age", age_, {0, most_steps});
    list.add_value("flow/steady/held_steps", held_steps_, {0, most_steps});
  }

 private:
  /// Time from the final values of boundaries to a look at which the look before has seen them too: a step uses the
  /// values at its beginning, and the two after it still feel a jump (without_alternation).
  double unseen(const Clock& clock) const { return (interval_ + 3) * clock.time_step; }

  static constexpr int most_looks = 2;
  static constexpr double all = 2;  ///< more than any tolerance

  double tolerance_ = 0, earliest_ = 0;
  int interval_ = 1;
  bool held_ = false;
  double change_ = 1;      ///< at the last look
  double left_ = all;      ///< sum of changes to come, at the last look
  bool balanced_ = false;  ///< as much left as entered, at the last look
  int looks_ = 0;          ///< at the present pores: from 1 on, previous_ is valid; at 2, change_ as well
  std::int64_t age_ = 0, held_steps_ = 0;
  VectorField<T> previous_{"vug::flow::steady::previous", 0};  ///< (fluid, axis) velocity at the last look
};

}  // namespace vug
