#include "kernels/heat.hpp"

#include "kernels/heat_bands.hpp"
#include "kernels/require.hpp"
#include "kernels/row_launch.hpp"

#include <algorithm>
#include <cmath>
#include <string>

namespace vug {

namespace {

/// Rows of a band at most: one in sixteen more is copied for it.
constexpr int rows_per_band = 32;

/// Bands of equal height for a number of threads; no bit depends on them.
int band_count(const Exec& exec, const Lattice& lattice) {
  const int threads = exec.concurrency(), bands = (lattice.ny + rows_per_band - 1) / rows_per_band;
  return std::min(lattice.ny, (bands + threads - 1) / threads * threads);
}

void require_positive(const char* name, double value) {
  if (!(value > 0) || !std::isfinite(value))
    throw InputError(std::string("heat: ") + name + " = " + std::to_string(value) + ", expected a positive number");
}

}  // namespace

template <class T>
HeatRates<T> heat_rates(const HeatParameters& p) {
  require_positive("fluid diffusivity", p.fluid_diffusivity);
  require_positive("solid diffusivity", p.solid_diffusivity);
  require_positive("heat capacity ratio", p.capacity_ratio);
  const auto rate = [](double diffusivity) { return static_cast<T>(1 / (0.5 + diffusivity / c_s2)); };
  return {rate(p.fluid_diffusivity), rate(p.solid_diffusivity), static_cast<T>(interface_reflection(p.capacity_ratio)),
          p.capacity_ratio};
}

/// Mask of the solid of one row of those with halo, continued into it so that the conjugate link is inert there: like
/// the node joined to it, and where there is none, like the nearest node inside or, if `marked`, as outside.
struct CopySolidRow {
  Lattice lattice;
  bool periodic_x, periodic_y, marked;
  Kokkos::View<const NodeType*> type;
  Kokkos::View<std::uint8_t*> solid;

  KOKKOS_FORCEINLINE_FUNCTION static int source(int p, int n, bool periodic) {
    if (periodic) return (p + n) % n;
    return p < 0 ? 0 : p >= n ? n - 1 : p;
  }
  KOKKOS_FORCEINLINE_FUNCTION static std::uint8_t mask(NodeType type) {
    return type == NodeType::opening ? inside_opening : static_cast<std::uint8_t>(type == NodeType::solid);
  }
  KOKKOS_FUNCTION void operator()(int row) const {
    const int y = row - 1, from = lattice.node(0, source(y, lattice.ny, periodic_y)), to = lattice.node(0, y);
    const bool beyond = marked && !periodic_y && (y < 0 || y == lattice.ny);
    VUG_VECTORISE
    for (int x = 0; x < lattice.nx; ++x) solid(to + x) = beyond ? outside_lattice : mask(type(from + x));
    for (const int x : {-1, lattice.nx})
      solid(to + x) =
          beyond || (marked && !periodic_x) ? outside_lattice : mask(type(from + source(x, lattice.nx, periodic_x)));
  }
};

template <class T>
void set_heat_geometry(const Exec& exec, const Kokkos::View<NodeType*>& type, std::array<bool, 2> periodic,
                       HeatFields<T>& fields) {
  Kokkos::parallel_for("vug::heat::copy_solid", Kokkos::RangePolicy<Exec>(exec, 0, fields.lattice.ny + 2),
                       CopySolidRow{fields.lattice, periodic[0], periodic[1],
                                    fields.velocity_set == ScalarVelocitySet::d2q9, type, fields.solid});
}

/// Populations at rest, g_q = w_q theta.
template <class T, class Set>
struct StartHeat {
  int plane;
  Kokkos::View<const T*> theta;
  ScalarField<T> g;
  KOKKOS_FUNCTION void operator()(int node) const {
    for (int q = 0; q < Set::Q; ++q) g(q * plane + node) = T(Set::w(q)) * theta(node);
  }
};

template <class T>
void start_heat(const Exec& exec, HeatFields<T>& fields) {
  const int plane = fields.lattice.size();
  visit_velocity_set(fields.velocity_set, [&](auto set) {
    for_each_node(exec, "vug::heat::start", plane, StartHeat<T, decltype(set)>{plane, fields.theta, fields.g});
  });
}

template <class T>
struct FillTemperature {
  T value;
  Kokkos::View<const std::uint8_t*> solid;
  ScalarField<T> theta;
  KOKKOS_FUNCTION void operator()(int node) const { theta(node) = solid(node) > 1 ? T(0) : value; }
};

template <class T>
HeatFields<T> make_heat_fields(const Exec& exec, const Lattice& lattice, const HeatParameters& parameters,
                               const Kokkos::View<NodeType*>& type, std::array<bool, 2> periodic, double theta,
                               bool openings) {
  HeatFields<T> fields;
  fields.lattice = lattice;
  fields.rates = heat_rates<T>(parameters);
  fields.velocity_set = parameters.velocity_set;
  fields.openings = openings;
  const std::size_t size = lattice.size();
  const std::size_t slots = size * visit_velocity_set(fields.velocity_set, [](auto set) { return decltype(set)::Q; });
  fields.g = ScalarField<T>(Kokkos::view_alloc(exec, "vug::heat::g"), slots);
  if constexpr (runs_on_host) {
    fields.bands = band_count(exec, lattice);
    const int lines =
        visit_velocity_set(fields.velocity_set, [](auto set) { return BandLines<T, decltype(set)>::count; });
    fields.lines = ScalarField<T>(Kokkos::view_alloc(exec, "vug::heat::lines"),
                                  static_cast<std::size_t>(fields.bands) * lines * lattice.pitch);
  } else {
    fields.g_next = ScalarField<T>(Kokkos::view_alloc(exec, "vug::heat::g_next"), slots);
  }
  fields.theta = ScalarField<T>(Kokkos::view_alloc(exec, "vug::heat::theta"), size);
  fields.solid = Kokkos::View<std::uint8_t*>(Kokkos::view_alloc(exec, "vug::heat::solid"), size);
  set_heat_geometry(exec, type, periodic, fields);
  for_each_dense_node(exec, "vug::heat::fill", lattice,
                      FillTemperature<T>{static_cast<T>(theta), fields.solid, fields.theta});
  start_heat(exec, fields);
  return fields;
}

#define VUG_INSTANTIATE(T)                                                                                       \
  template HeatRates<T> heat_rates<T>(const HeatParameters&);                                                    \
  template HeatFields<T> make_heat_fields<T>(const Exec&, const Lattice&, const HeatParameters&,                 \
                                             const Kokkos::View<NodeType*>&, std::array<bool, 2>, double, bool); \
  template void start_heat(const Exec&, HeatFields<T>&);                                                         \
  template void set_heat_geometry(const Exec&, const Kokkos::View<NodeType*>&, std::array<bool, 2>, HeatFields<T>&)
VUG_INSTANTIATE(float);
VUG_INSTANTIATE(double);
#undef VUG_INSTANTIATE

}  // namespace vug
