// What a run warns of. Whether the walls are looked at often enough: a node that loses more rock than it has takes the
// rest from its neighbours, and where there are none, rock dissolves that was not there. And whether Arrhenius' law is
// asked for rates beyond its range.
#include "coupling/reaction_module.hpp"
#include "kernels/flow/guards.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace vug {

namespace {

constexpr double negligible = 1e-3;  // share of the dissolved rock

}  // namespace

template <class T, class Set>
void ReactionModule<T, Set>::make_room_for_losses(const Exec& exec) {
  const Surface& surface = geometry_.surface;
  if (static_cast<int>(wall_losses_.recent.extent(0)) >= surface.count) return;
  if (wall_losses_.recent.extent(0) == 0)
    wall_losses_ = {ScalarField<double>("vug::reaction::recent_loss", 0),
                    ScalarField<double>("vug::reaction::largest_loss", 0)};
  Kokkos::resize(exec, wall_losses_.recent, surface.node.extent(0));
  Kokkos::resize(exec, wall_losses_.largest, surface.node.extent(0));
}

template <class T, class Set>
std::vector<Concern> ReactionModule<T, Set>::concerns_of_rates(const Exec& exec) const {
  const auto is_activated = [](const RateLaw& rate) { return rate.activation_energy > 0; };
  const bool activated = std::any_of(attacks_.begin(), attacks_.end(), [&](const Attack<T>& attack) {
    return is_activated(attack.rate) || std::any_of(attack.rates.begin(), attack.rates.end(), is_activated);
  });
  if (!activated || !heat_ || !heat_->may_leave_range()) return {};
  const HeatExtremes seen = heat_->extremes(exec);
  const double lowest = seen.lowest + units_.reference_temperature,
               highest = seen.highest + units_.reference_temperature;
  const bool cold = lowest < coldest_reaction && heat_->range().coldest >= coldest_reaction;
  const bool hot = highest > hottest_reaction && heat_->range().hottest <= hottest_reaction;
  if (!cold && !hot) return {};
  return {{fmt::format("temperatures outside {:g} to {:g} K", coldest_reaction, hottest_reaction),
           fmt::format(" ({:.4g} to {:.4g} K): at walls as cold or hot the reaction has the rate of the nearest end",
                       lowest, highest)}};
}

template <class T, class Set>
std::vector<Concern> ReactionModule<T, Set>::concerns(const Exec& exec) const {
  std::vector<Concern> concerns = concerns_of_rates(exec);
  const Surface& surface = geometry_.surface;
  if (!dissolves_) return concerns;
  gather_links();
  const ScalarField<double> waiting("vug::reaction::waiting_loss", surface.count);
  for (const Attack<T>& attack : attacks_) add_losses(exec, surface, attack.wall, attack.links, waiting);
  double largest = field_range(exec, waiting, surface.count).max;  // the next look may be far away
  largest =
      std::max(largest, field_range(exec, wall_losses_.largest, static_cast<int>(wall_losses_.largest.extent(0))).max);
  const std::string advice =
      watches_ ? "lower accuracy.tolerance" : "lower accuracy.update_interval or lattice.time_step";
  if (largest > 1)
    concerns.push_back({"a wall node has lost more rock between two looks than a cell holds",
                        fmt::format(" ({:.2g} cells): the surface follows too late; {}", largest, advice)});
  const double share = overdrawn_share();
  if (share > negligible)
    concerns.push_back(
        {"more rock has dissolved than there was", fmt::format(" ({:.2g} % so far): {}", 100 * share, advice)});
  return concerns;
}

template <class T, class Set>
double ReactionModule<T, Set>::overdrawn_share() const {
  const double left = with_dissolving(sum_in_order(geometry_.volume), -1);
  const double overdrawn = std::max(0.0, -left) - sum_in_order(lost_);
  const double dissolved = with_dissolving(sum_in_order(geometry_.dissolved), 1);
  return dissolved > 0 ? overdrawn / dissolved : 0;
}

#define VUG_INSTANTIATE(T, Set)                                                                    \
  template void ReactionModule<T, Set>::make_room_for_losses(const Exec& exec);                    \
  template double ReactionModule<T, Set>::overdrawn_share() const;                                 \
  template std::vector<Concern> ReactionModule<T, Set>::concerns_of_rates(const Exec& exec) const; \
  template std::vector<Concern> ReactionModule<T, Set>::concerns(const Exec& exec) const;
VUG_FOR_NUMBERS_AND_SETS(VUG_INSTANTIATE)
#undef VUG_INSTANTIATE

}  // namespace vug
