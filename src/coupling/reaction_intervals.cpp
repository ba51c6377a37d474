// The reactions where intervals are chosen during the run (accuracy.tolerance).
#include "coupling/amount_share.hpp"
#include "coupling/reaction_module.hpp"

#include <algorithm>
#include <cmath>

namespace vug {

template <class T, class Set>
void ReactionModule<T, Set>::bound(std::optional<double>, Intervals& most) const {
  if (section_.wall != ReactiveWallLaw::kinetic) most.solute = 1;  // the paper's law is for one fixed diffusivity
}

template <class T, class Set>
void ReactionModule<T, Set>::watch(const Exec&, const Clock&, Changes& changes) {
  gather_links();
  for (Attack<T>& attack : attacks_) {  // acid that reacts in a step of the solutes is booked at its beginning
    const double reacted = consumed(attack);
    changes.solute =
        std::max(changes.solute, amount_share(std::abs(reacted - attack.watched), solutes_.total(*attack.reactant)));
    if (attack.product) {  // and given to the product there, which may leave sooner than it is made
      double yield = has_minerals() ? 0 : attack.rate.product_yield();
      for (const RateLaw& rate : attack.rates) yield = std::max(yield, rate.product_yield());
      changes.solute = std::max(
          changes.solute, amount_share(yield * std::abs(reacted - attack.watched), solutes_.total(*attack.product)));
    }
    attack.watched = reacted;
  }
  if (!dissolves_) return;
  const double paid = this->paid();
  changes.solid = amount_share(std::abs(paid - watched_), std::abs(paid));
  watched_ = paid;
}

template <class T, class Set>
void ReactionModule<T, Set>::take(const Exec& exec, const Intervals& intervals) {
  if (intervals.solute != solute_interval_) refreshed_ = -1;  // rates must not be extrapolated from another interval
  resume(exec, intervals);
}

template <class T, class Set>
void ReactionModule<T, Set>::resume(const Exec&, const Intervals& intervals) {
  wall_interval_ = intervals.wall;
  solute_interval_ = intervals.solute;
  for (Attack<T>& attack : attacks_) set_volumes(attack);  // including the rates of minerals
}

#define VUG_INSTANTIATE(T, Set)                                                         \
  template void ReactionModule<T, Set>::bound(std::optional<double>, Intervals&) const; \
  template void ReactionModule<T, Set>::watch(const Exec&, const Clock&, Changes&);     \
  template void ReactionModule<T, Set>::take(const Exec&, const Intervals&);            \
  template void ReactionModule<T, Set>::resume(const Exec&, const Intervals&);
VUG_FOR_NUMBERS_AND_SETS(VUG_INSTANTIATE)
#undef VUG_INSTANTIATE

}  // namespace vug
