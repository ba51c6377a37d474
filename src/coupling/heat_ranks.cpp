// The heat of one rank among others (docs/scaling.md).
#include "coupling/heat_module.hpp"
#include "kernels/base/host_and_device.hpp"

namespace vug {

template <class T>
void HeatModule<T>::find_halos() {
  const Split& split = geometry_.split;
  if (split.alone()) return;
  const Lattice& lattice = geometry_.lattice;
  fields_.first_row = split.first_row();
  fields_.rows = split.own_rows();
  std::vector<int> nodes;  // at sides and openings, whose heat is summed over all of them
  const auto side = [&](int x, int y, int dx, int dy, int count) {
    for (int k = 0; k < count; ++k) nodes.push_back(lattice.node(x + k * dx, y + k * dy));
  };
  if (!periodic_[0]) {
    side(0, 0, 0, 1, lattice.ny);
    side(lattice.nx - 1, 0, 0, 1, lattice.ny);
  }
  if (!periodic_[1]) {
    side(0, 0, 1, 0, lattice.nx);
    side(0, lattice.ny - 1, 1, 0, lattice.nx);
  }
  for (const HeatOpening& opening : openings_) {
    const auto node = on_host(opening.links.node);
    for (int link = 0; link < opening.links.count; ++link) nodes.push_back(node(link));
  }
  populations_ = split.dense(lattice, directions(), periodic_[1], nodes);
  if (carrier_ || fluid_theta_.extent(0) > 0) in_rows_ = split.in_rows(geometry_.fluid);
}

template <class T>
void HeatModule<T>::gather(const Exec& exec) {
  const Split& split = geometry_.split;
  split.make_whole(geometry_.lattice, fields_.g, directions());
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
