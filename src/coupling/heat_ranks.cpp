// The heat of one rank among others (docs/scaling.md).
#include "coupling/heat_module.hpp"
#include "coupling/shared_field.hpp"

#include <algorithm>

namespace vug {

template <class T>
std::vector<int> HeatModule<T>::nodes_before_outflows() const {
  const Lattice& lattice = geometry_.lattice;
  const DenseNeighbour around(lattice, periodic_);
  std::vector<int> nodes;
  const auto look = [&](int node, int q) {
    const int before = around.before(node, q);
    if (geometry_.split.has_row(lattice.y(node)) && before >= 0) nodes.push_back(before);
  };
  for (const HeatSide& side : sides_) {
    if (side.condition != HeatCondition::outflow) continue;
    for (const int node : nodes_of(lattice, side))
      for (int q = 1; q < directions(); ++q)
        if (around.along(node, q) < 0) look(node, q);
  }
  for (const HeatOpening& opening : openings_) {
    if (opening.condition != HeatCondition::outflow) continue;
    const auto node = on_host(opening.links.node);
    const auto direction = on_host(opening.links.direction);
    for (int link = 0; link < opening.links.count; ++link) look(node(link), direction(link));
  }
  return nodes;
}

template <class T>
std::vector<int> HeatModule<T>::slots_filled_beyond() const {
  const Lattice& lattice = geometry_.lattice;
  const Split& split = geometry_.split;
  std::vector<int> slots;
  const auto fill = [&](int node, int q) { slots.push_back(q * lattice.size() + node); };
  const auto fill_halo = [&](int y, int towards) {
    for (int q = 1; q < directions() && y >= 0 && y < lattice.ny; ++q)
      if (D2Q9::c(q, 1) == towards && D2Q9::c(q, 0) != 0) fill(lattice.node(D2Q9::c(q, 0) > 0 ? -1 : lattice.nx, y), q);
  };
  if (split.own_rows() > 0) {
    fill_halo(split.first_row() - 1, 1);
    fill_halo(split.first_row() + split.own_rows(), -1);
  }
  for (const HeatOpening& opening : openings_) {
    const auto node = on_host(opening.links.node), beyond = on_host(opening.links.beyond);
    const auto direction = on_host(opening.links.direction);
    for (int link = 0; link < opening.links.count; ++link)
      if (split.has_row(lattice.y(node(link)))) fill(beyond(link), D2Q9::opposite(direction(link)));
  }
  return slots;
}

template <class T>
void HeatModule<T>::find_halos() {
  const Split& split = geometry_.split;
  if (split.alone()) return;
  populations_ = split.dense(geometry_.lattice, directions(), periodic_[1], nodes_before_outflows());
  filled_ = split.beyond_rows(geometry_.lattice, slots_filled_beyond());
  if (carrier_ || fluid_theta_.extent(0) > 0) in_rows_ = split.in_rows(geometry_.fluid);
}

template <class T>
void HeatModule<T>::visit_shares(const SharedFields& visit) const {
  const Split& split = geometry_.split;
  const Owners rows = split.of_dense(geometry_.lattice);
  visit("heat/g", fields_.g, Shares(rows, directions(), {populations_, filled_}));
  if (carrier_) visit("heat/lagged", lagged_, Shares(split.of_fluid_by_row(geometry_.fluid), 1, {}));
  if (watched_.extent(0) > 0) visit("heat/watched", watched_, Shares(rows, 1, {}));
  if (fluid_theta_.extent(0) > 0)
    visit("heat/fluid_theta", fluid_theta_, Shares(split.of_fluid(geometry_.fluid), 1, {in_rows_}));
  if (before_.extent(0) > 0) visit("heat/before", before_, Shares(split.of_fluid_by_row(geometry_.fluid), 1, {}));
}

template <class T>
void HeatModule<T>::gather_sums() const {
  const Split& split = geometry_.split;
  if (split.alone()) return;
  if (carrier_) split.make_whole(split.of_rows(), created_);
  for (std::size_t s = 0; s < entered_.size(); ++s) split.make_whole(owners_of_entries(s), entered_[s]);
}

template <class T>
Owners HeatModule<T>::owners_of_entries(std::size_t boundary) const {
  const Split& split = geometry_.split;
  const Lattice& lattice = geometry_.lattice;
  if (boundary < sides_.size()) return split.by_row(lattice, nodes_of(lattice, sides_[boundary]));
  const DenseLinks& links = openings_[boundary - sides_.size()].links;
  const auto node = on_host(links.node);
  return split.by_row(lattice, {node.data(), node.data() + links.count});
}

template <class T>
void HeatModule<T>::gather(const Exec& exec) {
  filled_.template exchange_back<T, 1>(exec, {fields_.g});
  gather_sums();
}

template <class T>
void HeatModule<T>::take_temperatures_of_fluid(const Exec& exec) const {
  if (fluid_theta_.extent(0) == 0) return;
  gather_temperatures(exec, geometry_.fluid, fields_, 0, fluid_theta_);
  // over an even number of lattice steps, what changes its sign in each step has carried nothing
  const double share = interval_ % 2 == 1 ? 0.5 : 0;
  if (before_.extent(0) > 0) mix_with_before(exec, geometry_.fluid, share, before_, fluid_theta_);
  in_rows_.template exchange_back<T, 1>(exec, {fluid_theta_});
}

template <class T>
void HeatModule<T>::begin_temperatures_of_fluid(const Exec& exec, int first) const {
  if (fluid_theta_.extent(0) == 0) return;
  gather_temperatures(exec, geometry_.fluid, fields_, first, fluid_theta_);
  if (before_.extent(0) > 0) gather_temperatures(exec, geometry_.fluid, fields_, first, before_);
  in_rows_.template exchange_back<T, 1>(exec, {fluid_theta_});
}

#define VUG_INSTANTIATE(T)                                                    \
  template void HeatModule<T>::find_halos();                                  \
  template void HeatModule<T>::gather(const Exec&);                           \
  template void HeatModule<T>::gather_sums() const;                           \
  template void HeatModule<T>::visit_shares(const SharedFields&) const;       \
  template void HeatModule<T>::take_temperatures_of_fluid(const Exec&) const; \
  template void HeatModule<T>::begin_temperatures_of_fluid(const Exec&, int) const;
VUG_FOR_NUMBERS(VUG_INSTANTIATE)
#undef VUG_INSTANTIATE

}  // namespace vug
