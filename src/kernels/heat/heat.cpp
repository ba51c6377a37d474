#include "kernels/heat/heat.hpp"

#include "base/pages.hpp"
#include "base/require.hpp"
#include "kernels/heat/heat_bands.hpp"
#include "kernels/launch/row_launch.hpp"
#include "kernels/scalar/turning.hpp"

#include <algorithm>
#include <cmath>
#include <string>

namespace vug {

namespace {

/// Number of bands: the same for every thread, and each band so low that what it sets aside stays in the cache.
int band_count(const Exec& exec, const Lattice& lattice) {
  constexpr int rows_per_band = 32;
  const int threads = exec.concurrency(), bands = (lattice.ny + rows_per_band - 1) / rows_per_band;
  return (bands + threads - 1) / threads * threads;
}

void require_positive(const char* name, double value) {
  if (!(value > 0) || !std::isfinite(value))
    throw InputError(std::string("heat: ") + name + " = " + std::to_string(value) + ", expected a positive number");
}

/// Relaxation rate of a diffusivity, in the step before steps of `stretch` times the length.
double rate_of(double diffusivity, double stretch = 1) {
  return turning(0.5 + diffusivity / c_s2, stretch).rate;
}

/// Sets the rates of all kinds of matter.
void set_matter_rates(const HeatParameters& parameters, double stretch, const HeatMatter& matter) {
  const HostWriter rate(matter.rate);
  rate(0) = rate_of(parameters.fluid_diffusivity, stretch);
  for (std::size_t m = 0; m < parameters.minerals.size(); ++m)
    rate(1 + m) = rate_of(parameters.minerals[m].diffusivity, stretch);
}

/// Makes the kinds of matter. Their tables have an entry for every value of a node's byte.
HeatMatter make_matter(const Exec& exec, const HeatParameters& parameters, std::size_t nodes,
                       const Kokkos::View<const std::uint8_t*>& mineral) {
  constexpr std::size_t kinds = no_matter + 1;
  HeatMatter matter{Kokkos::View<std::uint8_t*>(Kokkos::view_alloc(exec, "vug::heat::matter"), nodes),
                    ScalarField<double>("vug::heat::capacity", kinds), ScalarField<double>("vug::heat::rate", kinds),
                    mineral};
  const HostWriter capacity(matter.capacity);
  capacity(0) = 1;
  for (std::size_t m = 0; m < parameters.minerals.size(); ++m) {
    require_positive("mineral diffusivity", parameters.minerals[m].diffusivity);
    require_positive("heat capacity ratio of a mineral", parameters.minerals[m].capacity_ratio);
    capacity(1 + m) = parameters.minerals[m].capacity_ratio;
  }
  set_matter_rates(parameters, 1, matter);
  return matter;
}

}  // namespace

template <class T>
HeatRates<T> heat_rates(const HeatParameters& p) {
  require_positive("fluid diffusivity", p.fluid_diffusivity);
  require_positive("solid diffusivity", p.solid_diffusivity);
  require_positive("heat capacity ratio", p.capacity_ratio);
  const auto rate = [](double diffusivity) { return static_cast<T>(rate_of(diffusivity)); };
  return {rate(p.fluid_diffusivity), rate(p.solid_diffusivity), static_cast<T>(interface_reflection(p.capacity_ratio)),
          p.capacity_ratio};
}

template <class T>
void set_heat_rates(const HeatParameters& p, double stretch, HeatFields<T>& fields) {
  fields.rates.fluid = static_cast<T>(rate_of(p.fluid_diffusivity, stretch));
  fields.rates.solid = static_cast<T>(rate_of(p.solid_diffusivity, stretch));
  if (fields.matter.given()) set_matter_rates(p, stretch, fields.matter);
}

template <class T>
struct StretchLagged {
  T stretch;
  ScalarField<T> lagged;
  KOKKOS_FUNCTION void operator()(int i) const { lagged(i) *= stretch; }
};

template <class T>
void stretch_lagged(const Exec& exec, const Share& list, double stretch, const ScalarField<T>& lagged) {
  for_each_node(exec, "vug::heat::stretch_lagged", list, StretchLagged<T>{static_cast<T>(stretch), lagged});
}

/// Sets the mask of the solid inside the lattice.
struct CopySolid {
  Kokkos::View<const NodeType*> type;
  Kokkos::View<std::uint8_t*> solid;
  KOKKOS_FORCEINLINE_FUNCTION void operator()(int node) const {
    solid(node) =
        type(node) == NodeType::opening ? inside_opening : static_cast<std::uint8_t>(type(node) == NodeType::solid);
  }
};

/// Sets the mask in the halo so that the conjugate link does nothing there: as at the node joined to it or, where there
/// is none, as at the nearest node inside or, if `marked`, to `mark`.
struct CopySolidToHalo {
  DenseNeighbour around;
  bool marked;
  std::uint8_t mark;
  Kokkos::View<std::uint8_t*> solid;

