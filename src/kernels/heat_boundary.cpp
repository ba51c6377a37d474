#include "kernels/heat_boundary.hpp"

#include "kernels/launch.hpp"
#include "kernels/require.hpp"

namespace vug {

HeatSide make_heat_side(Side side, int first, int last, HeatCondition condition, double value) {
  if (first < 0 || last < first)
    throw InputError("heat: a stretch of a side from node " + std::to_string(first) + " to " + std::to_string(last));
  HeatSide made{side, first, last, condition, value, {}};
  made.energy_in = ScalarField<double>("vug::heat::energy_in", block_count(last - first + 1));
  return made;
}

HeatSide make_heat_side(const Lattice& lattice, Side side, HeatCondition condition, double value) {
  const bool upright = side == Side::left || side == Side::right;
  return make_heat_side(side, 0, (upright ? lattice.ny : lattice.nx) - 1, condition, value);
}

namespace {

/// Direction of the outward velocity of a side.
constexpr int outward(Side side) {
  return static_cast<int>(side);
}

/// First node of a side and the distance in memory along it.
struct SideNodes {
  int first, stride;
};

SideNodes side_nodes(const Lattice& lattice, Side side) {
  switch (side) {
    case Side::left:
      return {lattice.node(0, 0), lattice.pitch};
    case Side::right:
      return {lattice.node(lattice.nx - 1, 0), lattice.pitch};
    case Side::bottom:
      return {lattice.node(0, 0), 1};
    default:
      return {lattice.node(0, lattice.ny - 1), 1};
  }
}

}  // namespace

/// in = A + q / c.
template <class T>
struct FluxIn {
  T fluid_flux, solid_flux;
  KOKKOS_FUNCTION T operator()(T leaving, T, T solid) const {
    return leaving + fluid_flux + solid * (solid_flux - fluid_flux);
  }
};

/// in = -A + 2 w theta_wall (half-way anti-bounce-back).
template <class T>
struct TemperatureIn {
  T twice_wall_population;
  KOKKOS_FUNCTION T operator()(T leaving, T, T) const { return twice_wall_population - leaving; }
};

/// in = the node's own inward population.
template <class T>
struct OutflowIn {
  KOKKOS_FUNCTION T operator()(T, T inward, T) const { return inward; }
};

/// Writes the arriving population of one link of a side into the halo and returns the energy it brings in, c (in - A).
/// `Law` maps the leaving population A, the node's own inward population and its kind to the arriving one.
template <class T, class Law>
struct FillSide {
  Law law;
  int first, stride, beyond, leaving_plane, arriving_plane;
  double capacity_ratio;
  Kokkos::View<const std::uint8_t*> solid;
  ScalarField<T> g;
  KOKKOS_FUNCTION double operator()(int item) const {
    const int node = first + item * stride;
    const T leaving = g(leaving_plane + node);
    const T arriving = law(leaving, g(arriving_plane + node), static_cast<T>(solid(node)));
    g(arriving_plane + node + beyond) = arriving;
    const double capacity = solid(node) ? capacity_ratio : 1;
    return capacity * (static_cast<double>(arriving) - static_cast<double>(leaving));
  }
};

template <class T, class Law>
void launch(const Exec& exec, const HeatFields<T>& fields, const HeatSide& side, const Law& law) {
  const Lattice& lattice = fields.lattice;
  const auto [origin, stride] = side_nodes(lattice, side.side);
  const int q = outward(side.side);
  const FillSide<T, Law> body{law,
                              origin + side.first * stride,
                              stride,
                              lattice.offset(q),
                              q * lattice.size(),
                              D2Q5::opposite(q) * lattice.size(),
                              fields.rates.capacity_ratio,
                              fields.solid,
                              fields.g};
  add_per_block(exec, "vug::heat::fill_side", side.last - side.first + 1, body, side.energy_in);
}

template <class T>
void fill_heat_side(const Exec& exec, const HeatFields<T>& fields, const HeatSide& side) {
  switch (side.condition) {
    case HeatCondition::adiabatic:
      return launch(exec, fields, side, FluxIn<T>{0, 0});
    case HeatCondition::temperature:
      return launch(exec, fields, side, TemperatureIn<T>{static_cast<T>(2 * D2Q5::w(1) * side.value)});
    case HeatCondition::flux:
      return launch(exec, fields, side,
                    FluxIn<T>{static_cast<T>(side.value), static_cast<T>(side.value / fields.rates.capacity_ratio)});
    case HeatCondition::outflow:
      return launch(exec, fields, side, OutflowIn<T>{});
  }
}

/// Copies the populations that leave through one side to the halo beside the other.
template <class T>
struct JoinSides {
  int low, high, stride, beyond, up_plane, down_plane;
  ScalarField<T> g;
  KOKKOS_FUNCTION void operator()(int item) const {
    const int bottom = low + item * stride;
    const int top = high + item * stride;
    g(up_plane + bottom - beyond) = g(up_plane + top);
    g(down_plane + top + beyond) = g(down_plane + bottom);
  }
};

template <class T>
void join_heat_sides(const Exec& exec, const HeatFields<T>& fields, int axis) {
  const Lattice& lattice = fields.lattice;
  const Side low = axis == 0 ? Side::left : Side::bottom;
  const Side high = axis == 0 ? Side::right : Side::top;
  const int q = outward(high);
  const SideNodes nodes = side_nodes(lattice, low);
  for_each_node(exec, "vug::heat::join_sides", axis == 0 ? lattice.ny : lattice.nx,
                JoinSides<T>{nodes.first, side_nodes(lattice, high).first, nodes.stride, lattice.offset(q),
                             q * lattice.size(), D2Q5::opposite(q) * lattice.size(), fields.g});
}

#define VUG_INSTANTIATE(T)                                                          \
  template void fill_heat_side(const Exec&, const HeatFields<T>&, const HeatSide&); \
  template void join_heat_sides(const Exec&, const HeatFields<T>&, int)
VUG_INSTANTIATE(float);
VUG_INSTANTIATE(double);
#undef VUG_INSTANTIATE

}  // namespace vug
