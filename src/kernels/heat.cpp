#include "kernels/heat.hpp"

#include "kernels/conjugate_link.hpp"
#include "kernels/require.hpp"
#include "kernels/row_launch.hpp"
#include "kernels/scalar_equilibrium.hpp"
#include "kernels/unroll.hpp"

#include <cmath>
#include <string>
#include <utility>

namespace vug {

namespace {

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

/// Mask of the solid, continued into the halo so that the conjugate link is inert there: like the node joined to it,
/// and where there is none, like the nearest node inside or, if `marked`, as outside.
struct CopySolid {
  Lattice lattice;
  bool periodic_x, periodic_y, marked;
  Kokkos::View<const NodeType*> type;
  Kokkos::View<std::uint8_t*> solid;

  KOKKOS_FUNCTION static int source(int p, int n, bool periodic) {
    if (periodic) return (p + n) % n;
    return p < 0 ? 0 : p >= n ? n - 1 : p;
  }
  KOKKOS_FUNCTION void operator()(int node) const {
    const int x = lattice.x(node);
    const int y = lattice.y(node);
    if (x < -1 || x > lattice.nx) return;
    const bool outside = (!periodic_x && (x < 0 || x == lattice.nx)) || (!periodic_y && (y < 0 || y == lattice.ny));
    const int from = lattice.node(source(x, lattice.nx, periodic_x), source(y, lattice.ny, periodic_y));
    solid(node) = outside && marked                 ? outside_lattice
                  : type(from) == NodeType::opening ? inside_opening
                                                    : static_cast<std::uint8_t>(type(from) == NodeType::solid);
  }
};

template <class T>
void set_heat_geometry(const Exec& exec, const Kokkos::View<NodeType*>& type, std::array<bool, 2> periodic,
                       HeatFields<T>& fields) {
  for_each_node(exec, "vug::heat::copy_solid", fields.lattice.size(),
                CopySolid{fields.lattice, periodic[0], periodic[1], fields.velocity_set == ScalarVelocitySet::d2q9,
                          type, fields.solid});
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
  fields.g_next = ScalarField<T>(Kokkos::view_alloc(exec, "vug::heat::g_next"), slots);
  fields.theta = ScalarField<T>(Kokkos::view_alloc(exec, "vug::heat::theta"), size);
  fields.solid = Kokkos::View<std::uint8_t*>(Kokkos::view_alloc(exec, "vug::heat::solid"), size);
  set_heat_geometry(exec, type, periodic, fields);
  for_each_dense_node(exec, "vug::heat::fill", lattice,
                      FillTemperature<T>{static_cast<T>(theta), fields.solid, fields.theta});
  start_heat(exec, fields);
  return fields;
}

/// Conduction in fluid and solid (paper Eqs. 3, 4): g_q(x, t+1) is what arrives through the conjugate link, and the
/// collision relaxes its odd part with s, its even part with s_plus towards w_q T. With Lambda = 1/4, s_plus = 2 - s,
/// so
///     g_q* = (s - 1) g_opposite(q) + (2 - s) w_q T,
/// s being the rate of the node's own material. The population at rest is what remains of T, which conserves it to
/// the last digit at any precision. Dense fields; lattice units. Reads Q populations and a byte, writes Q and theta.
/// With `Openings` it passes over the nodes inside them.
template <class T, class Set, bool Openings>
struct Conduct {
  int pitch, plane;
  T fluid_rate, rate_step, reflection;
  Kokkos::View<const T*> g;
  Kokkos::View<const std::uint8_t*> solid;
  ScalarField<T> g_next, theta;

  KOKKOS_FORCEINLINE_FUNCTION int offset(int q) const { return Set::c(q, 1) * pitch + Set::c(q, 0); }

  KOKKOS_FORCEINLINE_FUNCTION T solid_beyond(int beyond, T solid_here) const {
    if constexpr (Set::Q == D2Q5::Q && !Openings)
      return static_cast<T>(solid(beyond));
    else
      return solid(beyond) > 1 ? solid_here : static_cast<T>(solid(beyond));
  }

  KOKKOS_FORCEINLINE_FUNCTION T arriving(int node, int q, T solid_here) const {
    const int beyond = node - offset(q);
    return conjugate_link(g(q * plane + beyond), g(Set::opposite(q) * plane + node), reflection, solid_here,
                          solid_beyond(beyond, solid_here));
  }

