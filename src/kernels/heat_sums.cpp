#include "kernels/heat_sums.hpp"

#include "kernels/launch.hpp"

namespace vug {

/// Energy of one entry of the dense fields; outside the lattice and in openings theta is 0.
template <class T>
struct NodeEnergy {
  double capacity_ratio;
  Kokkos::View<const std::uint8_t*> solid;
  Kokkos::View<const T*> theta;
  KOKKOS_FUNCTION double operator()(int node) const {
    return (solid(node) ? capacity_ratio : 1.0) * static_cast<double>(theta(node));
  }
};

int heat_energy_blocks(const Lattice& lattice) {
  return block_count(lattice.size());
}

template <class T>
void add_heat_energy(const Exec& exec, const HeatFields<T>& fields, const ScalarField<double>& total) {
  add_per_block(exec, "vug::heat::energy", fields.lattice.size(),
                NodeEnergy<T>{fields.rates.capacity_ratio, fields.solid, fields.theta}, total);
}

/// (1 - sigma) theta of a solid node that becomes fluid.
template <class T>
struct BirthEnergy {
  int first;
  double capacity_ratio;
  IndexList list;
  Kokkos::View<const std::uint8_t*> solid;
  Kokkos::View<const T*> theta;
  KOKKOS_FUNCTION double operator()(int item) const {
    const int node = list(first + item);
    return solid(node) ? (1 - capacity_ratio) * static_cast<double>(theta(node)) : 0.0;
  }
};

template <class T>
void add_birth_energy(const Exec& exec, const HeatFields<T>& fields, const IndexList& list, int first, int last,
                      const ScalarField<double>& total) {
  add_per_block(exec, "vug::heat::birth_energy", last - first,
                BirthEnergy<T>{first, fields.rates.capacity_ratio, list, fields.solid, fields.theta}, total);
}

template <class T>
struct Extremes {
  Lattice lattice;
  Kokkos::View<const std::uint8_t*> solid;
  Kokkos::View<const T*> theta;
  KOKKOS_FUNCTION void operator()(int item, double& lowest, double& highest, int& not_finite) const {
    const int node = lattice.node(item % lattice.nx, item / lattice.nx);
    if (solid(node) > 1) return;
    const double value = theta(node);
    if (!Kokkos::isfinite(value)) {
      ++not_finite;
      return;
    }
    lowest = value < lowest ? value : lowest;
    highest = value > highest ? value : highest;
  }
};

template <class T>
HeatExtremes heat_extremes(const Exec& exec, const HeatFields<T>& fields) {
  const Lattice& lattice = fields.lattice;
  HeatExtremes found;
  Kokkos::parallel_reduce("vug::heat::extremes", Kokkos::RangePolicy<Exec>(exec, 0, lattice.nx * lattice.ny),
                          Extremes<T>{lattice, fields.solid, fields.theta}, Kokkos::Min<double>(found.lowest),
                          Kokkos::Max<double>(found.highest), Kokkos::Sum<int>(found.not_finite));
  return found;
}

#define VUG_INSTANTIATE(T)                                                                      \
  template void add_heat_energy(const Exec&, const HeatFields<T>&, const ScalarField<double>&); \
  template void add_birth_energy(const Exec&, const HeatFields<T>&, const IndexList&, int, int, \
                                 const ScalarField<double>&);                                   \
  template HeatExtremes heat_extremes(const Exec&, const HeatFields<T>&)
VUG_INSTANTIATE(float);
VUG_INSTANTIATE(double);
#undef VUG_INSTANTIATE

}  // namespace vug
