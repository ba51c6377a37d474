// The mechanics on several ranks: which rank sums forces and takes mean temperatures.
#include "coupling/mechanics_module.hpp"

#include <vector>

namespace vug {

/// The force on a triangle is summed by the rank of the fluid at its first link, for the rank that moves the triangle,
/// and for those that move its neighbours, which take it over when the triangle is gone (handed_push.hpp). A triangle
/// without links has no force, on any rank.
template <class T>
void MechanicsModule<T>::share_links() {
  const Split& split = geometry_.split;
  const auto first_link = on_host(links_.first), slot = on_host(links_.slot);
  const auto neighbour = on_host(neighbours_);
  const auto needed = [&](int g) {
    bool ours = mechanics_.moves(g);
    for (int k = 0; k < 3; ++k)
      ours = ours || (dissolved_ && neighbour(g, k) >= 0 && mechanics_.moves(neighbour(g, k)));
    return ours;
  };
  std::vector<int> ours, slots, others, owners;
  for (int g = 0; g < links_.groups(); ++g) {
    const int first = first_link(g), last = first_link(g + 1);
    const int owner = first < last ? split.owner_of(slot(first) % geometry_.fluid.capacity) : split.ranks().rank();
    if (owner == split.ranks().rank()) {
      ours.push_back(g);
      for (int k = first; k < last; ++k) slots.push_back(slot(k));
    } else if (needed(g)) {
      others.push_back(g);
      owners.push_back(owner);
    }
  }
  our_triangles_ = to_device<IndexList>("vug::mechanics::our_triangles", ours);
  walls_ = split.slots(geometry_.fluid, slots);
  forces_ = Halo(split.ranks(), others, owners);
}

/// The mean temperature of a triangle is taken by the rank that has the row of its first node.
template <class T>
void MechanicsModule<T>::share_temperatures() {
  const Split& split = geometry_.split;
  const NodeGroups& groups = thermal_.of_particle;
  const auto offset = on_host(groups.offset), first = on_host(groups.first), length = on_host(groups.length);
  std::vector<int> owner(groups.count(), 0), ours, nodes;
  for (int p = 0; p < groups.count(); ++p) {
    const int begin = offset(p), end = offset(p + 1);
    if (begin < end) owner[p] = split.rows().part_of(geometry_.lattice.y(first(begin)));
    if (owner[p] != split.ranks().rank()) continue;
    ours.push_back(p);
    for (int r = begin; r < end; ++r)
      for (int n = first(r); n < first(r) + length(r); ++n) nodes.push_back(n);
  }
  our_warmed_ = to_device<IndexList>("vug::mechanics::our_warmed", ours);
  of_warmed_ = owners_of(owner, split.ranks().size());
  temperatures_ = split.beyond_rows(geometry_.lattice, nodes);
}

template void MechanicsModule<float>::share_links();
template void MechanicsModule<double>::share_links();
template void MechanicsModule<float>::share_temperatures();
template void MechanicsModule<double>::share_temperatures();

}  // namespace vug
