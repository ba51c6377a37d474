// What ranks share of the reaction at the walls: each knows how fast the links of its own fluid nodes react.
#include "coupling/reaction_module.hpp"

#include <algorithm>

namespace vug {

namespace {

/// Numbers of the marked blocks. The list has at least one entry, because an empty one would mean all.
IndexList numbers_of(const std::vector<bool>& marked, int& count) {
  count = static_cast<int>(std::count(marked.begin(), marked.end(), true));
  std::vector<int> numbers;
  for (std::size_t b = 0; b < marked.size(); ++b)
    if (marked[b]) numbers.push_back(static_cast<int>(b));
  numbers.resize(std::max(count, 1));
  return to_device<IndexList>("vug::reaction::own_blocks", numbers);
}

}  // namespace

/// Links and surface are shared out in whole blocks, some of which two ranks compute alike.
template <class T, class Set>
void ReactionModule<T, Set>::share_links() {
  const FluidNodes& fluid = geometry_.fluid;
  if (fluid.own_count < 0) return;
  const auto own_nodes = on_host(fluid.own_blocks), node_of = on_host(fluid.node);
  const auto surface_node = on_host(geometry_.surface.node);
  std::vector<bool> surface(block_count(geometry_.surface.count), false);
  std::vector<int> nodes;
  for (Attack<T>& attack : attacks_) {
    ReactiveLinks<T>& links = attack.links;
    const auto first = on_host(links.first), slot = on_host(links.slot), root = on_host(links.root);
    std::vector<bool> ours(block_count(links.count), false);
    for (int k = 0; k < fluid.own_count; ++k) {
      const int node = own_nodes(k) * nodes_per_block, end = std::min(node + nodes_per_block, fluid.count);
      for (int l = first(node); l < first(end); ++l) ours[l / nodes_per_block] = true;
    }
    links.own_blocks = numbers_of(ours, links.own_count);
    for (int l = 0; l < links.count; ++l) {
      if (!ours[l / nodes_per_block]) continue;
      const int solid = root(l) / 8, direction = root(l) % 8 + 1;
      surface[solid / nodes_per_block] = true;
      nodes.push_back(surface_node(solid));
      nodes.push_back(node_of(slot(l) - Set::opposite(direction) * fluid.capacity));
    }
  }
  own_surface_ = numbers_of(surface, own_surface_count_);
  if (heat_) temperatures_ = geometry_.split.beyond_rows(geometry_.lattice, nodes);
}

template <class T, class Set>
Share ReactionModule<T, Set>::our_surface() const {
  return {geometry_.surface.count, own_surface_count_, own_surface_.data()};
}

template <class T, class Set>
Owners ReactionModule<T, Set>::owners_of_links(const Attack<T>& attack) const {
  Owners owners = geometry_.split.of_fluid(geometry_.fluid);
  const auto first_link = on_host(attack.links.first);
  for (Runs& runs : owners)
    for (auto& [first, last] : runs) {
      first = first_link(first);
      last = first_link(last);
    }
  return owners;
}

template <class T, class Set>
void ReactionModule<T, Set>::gather(const Exec&) {
  gather_links();
  for (const Attack<T>& attack : attacks_) {
    const Owners owners = owners_of_links(attack);
    geometry_.split.make_whole(owners, attack.links.rate);
    geometry_.split.make_whole(owners, attack.links.conductance);
  }
}

template <class T, class Set>
void ReactionModule<T, Set>::gather_links() const {
  const Split& split = geometry_.split;
  if (split.alone()) return;
  for (const Attack<T>& attack : attacks_) {
    const Owners owners = owners_of_links(attack);
    split.make_whole(owners, attack.links.acid);
    if (attack.wall.law == ReactiveWallLaw::kinetic) continue;
    split.make_whole(owners, attack.links.product);
    split.make_whole(owners, attack.links.solid);
  }
}

#define VUG_INSTANTIATE(T, Set)                               \
  template void ReactionModule<T, Set>::share_links();        \
  template Share ReactionModule<T, Set>::our_surface() const; \
  template void ReactionModule<T, Set>::gather(const Exec&);  \
  template void ReactionModule<T, Set>::gather_links() const;
VUG_FOR_NUMBERS_AND_SETS(VUG_INSTANTIATE)
#undef VUG_INSTANTIATE

}  // namespace vug
