// What a run warns of. Whether the walls are looked at often enough: a node that loses more rock than it has takes the
// rest from its neighbours, and where there are none, rock dissolves that was not there. And whether Arrhenius' law is
// asked for rates beyond its range.
#include "coupling/face_temperature.hpp"
#include "coupling/reaction_module.hpp"
#include "kernels/flow/guards.hpp"
#include "kernels/launch/own_items.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

namespace vug {

namespace {

constexpr double negligible = 1e-3;  // share of the dissolved rock

/// Lowest and highest temperature (K) of the faces at which a rate depends on it.
template <class T, class Set>
struct WallTemperatures {
  OwnItems own;
  ReactiveLinks<T> links;
  MineralRates minerals;
  bool activated;  ///< the rate of all rock; where there are minerals, theirs count
  IndexList surface, fluid;
  int capacity;
  FaceTemperature<T> temperature;

  KOKKOS_FUNCTION void operator()(int place, double& lowest, double& highest) const {
    const int l = own(place);
    if (l < 0) return;
    const int solid = surface(links.surface_of(l));
    const bool counts =
        minerals.given() ? minerals.at(solid).k0 > 0 && minerals.at(solid).activation_temperature > 0 : activated;
    if (!counts) return;
    const double kelvin = temperature(solid, fluid(links.slot(l) - Set::opposite(links.direction_of(l)) * capacity));
    lowest = kelvin < lowest ? kelvin : lowest;
    highest = kelvin > highest ? kelvin : highest;
  }
};

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
  if (!heat_ || !heat_->may_leave_range()) return {};
  double coldest = std::numeric_limits<double>::infinity(), hottest = -coldest;
  const FaceTemperature<T> temperature = heat_->face_temperature(exec, temperatures_);
  for (const Attack<T>& attack : attacks_) {
    double lowest, highest;
    const WallTemperatures<T, Set> faces{
        {attack.links.share()},   attack.links,
        attack.wall.minerals,     attack.rate.rate_constant > 0 && attack.rate.activation_energy > 0,
        geometry_.surface.node,   geometry_.fluid.node,
        geometry_.fluid.capacity, temperature};
    Kokkos::parallel_reduce("vug::reaction::wall_temperatures", Kokkos::RangePolicy<Exec>(exec, 0, faces.own.places()),
                            faces, Kokkos::Min<double>(lowest), Kokkos::Max<double>(highest));
    coldest = std::min(coldest, lowest);
    hottest = std::max(hottest, highest);
  }
  coldest = geometry_.split.ranks().least(coldest);
  hottest = geometry_.split.ranks().most(hottest);
  std::vector<Concern> concerns;
  if (coldest < coldest_reaction && heat_->range().coldest >= coldest_reaction)
    concerns.push_back(
        {fmt::format("a wall reacts that is colder than {:g} K", coldest_reaction),
         fmt::format(" ({:.4g} K): beyond the range of Arrhenius' law it does so as at its end", coldest)});
  if (hottest > hottest_reaction && heat_->range().hottest <= hottest_reaction)
    concerns.push_back(
        {fmt::format("a wall reacts that is hotter than {:g} K", hottest_reaction),
         fmt::format(" ({:.4g} K): beyond the range of Arrhenius' law it does so as at its end", hottest)});
  return concerns;
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
