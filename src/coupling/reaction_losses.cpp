// Whether the walls are looked at often enough: between two looks, a node must not lose more rock than it has.
#include "coupling/reaction_module.hpp"
#include "kernels/flow/guards.hpp"
#include "kernels/launch/launch.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace vug {

namespace {

/// largest(s) = max(largest(s), loss(s)); loss(s) = 0.
struct KeepLargest {
  ScalarField<double> loss, largest;
  KOKKOS_FUNCTION void operator()(int s) const {
    if (loss(s) > largest(s)) largest(s) = loss(s);
    loss(s) = 0;
  }
};

}  // namespace

template <class T, class Set>
void ReactionModule<T, Set>::make_room_for_losses(const Exec& exec) {
  const Surface& surface = geometry_.surface;
  if (static_cast<int>(recent_.extent(0)) >= surface.count) return;
  Kokkos::resize(exec, recent_, surface.node.extent(0));
  Kokkos::resize(exec, largest_, surface.node.extent(0));
}

template <class T, class Set>
void ReactionModule<T, Set>::keep_largest_losses(const Exec& exec) {
  const Surface& surface = geometry_.surface;
  for (const Attack<T>& attack : attacks_) add_losses(exec, surface, attack.wall, attack.links, recent_);
  for_each_node(exec, "vug::reaction::keep_largest_loss", surface.count, KeepLargest{recent_, largest_});
}

template <class T, class Set>
std::vector<Concern> ReactionModule<T, Set>::concerns(const Exec& exec) const {
  const Surface& surface = geometry_.surface;
  if (!dissolves_ || surface.count == 0) return {};
  gather_links();
  const ScalarField<double> waiting("vug::reaction::waiting_loss", surface.count);
  for (const Attack<T>& attack : attacks_) add_losses(exec, surface, attack.wall, attack.links, waiting);
  double largest = field_range(exec, waiting, surface.count).max;  // the next look may be far away
  largest = std::max(largest, field_range(exec, largest_, static_cast<int>(largest_.extent(0))).max);
  if (largest <= 1) return {};
  return {{"a wall node has lost more rock between two looks than a cell holds",
           fmt::format(" ({:.2g} cells), and more has dissolved than there was: lower {}", largest,
                       watches_ ? "accuracy.tolerance" : "accuracy.update_interval or lattice.time_step")}};
}

#define VUG_INSTANTIATE(T, Set)                                                 \
  template void ReactionModule<T, Set>::make_room_for_losses(const Exec& exec); \
  template void ReactionModule<T, Set>::keep_largest_losses(const Exec& exec);  \
  template std::vector<Concern> ReactionModule<T, Set>::concerns(const Exec& exec) const;
VUG_FOR_NUMBERS_AND_SETS(VUG_INSTANTIATE)
#undef VUG_INSTANTIATE

}  // namespace vug
