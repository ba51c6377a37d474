// The heat of one rank among others (docs/scaling.md).
#include "coupling/heat_module.hpp"
#include "kernels/base/host_and_device.hpp"

#include <algorithm>

namespace vug {

template <class T>
void HeatModule<T>::find_halos() {
  const Split& split = geometry_.split;
  if (split.alone()) return;
  const Lattice& lattice = geometry_.lattice;
  fields_.first_row = split.first_row();
  fields_.rows = split.own_rows();
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
void HeatModule<T>::gather(const Exec& exec) {
  const Split& split = geometry_.split;
  split.make_whole(geometry_.lattice, fields_.g, directions());
  if (watched_.extent(0) > 0) split.make_whole(geometry_.lattice, watched_);
  if (carrier_) {
    split.make_whole(split.of_fluid_by_row(geometry_.fluid), lagged_);
    split.make_whole(split.of_rows(), created_);
  }
  if (fluid_theta_.extent(0) > 0) gather_temperatures(exec, geometry_.fluid, fields_, fluid_theta_);
}

#define VUG_INSTANTIATE(T)                   \
  template void HeatModule<T>::find_halos(); \
  template void HeatModule<T>::gather(const Exec&)
VUG_INSTANTIATE(float);
VUG_INSTANTIATE(double);
#undef VUG_INSTANTIATE

}  // namespace vug