  KOKKOS_FORCEINLINE_FUNCTION void operator()(int node) const {
    if constexpr (Openings)
      if (solid(node) > 1) return;
    const T solid_here = static_cast<T>(solid(node));
    T in[Set::Q];
    in[0] = g(node);
    T temperature = in[0];
    VUG_UNROLL
    for (int q = 1; q < Set::Q; ++q) temperature += in[q] = arriving(node, q, solid_here);
    const T s = fluid_rate + solid_here * rate_step;
    const T even = (2 - s) * temperature;
    T rest = temperature;
    VUG_UNROLL
    for (int q = 1; q < Set::Q; ++q) {
      const T out = (s - 1) * in[Set::opposite(q)] + T(Set::w(q)) * even;
      g_next(q * plane + node) = out;
      rest -= out;
    }
    g_next(node) = rest;
    theta(node) = temperature;
  }
};

namespace {

template <class T, class Set, bool Openings>
void launch_conduct(const Exec& exec, const HeatFields<T>& fields) {
  const HeatRates<T>& rates = fields.rates;
  for_each_dense_node(
      exec, "vug::heat::conduct", fields.lattice,
      Conduct<T, Set, Openings>{fields.lattice.pitch, fields.lattice.size(), rates.fluid, rates.solid - rates.fluid,
                                rates.reflection, fields.g, fields.solid, fields.g_next, fields.theta});
}

}  // namespace

template <class T>
void conduct(const Exec& exec, HeatFields<T>& fields) {
  visit_velocity_set(fields.velocity_set, [&](auto set) {
    if (fields.openings)
      launch_conduct<T, decltype(set), true>(exec, fields);
    else
      launch_conduct<T, decltype(set), false>(exec, fields);
  });
  std::swap(fields.g, fields.g_next);
}

/// What the flow adds to the post-collision populations of one fluid node; the collision is linear, so this may follow
/// `Conduct`. Carried: g_q* += s w_q T 3 c_q.u, and on D2Q9 the even part of the equilibrium with its own rate, 2 - s.
/// Towards solid and closed sides that part stays at its node, in the population at rest: only conducted heat crosses a
/// wall. The advective form (advective_form.hpp) takes T e' from the
/// population at rest before the collision, e' being what streaming has added to a uniform temperature: the carried
/// part builds up over the relaxation time, so e' lags behind e in the same way, e' = (1 - s) e' + s e. A uniform
/// temperature then stays uniform to round-off in any flow, steady or not. Returns the energy added, -T e'.
template <class T, class Set>
struct Advect {
  int plane;
  T rate;
  IndexList node;
  Kokkos::View<const std::uint16_t*> solid_links, side_links, open_links;
  Kokkos::View<const T* [2], Kokkos::LayoutLeft> u;
  Kokkos::View<const T*> defect;
  ScalarField<T> lagged, g, theta;

  /// Carried along direction q, over w_q T.
  KOKKOS_FORCEINLINE_FUNCTION T carried(int q, T ux, T uy) const {
    const T odd = 3 * (Set::c(q, 0) * ux + Set::c(q, 1) * uy);
    if constexpr (Set::Q == D2Q5::Q)
      return rate * odd;
    else
      return rate * odd + (2 - rate) * (scalar_equilibrium<Set, T>(q, ux, uy) - 1 - odd);
  }

  KOKKOS_FUNCTION double operator()(int i) const {
    const int n = node(i);
    const T excess = lagged(i) + rate * (defect(i) - lagged(i));
    const T added = -theta(n) * excess / (1 + excess);
    const T temperature = theta(n) + added;
    const unsigned walls = solid_links(i) | (side_links(i) & ~open_links(i));
    T rest = added;
    VUG_UNROLL
    for (int q = 1; q < Set::Q; ++q) {
      const T along = (walls >> q & 1u) ? T(0) : temperature * carried(q, u(i, 0), u(i, 1));
      const T change = T(Set::w(q)) * ((2 - rate) * added + along);
      g(q * plane + n) += change;
      rest -= change;
    }
    g(n) += rest;
    theta(n) = temperature;
    lagged(i) = excess;
    return static_cast<double>(added);
  }
};

template <class T>
void advect(const Exec& exec, const FluidNodes& nodes, const VectorField<T>& u, const ScalarField<T>& defect,
            const ScalarField<T>& lagged, HeatFields<T>& fields, const ScalarField<double>& created) {
  visit_velocity_set(fields.velocity_set, [&](auto set) {
    const Advect<T, decltype(set)> body{fields.lattice.size(),
                                        fields.rates.fluid,
                                        nodes.node,
                                        nodes.solid_links,
                                        nodes.side_links,
                                        nodes.open_links,
                                        u,
                                        defect,
                                        lagged,
                                        fields.g,
                                        fields.theta};
    if (created.extent(0) > 0)
      add_per_block(exec, "vug::heat::advect", nodes.count, body, created);
    else
      for_each_node(exec, "vug::heat::advect", nodes.count, body);
  });
}

#define VUG_INSTANTIATE(T)                                                                                           \
  template HeatRates<T> heat_rates<T>(const HeatParameters&);                                                        \
  template HeatFields<T> make_heat_fields<T>(const Exec&, const Lattice&, const HeatParameters&,                     \
                                             const Kokkos::View<NodeType*>&, std::array<bool, 2>, double, bool);     \
  template void start_heat(const Exec&, HeatFields<T>&);                                                             \
  template void set_heat_geometry(const Exec&, const Kokkos::View<NodeType*>&, std::array<bool, 2>, HeatFields<T>&); \
  template void conduct(const Exec&, HeatFields<T>&);                                                                \
  template void advect(const Exec&, const FluidNodes&, const VectorField<T>&, const ScalarField<T>&,                 \
                       const ScalarField<T>&, HeatFields<T>&, const ScalarField<double>&)
VUG_INSTANTIATE(float);
VUG_INSTANTIATE(double);
#undef VUG_INSTANTIATE

}  // namespace vug