  KOKKOS_FUNCTION void copy(int x, int y) const {
    const int node = around.lattice.node(x, y);
    solid(node) = marked && around.along(node, 0) < 0 ? mark : solid(around.nearest(node, 0, 0));
  }
  /// Both ends of row `item` - 1 or, for items beyond the rows, of a column.
  KOKKOS_FUNCTION void operator()(int item) const {
    const Lattice& lattice = around.lattice;
    const int y = item - 1, x = y - lattice.ny - 1;
    if (y <= lattice.ny) {
      copy(-1, y);
      copy(lattice.nx, y);
    } else {
      copy(x, -1);
      copy(x, lattice.ny);
    }
  }
};

/// Sets the kind of matter of a node inside the lattice.
struct CopyMatter {
  Kokkos::View<const std::uint8_t*> solid, mineral;
  Kokkos::View<std::uint8_t*> matter;
  KOKKOS_FORCEINLINE_FUNCTION void operator()(int node) const {
    const std::uint8_t of_solid = static_cast<std::uint8_t>(1 + mineral(node));
    matter(node) = solid(node) > 1 ? no_matter : solid(node) ? of_solid : std::uint8_t(0);
  }
};

template <class T>
void set_heat_geometry(const Exec& exec, const Kokkos::View<NodeType*>& type, std::array<bool, 2> periodic,
                       HeatFields<T>& fields) {
  fields.periodic = periodic;
  const Lattice& lattice = fields.lattice;
  for_each_dense_node(exec, "vug::heat::copy_solid", lattice, CopySolid{type, fields.solid});
  const bool marked = fields.velocity_set == ScalarVelocitySet::d2q9;
  const DenseNeighbour around(lattice, periodic);
  const int ends = lattice.ny + 2 + lattice.nx;
  for_each_node(exec, "vug::heat::copy_solid_to_halo", ends,
                CopySolidToHalo{around, marked, outside_lattice, fields.solid});
  HeatMatter& matter = fields.matter;
  if (!matter.given()) return;
  for_each_dense_node(exec, "vug::heat::copy_matter", lattice,
                      CopyMatter{fields.solid, matter.mineral, matter.of_node});
  for_each_node(exec, "vug::heat::copy_matter_to_halo", ends,
                CopySolidToHalo{around, marked, no_matter, matter.of_node});
}

/// Sets populations at rest, g_q = w_q theta, at the nodes from `first` on.
template <class T, class Set>
struct StartHeat {
  int first, plane;
  T theta;
  ScalarField<T> g;
  KOKKOS_FUNCTION void operator()(int item) const {
    for (int q = 0; q < Set::Q; ++q) g(q * plane + first + item) = T(Set::w(q)) * theta;
  }
};

/// Runs StartHeat over the nodes of this process's rows and the halo beside them.
template <class T>
void start_heat(const Exec& exec, T theta, HeatFields<T>& fields) {
  const Lattice& lattice = fields.lattice;
  const int last_row = fields.first_row + fields.rows;
  const int first = fields.first_row == 0 ? 0 : lattice.node(-1, fields.first_row);
  const int last = last_row == lattice.ny ? lattice.size() : lattice.node(lattice.nx, last_row - 1) + 1;
  visit_velocity_set(fields.velocity_set, [&](auto set) {
    for_each_node(exec, "vug::heat::start", last - first,
                  StartHeat<T, decltype(set)>{first, lattice.size(), theta, fields.g});
  });
}

template <class T>
struct TakeTemperature {
  Temperature<T> value;
  Kokkos::View<const std::uint8_t*> solid;
  ScalarField<T> theta;
  KOKKOS_FUNCTION void operator()(int node) const { theta(node) = solid(node) > 1 ? T(0) : value(node); }
};

template <class T>
void take_temperatures(const Exec& exec, const HeatFields<T>& fields, const ScalarField<T>& theta) {
  for_each_dense_node(exec, "vug::heat::take_temperatures", fields.lattice, Rows{fields.first_row, fields.rows},
                      TakeTemperature<T>{Temperature<T>(fields), fields.solid, theta});
}

template <class T>
ScalarField<T> temperatures(const Exec& exec, const HeatFields<T>& fields) {
  const ScalarField<T> theta(Kokkos::view_alloc(exec, "vug::heat::theta"), fields.lattice.size());
  for_each_dense_node(exec, "vug::heat::temperatures", fields.lattice,
                      TakeTemperature<T>{Temperature<T>(fields), fields.solid, theta});
  return theta;
}

template <class T>
void set_heat_bands(const Exec& exec, int bands, HeatFields<T>& fields) {
  const int lines =
      visit_velocity_set(fields.velocity_set, [](auto set) { return BandLines<T, decltype(set)>::count; });
  fields.bands = std::min(bands, fields.lattice.ny);
  fields.lines = ScalarField<T>(Kokkos::view_alloc(exec, "vug::heat::lines"),
                                static_cast<std::size_t>(fields.bands) * lines * fields.lattice.pitch);
}

template <class T>
HeatFields<T> make_heat_fields(const Exec& exec, const Lattice& lattice, const HeatParameters& parameters,
                               const Kokkos::View<NodeType*>& type, std::array<bool, 2> periodic, double theta,
                               bool openings, const Kokkos::View<const std::uint8_t*>& mineral,
                               const std::optional<Rows>& rows) {
  HeatFields<T> fields;
  fields.lattice = lattice;
  fields.rates = heat_rates<T>(parameters);
  fields.velocity_set = parameters.velocity_set;
  fields.openings = openings;
  fields.first_row = rows ? rows->first : 0;
  fields.rows = rows ? rows->count : lattice.ny;
  const std::size_t size = lattice.size();
  const std::size_t slots = size * visit_velocity_set(fields.velocity_set, [](auto set) { return decltype(set)::Q; });
  fields.g = zeros<ScalarField<T>>(exec, "vug::heat::g", slots, rows.has_value());
  if constexpr (runs_on_host)
    set_heat_bands(exec, band_count(exec, lattice), fields);
  else
    fields.g_next = ScalarField<T>(Kokkos::view_alloc(exec, "vug::heat::g_next"), slots);
  fields.solid = Kokkos::View<std::uint8_t*>(Kokkos::view_alloc(exec, "vug::heat::solid"), size);
  if (!parameters.minerals.empty()) fields.matter = make_matter(exec, parameters, size, mineral);
  set_heat_geometry(exec, type, periodic, fields);
  if (fields.rows > 0) start_heat(exec, static_cast<T>(theta), fields);
  return fields;
}

VUG_COMPILE_FOR_NUMBERS(heat_rates)
VUG_COMPILE_FOR_NUMBERS(set_heat_rates)
VUG_COMPILE_FOR_NUMBERS(stretch_lagged)
VUG_COMPILE_FOR_NUMBERS(make_heat_fields)
VUG_COMPILE_FOR_NUMBERS(take_temperatures)
VUG_COMPILE_FOR_NUMBERS(temperatures)
VUG_COMPILE_FOR_NUMBERS(set_heat_bands)
VUG_COMPILE_FOR_NUMBERS(set_heat_geometry)

}  // namespace vug
