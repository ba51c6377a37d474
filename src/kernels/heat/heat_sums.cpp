#include "kernels/heat/heat_sums.hpp"

#include "kernels/launch/row_launch.hpp"

#include <type_traits>

namespace vug {

/// Energy of one node; none in openings.
template <class T, class Kinds>
struct NodeEnergy {
  Kinds kinds;
  Kokkos::View<const std::uint8_t*> solid;
  Temperature<T> theta;
  KOKKOS_FUNCTION double operator()(int node) const {
    const double energy = kinds.capacity(node) * static_cast<double>(theta(node));
    return solid(node) > 1 ? 0.0 : energy;
  }
};

template <class T>
void add_heat_energy(const Exec& exec, const HeatFields<T>& fields, const ScalarField<double>& total) {
  visit_kinds(fields, [&](const auto& kinds) {
    add_per_dense_row(exec, "vug::heat::energy", fields.lattice, {fields.first_row, fields.rows},
                      NodeEnergy<T, std::decay_t<decltype(kinds)>>{kinds, fields.solid, Temperature<T>(fields)}, total);
  });
}

/// (1 - sigma) theta of a solid node that becomes fluid.
template <class T, class Kinds>
struct BirthEnergy {
  int first;
  Kinds kinds;
  IndexList list;
  Kokkos::View<const std::uint8_t*> solid;
  Temperature<T> theta;
  KOKKOS_FUNCTION double operator()(int item) const {
    const int node = list(first + item);
    return solid(node) ? (1 - kinds.capacity(node)) * static_cast<double>(theta(node)) : 0.0;
  }
};

template <class T>
void add_birth_energy(const Exec& exec, const HeatFields<T>& fields, const IndexList& list, int first, int last,
                      const ScalarField<double>& total) {
  visit_kinds(fields, [&](const auto& kinds) {
    using Body = BirthEnergy<T, std::decay_t<decltype(kinds)>>;
    add_per_block(exec, "vug::heat::birth_energy", last - first,
                  Body{first, kinds, list, fields.solid, Temperature<T>(fields)}, total);
  });
}

template <class T>
struct TemperatureChange {
  Kokkos::View<const std::uint8_t*> solid;
  Temperature<T> theta;
  ScalarField<T> before;
  KOKKOS_FUNCTION double operator()(int node) const {
    const T now = solid(node) > 1 ? T(0) : theta(node);
    const double change = static_cast<double>(now) - static_cast<double>(before(node));
    before(node) = now;
    return Kokkos::abs(change);
  }
};

template <class T>
struct TemperatureAmount {
  Kokkos::View<const T*> theta;
  KOKKOS_FUNCTION double operator()(int node) const { return Kokkos::abs(static_cast<double>(theta(node))); }
};

template <class T>
void add_temperature_change(const Exec& exec, const HeatFields<T>& fields, const ScalarField<T>& before,
                            const ScalarField<double>& change, const ScalarField<double>& amount) {
  const Rows rows{fields.first_row, fields.rows};
  add_per_dense_row(exec, "vug::heat::change", fields.lattice, rows,
                    TemperatureChange<T>{fields.solid, Temperature<T>(fields), before}, change);
  add_per_dense_row(exec, "vug::heat::amount", fields.lattice, rows, TemperatureAmount<T>{before}, amount);
}

/// Extremes of one node, or on a host of a row: there in lanes, so that it vectorises.
template <class T>
struct Extremes {
  static constexpr int lanes = 128;

  Lattice lattice;
  int first_row;
  Kokkos::View<const std::uint8_t*> solid;
  Temperature<T> theta;

  KOKKOS_FORCEINLINE_FUNCTION void look(int node, T& lowest, T& highest, int& not_finite) const {
    const T value = theta(node);
    const int inside = solid(node) <= 1, finite = Kokkos::abs(value) <= Kokkos::Experimental::finite_max_v<T>;
    const int good = inside & finite;
    const T low = good ? value : lowest, high = good ? value : highest;
    lowest = low < lowest ? low : lowest;
    highest = high > highest ? high : highest;
    not_finite += inside - good;
  }

  KOKKOS_FUNCTION void operator()(int item, T& lowest, T& highest, int& not_finite) const {
    if constexpr (!runs_on_host) {
      look(lattice.node(item % lattice.nx, first_row + item / lattice.nx), lowest, highest, not_finite);
    } else {
      T low[lanes], high[lanes];
      int bad[lanes] = {};
      for (int l = 0; l < lanes; ++l) low[l] = lowest, high[l] = highest;
      for (int x = 0; x < lattice.nx; x += lanes) {
        const int node = lattice.node(x, first_row + item), count = lattice.nx - x < lanes ? lattice.nx - x : lanes;
        VUG_VECTORISE
        for (int l = 0; l < count; ++l) look(node + l, low[l], high[l], bad[l]);
      }
      for (int l = 0; l < lanes; ++l) {
        lowest = low[l] < lowest ? low[l] : lowest;
        highest = high[l] > highest ? high[l] : highest;
        not_finite += bad[l];
      }
    }
  }
};

template <class T>
HeatExtremes heat_extremes(const Exec& exec, const HeatFields<T>& fields) {
  const Lattice& lattice = fields.lattice;
  T lowest, highest;
  int not_finite;
  Kokkos::parallel_reduce("vug::heat::extremes",
                          Kokkos::RangePolicy<Exec>(exec, 0, fields.rows * (runs_on_host ? 1 : lattice.nx)),
                          Extremes<T>{lattice, fields.first_row, fields.solid, Temperature<T>(fields)},
                          Kokkos::Min<T>(lowest), Kokkos::Max<T>(highest), Kokkos::Sum<int>(not_finite));
  return {static_cast<double>(lowest), static_cast<double>(highest), not_finite};
}

VUG_COMPILE_FOR_NUMBERS(add_heat_energy)
VUG_COMPILE_FOR_NUMBERS(add_birth_energy)
VUG_COMPILE_FOR_NUMBERS(add_temperature_change)
VUG_COMPILE_FOR_NUMBERS(heat_extremes)

}  // namespace vug
