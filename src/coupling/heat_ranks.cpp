// The heat of one rank among others (docs/scaling.md).
#include "coupling/heat_module.hpp"
#include "coupling/shared_field.hpp"
#include "kernels/base/host_and_device.hpp"

#include <algorithm>

namespace vug {

template <class T>
void HeatModule<T>::find_halos() {
  const Split& split = geometry_.split;
  if (split.alone()) return;
  const Lattice& lattice = geometry_.lattice;
  std::vector<int> nodes;  // at sides and openings, whose heat is summed over all of them, and before these
  const int beside_x = std::min(2, lattice.nx), beside_y = std::min(2, lattice.ny);
  for (int y = 0; y < lattice.ny && !periodic_[0]; ++y)
    for (int k = 0; k < beside_x; ++k) {
      nodes.push_back(lattice.node(k, y));
      nodes.push_back(lattice.node(lattice.nx - 1 - k, y));
    }
  for (int x = 0; x < lattice.nx && !periodic_[1]; ++x)
    for (int k = 0; k < beside_y; ++k) {
      nodes.push_back(lattice.node(x, k));
      nodes.push_back(lattice.node(x, lattice.ny - 1 - k));
    }
  for (const HeatOpening& opening : openings_) {
    const auto node = on_host(opening.links.node);
    const auto direction = on_host(opening.links.direction);
    for (int link = 0; link < opening.links.count; ++link) {
      nodes.push_back(node(link));
      if (const int before = node_before(lattice, node(link), direction(link)); before >= 0) nodes.push_back(before);
    }
  }
  populations_ = split.dense(lattice, directions(), periodic_[1], nodes);
  if (carrier_ || fluid_theta_.extent(0) > 0) in_rows_ = split.in_rows(geometry_.fluid);
}

template <class T>
template <class Visit>
void HeatModule<T>::visit_shares(const Visit& visit) const {
  const Split& split = geometry_.split;
  const Owners rows = split.of_dense(geometry_.lattice);
  visit("heat/g", fields_.g, Shares(rows, directions(), {populations_}));
  if (carrier_) visit("heat/lagged", lagged_, Shares(split.of_fluid_by_row(geometry_.fluid), 1, {}));
  if (watched_.extent(0) > 0) visit("heat/watched", watched_, Shares(rows, 1, {}));
  if (fluid_theta_.extent(0) > 0)
    visit("heat/fluid_theta", fluid_theta_, Shares(split.of_fluid(geometry_.fluid), 1, {in_rows_}));
}

template <class T>
void HeatModule<T>::gather(const Exec&) {
  if (carrier_) geometry_.split.make_whole(geometry_.split.of_rows(), created_);
}

template <class T>
void HeatModule<T>::let_go() {
  visit_shares(LetGo{geometry_.split.ranks()});
}

template <class T>
void HeatModule<T>::shared_state(StateList& list) const {
  visit_shares(AddShared{list, geometry_.split.ranks()});
}

template <class T>
void HeatModule<T>::take_temperatures_of_fluid(const Exec& exec) const {
  gather_temperatures(exec, geometry_.fluid, fields_, fluid_theta_);
  in_rows_.template exchange_back<T, 1>(exec, {fluid_theta_});
}

#define VUG_INSTANTIATE(T)                                     \
  template void HeatModule<T>::find_halos();                   \
  template void HeatModule<T>::gather(const Exec&);            \
  template void HeatModule<T>::let_go();                       \
  template void HeatModule<T>::shared_state(StateList&) const; \
  template void HeatModule<T>::take_temperatures_of_fluid(const Exec&) const
VUG_INSTANTIATE(float);
VUG_INSTANTIATE(double);
#undef VUG_INSTANTIATE

}  // namespace vug
