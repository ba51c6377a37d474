// Whether the walls are looked at often enough: between two looks, a node must not lose more rock than it has.
#include "coupling/reaction_module.hpp"
#include "kernels/flow/guards.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace vug {

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
  if (!dissolves_ || surface.count == 0) return {};
  gather_links();
  const ScalarField<double> waiting("vug::reaction::waiting_loss", surface.count);
  for (const Attack<T>& attack : attacks_) add_losses(exec, surface, attack.wall, attack.links, waiting);
  double largest = field_range(exec, waiting, surface.count).max;  // the next look may be far away
  largest =
      std::max(largest, field_range(exec, wall_losses_.largest, static_cast<int>(wall_losses_.largest.extent(0))).max);
  if (largest <= 1) return {};
  return {{"a wall node has lost more rock between two looks than a cell holds",
           fmt::format(" ({:.2g} cells), and more has dissolved than there was: lower {}", largest,
                       watches_ ? "accuracy.tolerance" : "accuracy.update_interval or lattice.time_step")}};
}

#define VUG_INSTANTIATE(T, Set)                                                 \
  template void ReactionModule<T, Set>::make_room_for_losses(const Exec& exec); \
  template std::vector<Concern> ReactionModule<T, Set>::concerns(const Exec& exec) const;
VUG_FOR_NUMBERS_AND_SETS(VUG_INSTANTIATE)
#undef VUG_INSTANTIATE

}  // namespace vug
