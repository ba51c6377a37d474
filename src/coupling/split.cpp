#include "coupling/split.hpp"

#include "kernels/nodes/fluid_nodes.hpp"

#include <algorithm>

namespace vug {

namespace {

void sort_once(std::vector<int>& items) {
  std::sort(items.begin(), items.end());
  items.erase(std::unique(items.begin(), items.end()), items.end());
}

/// The list has at least one entry, because an empty one would mean all.
IndexList numbers(const char* label, std::vector<int> list) {
  list.resize(std::max<std::size_t>(list.size(), 1));
  return to_device<IndexList>(label, list);
}

}  // namespace

Split::Split(const Ranks& ranks, const std::vector<double>& weight_of_row)
    : ranks_(ranks), rows_(weight_of_row, ranks.size()) {}

void Split::follow(FluidNodes& nodes) {
  if (alone()) return;
  const int blocks = block_count(nodes.count);
  const auto node = on_host(nodes.node);
  owner_of_block_.resize(blocks);
  for (int b = 0; b < blocks; ++b) owner_of_block_[b] = rows_.part_of(nodes.lattice.y(node(b * nodes_per_block)));
  std::vector<bool> beside(nodes.count, false);
  mark_rows(nodes, beside);
  mark_neighbours(nodes, beside);
  std::vector<int> own, near;
  for (int b = 0; b < blocks; ++b) {
    const bool ours = owner_of_block_[b] == ranks_.rank();
    const auto first = beside.begin() + b * nodes_per_block;
    const auto last = beside.begin() + std::min((b + 1) * nodes_per_block, nodes.count);
    if (ours) own.push_back(b);
    if (ours || std::find(first, last, true) != last) near.push_back(b);
  }
  nodes.own_count = static_cast<int>(own.size());
  nodes.near_count = static_cast<int>(near.size());
  nodes.own_blocks = numbers("vug::fluid_nodes::own_blocks", own);
  nodes.near_blocks = numbers("vug::fluid_nodes::near_blocks", near);
}

void Split::share_out(BoundaryLinks& links, const IndexList& mirror) const {
  if (alone()) return;
  const auto fluid = on_host(links.fluid), image = on_host(mirror);
  std::vector<int> own;
  for (int link = 0; link < links.count; ++link) {
    if (!is_ours(fluid(link))) continue;
    own.push_back(link);
    if (image.extent(0) > 0 && image(link) >= 0) own.push_back(image(link));
  }
  sort_once(own);
  links.own_count = static_cast<int>(own.size());
  links.own = numbers("vug::boundary::own", own);
}

Halo Split::populations(const FluidNodes& nodes, int directions) const {
  if (alone()) return {};
  const auto source = on_host(nodes.source);
  std::vector<int> slots, owner;
  for (int i = 0; i < nodes.count; ++i) {
    if (!is_ours(i)) {
      i += nodes_per_block - 1;
      continue;
    }
    for (int q = 1; q < directions; ++q) {
      const int from = upstream_node(source, nodes.capacity, q, i);
      if (from < 0 || is_ours(from)) continue;
      slots.push_back(q * nodes.capacity + from);
      owner.push_back(owner_of(from));
    }
  }
  return Halo(ranks_, slots, owner);
}

Halo Split::slots(const FluidNodes& nodes, const std::vector<int>& slots) const {
  if (alone()) return {};
  std::vector<int> needed(slots), owner;
  sort_once(needed);
  std::erase_if(needed, [&](int slot) { return is_ours(slot % nodes.capacity); });
  for (const int slot : needed) owner.push_back(owner_of(slot % nodes.capacity));
  return Halo(ranks_, needed, owner);
}

Halo Split::marked(const FluidNodes& nodes, const std::vector<bool>& needed) const {
  std::vector<int> list, owner;
  for (int i = 0; i < nodes.count; ++i) {
    if (!needed[i] || is_ours(i)) continue;
    list.push_back(i);
    owner.push_back(owner_of(i));
  }
  return Halo(ranks_, list, owner);
}

void Split::mark_rows(const FluidNodes& nodes, std::vector<bool>& needed) const {
  const auto node = on_host(nodes.node);
  for (int i = 0; i < nodes.count; ++i)
    if (rows_.part_of(nodes.lattice.y(node(i))) == ranks_.rank()) needed[i] = true;
}

void Split::mark_neighbours(const FluidNodes& nodes, std::vector<bool>& needed) const {
  const auto source = on_host(nodes.source);
  for (int i = 0; i < nodes.count; ++i)
    for (int q = 1; is_ours(i) && q < D2Q9::Q; ++q) {
      const int from = upstream_node(source, nodes.capacity, q, i);
      if (from >= 0) needed[from] = true;
    }
}

Halo Split::in_rows(const FluidNodes& nodes) const {
  if (alone()) return {};
  std::vector<bool> needed(nodes.count, false);
  mark_rows(nodes, needed);
  return marked(nodes, needed);
}

Halo Split::around(const FluidNodes& nodes, const std::vector<int>& more) const {
  if (alone()) return {};
  std::vector<bool> needed(nodes.count, false);
  mark_rows(nodes, needed);
  for (const int i : more) needed[i] = true;
  mark_neighbours(nodes, needed);
  return marked(nodes, needed);
}

Halo Split::populations_around(const FluidNodes& nodes) const {
  if (alone()) return {};
  std::vector<bool> needed(nodes.count, false);
  mark_neighbours(nodes, needed);
  std::vector<int> all;
  for (int i = 0; i < nodes.count; ++i)
    for (int q = 1; needed[i] && q < D2Q9::Q; ++q) all.push_back(q * nodes.capacity + i);
  return slots(nodes, all);
}

Halo Split::dense(const Lattice& lattice, int directions, bool periodic_y, const std::vector<int>& nodes) const {
  if (alone()) return {};
  std::vector<int> needed;
  const auto row = [&](int y, int towards) {
    if (periodic_y) y = (y + lattice.ny) % lattice.ny;
    if (y < 0 || y >= lattice.ny || own_rows() == 0) return;
    for (int q = 1; q < directions; ++q)
      for (int x = 0; D2Q9::c(q, 1) == towards && x < lattice.nx; ++x)
        needed.push_back(q * lattice.size() + lattice.node(x, y));
  };
  row(first_row() - 1, 1);
  row(first_row() + own_rows(), -1);
  for (const int n : nodes)
    for (int q = 0; q < directions; ++q) needed.push_back(q * lattice.size() + n);
  return beyond_rows(lattice, needed);
}

Halo Split::beyond_rows(const Lattice& lattice, std::vector<int> slots) const {
  if (alone()) return {};
  sort_once(slots);
  const auto owner_of = [&](int slot) { return rows_.part_of(lattice.y(slot % lattice.size())); };
  std::erase_if(slots, [&](int slot) { return owner_of(slot) == ranks_.rank(); });
  std::vector<int> owner;
  for (const int slot : slots) owner.push_back(owner_of(slot));
  return Halo(ranks_, slots, owner);
}

Owners Split::of_blocks(std::size_t most) const {
  const auto first = owner_of_block_.begin();
  return owners_of({first, first + std::min(most, owner_of_block_.size())}, ranks_.size());
}

Owners Split::of_fluid(const FluidNodes& nodes) const {
  Owners owners = of_blocks();
  for (Runs& runs : owners)
    for (auto& [first, last] : runs) {
      first *= nodes_per_block;
      last = std::min(last * nodes_per_block, nodes.count);
    }
  return owners;
}

Owners Split::of_fluid_by_row(const FluidNodes& nodes) const {
  if (alone()) return {};
  const auto node = on_host(nodes.node);
  return by_row(nodes.lattice, {node.data(), node.data() + nodes.count});
}

Owners Split::by_row(const Lattice& lattice, const std::vector<int>& nodes) const {
  std::vector<int> owner;
  for (const int n : nodes) owner.push_back(rows_.part_of(lattice.y(n)));
  return owners_of(owner, ranks_.size());
}

Owners Split::of_links(const BoundaryLinks& links) const {
  const auto fluid = on_host(links.fluid);
  std::vector<int> owner(links.count);
  for (int link = 0; link < links.count; ++link) owner[link] = owner_of(fluid(link));
  return owners_of(owner, ranks_.size());
}

Owners Split::of_neighbours(const FluidNodes& nodes, int first, int last) const {
  const auto node = on_host(nodes.node), index = on_host(nodes.index);
  std::vector<int> old;
  for (int i = first; i < last; ++i)
    for (int q = 1; q < D2Q9::Q; ++q) {
      const int n = nodes.around().along(node(i), q);
      if (n >= 0 && index(n) >= 0 && index(n) < first) old.push_back(index(n));
    }
  sort_once(old);
  Owners owners(ranks_.size());
  for (const int i : old) owners[owner_of(i)].emplace_back(i, i + 1);
  return owners;
}

Owners Split::of_dense_nodes(const Lattice& lattice, std::vector<int> nodes) const {
  sort_once(nodes);
  Owners owners(ranks_.size());
  for (const int n : nodes) owners[rows_.part_of(lattice.y(n))].emplace_back(n, n + 1);
  return owners;
}

Owners Split::of_rows() const {
  Owners owners(ranks_.size());
  for (int p = 0; p < rows_.parts(); ++p)
    if (rows_.first(p) < rows_.last(p)) owners[p].emplace_back(rows_.first(p), rows_.last(p));
  return owners;
}

Owners Split::of_dense(const Lattice& lattice) const {
  Owners owners = of_rows();
  for (Runs& runs : owners)
    for (auto& [first, last] : runs) {
      first = first == 0 ? 0 : lattice.node(-1, first);
      last = last == lattice.ny ? lattice.size() : lattice.node(lattice.nx, last - 1) + 1;
    }
  return owners;
}

void Split::make_whole(const Owners& owners, const LongSum& sum) const {
  for (const ScalarField<double>& part : {sum.recent(), sum.sum(), sum.carry()}) make_whole(owners, part);
}

}  // namespace vug
