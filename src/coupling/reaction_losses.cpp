// Whether the walls are looked at often enough: a node that loses more rock than it has takes the rest from its
// neighbours, and where there are none, rock dissolves that was not there.
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
std::vector<Concern> ReactionModule<T, Set>::concerns(const Exec& exec) const {
  const Surface& surface = geometry_.surface;
  if (!dissolves_) return {};
  gather_links();
  const ScalarField<double> waiting("vug::reaction::waiting_loss", surface.count);
  for (const Attack<T>& attack : attacks_) add_losses(exec, surface, attack.wall, attack.links, waiting);
  double largest = field_range(exec, waiting, surface.count).max;  // the next look may be far away
  largest =
      std::max(largest, field_range(exec, wall_losses_.largest, static_cast<int>(wall_losses_.largest.extent(0))).max);
  const std::string advice =
      watches_ ? "lower accuracy.tolerance" : "lower accuracy.update_interval or lattice.time_step";
  std::vector<Concern> concerns;
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

#define VUG_INSTANTIATE(T, Set)                                                 \
  template void ReactionModule<T, Set>::make_room_for_losses(const Exec& exec); \
  template double ReactionModule<T, Set>::overdrawn_share() const;              \
  template std::vector<Concern> ReactionModule<T, Set>::concerns(const Exec& exec) const;
VUG_FOR_NUMBERS_AND_SETS(VUG_INSTANTIATE)
#undef VUG_INSTANTIATE

}  // namespace vug
