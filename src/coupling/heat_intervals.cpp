// The heat with intervals that are chosen during the run (accuracy.tolerance).
#include "coupling/amount_share.hpp"
#include "coupling/heat_module.hpp"
#include "kernels/launch/launch.hpp"
#include "kernels/scalar/turning.hpp"

#include <algorithm>

namespace vug {

template <class T>
void HeatModule<T>::set_interval(int interval) {
  interval_ = interval;
  if (carrier_) flow_->set_interval(*carrier_, interval);
  for (std::size_t s = 0; s < sides_.size(); ++s) sides_[s].transfer = transfer_of(stretches_[s].conditions.heat);
  for (std::size_t o = 0; o < openings_.size(); ++o)
    openings_[o].transfer = transfer_of(geometry_.openings[o].conditions.heat);
}

template <class T>
double HeatModule<T>::turn(double stretch) {
  const HeatParameters before = parameters();
  set_heat_rates(before, stretch, fields_);
  set_interval(next_interval_);
  return turning(0.5 + before.fluid_diffusivity / c_s2, stretch).carried;
}

template <class T>
void HeatModule<T>::bound(std::optional<double> speed, Intervals& most) const {
  if (section_.velocity_set != ScalarVelocitySet::d2q5) {
    most.heat = 1;  // turning.hpp
    return;
  }
  double taken = carrier_ ? speed.value_or(fastest_) / longest_way : 0;
  const auto take = [&](double diffusivity) {
    taken = std::max(taken, 3 * diffusivity / units_.diffusivity() / (largest_relaxation_time - 0.5));
  };
  take(section_.fluid_diffusivity);
  take(section_.solid_diffusivity);
  for (const Mineral& mineral : minerals_) take(mineral.diffusivity);
  most.heat = stable_interval(most.heat, taken);
}

template <class T>
void HeatModule<T>::watch(const Exec& exec, const Clock&, Changes& changes) {
  const ScalarField<double> change("vug::heat::change", geometry_.lattice.ny),
      amount("vug::heat::amount", geometry_.lattice.ny);
  add_temperature_change(exec, fields_, watched_, change, amount);
  const Split& split = geometry_.split;
  for (const ScalarField<double>& sums : {change, amount})
    if (!split.alone()) split.make_whole(split.of_rows(), sums);
  changes.heat = amount_share(sum_in_order(change), sum_in_order(amount));
}

template <class T>
void HeatModule<T>::take(const Exec&, const Intervals& intervals) {
  next_interval_ = intervals.heat;
  update_interval_ = intervals.update;
}

template <class T>
void HeatModule<T>::resume(const Exec& exec, const Intervals& intervals) {
  take(exec, intervals);
  set_interval(intervals.heat);
  set_heat_rates(parameters(), 1, fields_);
}

#define VUG_INSTANTIATE(T)                                                     \
  template void HeatModule<T>::set_interval(int);                              \
  template double HeatModule<T>::turn(double);                                 \
  template void HeatModule<T>::bound(std::optional<double>, Intervals&) const; \
  template void HeatModule<T>::watch(const Exec&, const Clock&, Changes&);     \
  template void HeatModule<T>::take(const Exec&, const Intervals&);            \
  template void HeatModule<T>::resume(const Exec&, const Intervals&);
VUG_FOR_NUMBERS(VUG_INSTANTIATE)
#undef VUG_INSTANTIATE

}  // namespace vug
