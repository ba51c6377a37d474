// The solutes with intervals that are chosen during the run (accuracy.tolerance).
#include "coupling/amount_share.hpp"
#include "coupling/solute_module.hpp"
#include "kernels/launch/launch.hpp"

#include <algorithm>

namespace vug {

template <class T, class Set>
void SoluteModule<T, Set>::set_interval(int interval) {
  interval_ = interval;
  if (carrier_) flow_->set_interval(*carrier_, interval);
}

template <class T, class Set>
void SoluteModule<T, Set>::turn(const Exec& exec) {
  const double stretch = static_cast<double>(next_interval_) / interval_;
  for (SpeciesState<T>& s : species_) s.parameters = turning_parameters(s.parameters, stretch);
  set_interval(next_interval_);
  sweep(exec);
  for (SpeciesState<T>& s : species_) s.parameters = parameters_of(s.section);
}

template <class T, class Set>
void SoluteModule<T, Set>::bound(std::optional<double> speed, Intervals& most) const {
  if (Set::Q != D2Q5::Q || section_.relaxation_time || section_.face_exchange) {
    most.solute = 1;  // turning.hpp
    return;
  }
  double taken = carrier_ ? speed.value_or(fastest_) / longest_way_of_solutes : 0;
  for (const SpeciesState<T>& s : species_)
    taken = std::max(taken, s.section.diffusivity / units_.diffusivity() / largest_diffusivity_of_solutes);
  most.solute = stable_interval(most.solute, taken);
}

template <class T, class Set>
void SoluteModule<T, Set>::watch(const Exec& exec, const Clock&, Changes& changes) {
  const FluidNodes& fluid = geometry_.fluid;
  for (const SpeciesState<T>& s : species_) {
    const ScalarField<double> change("vug::solute::change", block_count(fluid.capacity));
    add_change<T>(exec, fluid, s.fields.C, compared_, s.watched, change);
    geometry_.split.make_whole(geometry_.split.of_blocks(), change);
    changes.solute = std::max(changes.solute, amount_share(sum_in_order(change), total(s)));
  }
  compared_ = fluid.count;
}

template <class T, class Set>
void SoluteModule<T, Set>::take(const Exec&, const Intervals& intervals) {
  next_interval_ = intervals.solute;
}

template <class T, class Set>
void SoluteModule<T, Set>::resume(const Exec& exec, const Intervals& intervals) {
  take(exec, intervals);
  set_interval(intervals.solute);
  for (SpeciesState<T>& s : species_) s.parameters = parameters_of(s.section);
}

#define VUG_INSTANTIATE(T, Set)                                                       \
  template void SoluteModule<T, Set>::set_interval(int);                              \
  template void SoluteModule<T, Set>::turn(const Exec&);                              \
  template void SoluteModule<T, Set>::bound(std::optional<double>, Intervals&) const; \
  template void SoluteModule<T, Set>::watch(const Exec&, const Clock&, Changes&);     \
  template void SoluteModule<T, Set>::take(const Exec&, const Intervals&);            \
  template void SoluteModule<T, Set>::resume(const Exec&, const Intervals&);
VUG_FOR_NUMBERS_AND_SETS(VUG_INSTANTIATE)
#undef VUG_INSTANTIATE

}  // namespace vug
