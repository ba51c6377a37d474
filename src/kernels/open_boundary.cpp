#include "kernels/open_boundary.hpp"

#include "kernels/launch.hpp"

namespace vug {

/// -A + 2 w [rho' + 9/2 (c.u)^2 - 3/2 u^2], with density and velocity at the opening.
template <class T>
KOKKOS_FORCEINLINE_FUNCTION T anti_bounce_back(int q, T outgoing, T rho, T ux, T uy) {
  return equilibrium(q, rho, ux, uy) + equilibrium(D2Q9::opposite(q), rho, ux, uy) - outgoing;
}

/// Density given, velocity of the node.
template <class T>
struct PressureRule {
  T density;  ///< 3 p
  VectorField<T> u;
  KOKKOS_FORCEINLINE_FUNCTION T operator()(int, int i, int q, T outgoing) const {
    return anti_bounce_back(q, outgoing, density, u(i, 0), u(i, 1));
  }
};

/// Density and velocity of the node.
template <class T>
struct OutflowRule {
  Kokkos::View<const double*> density;
  VectorField<T> u;
  KOKKOS_FORCEINLINE_FUNCTION T operator()(int link, int i, int q, T outgoing) const {
    return anti_bounce_back(q, outgoing, T(density(link)), u(i, 0), u(i, 1));
  }
};

/// f_in = A + 6 w c_in . u_w.
template <class T>
struct VelocityRule {
  T ux, uy;
  KOKKOS_FORCEINLINE_FUNCTION T operator()(int, int, int q, T outgoing) const {
    return outgoing - T(6 * D2Q9::w(q)) * (T(D2Q9::c(q, 0)) * ux + T(D2Q9::c(q, 1)) * uy);
  }
};

/// f_in = A + area speed.
template <class T>
struct NormalSpeedRule {
  Kokkos::View<const double*> area;
  double speed;
  KOKKOS_FORCEINLINE_FUNCTION T operator()(int link, int, int, T outgoing) const {
    return outgoing + T(area(link) * speed);
  }
};

/// Dresses the outgoing population of each link by a rule and books the change of mass. Touches one population and
/// 21 bytes of lists and ledger per link.
template <class T, class Rule>
struct DressLinks {
  Kokkos::View<const int*> fluid;
  Kokkos::View<const std::uint8_t*> direction;
  ScalarField<T> f;
  ScalarField<double> gain;
  int capacity;
  Rule rule;
  KOKKOS_FUNCTION void operator()(int link) const {
    const int i = fluid(link), q = direction(link);
    const T outgoing = f(q * capacity + i);
    const T incoming = rule(link, i, q, outgoing);
    f(q * capacity + i) = incoming;
    gain(link) += double(incoming) - double(outgoing);
  }
};

namespace {

template <class T, class Rule>
void dress(const Exec& exec, const std::string& label, const FluidNodes& nodes, const BoundaryLinks& links,
           const FlowFields<T>& fields, const ScalarField<double>& gain, const Rule& rule) {
  for_each_node(exec, label, links.count,
                DressLinks<T, Rule>{links.fluid, links.direction, fields.f, gain, nodes.capacity, rule});
}

}  // namespace

template <class T>
void dress_pressure(const Exec& exec, const FluidNodes& nodes, const BoundaryLinks& links, double pressure,
                    const FlowFields<T>& fields, const ScalarField<double>& gain) {
  dress(exec, "vug::open_boundary::pressure", nodes, links, fields, gain, PressureRule<T>{T(3 * pressure), fields.u});
}

template <class T>
void dress_velocity(const Exec& exec, const FluidNodes& nodes, const BoundaryLinks& links,
                    std::array<double, 2> velocity, const FlowFields<T>& fields, const ScalarField<double>& gain) {
  dress(exec, "vug::open_boundary::velocity", nodes, links, fields, gain,
        VelocityRule<T>{T(velocity[0]), T(velocity[1])});
}

template <class T>
void dress_normal_speed(const Exec& exec, const FluidNodes& nodes, const BoundaryLinks& links,
                        const ScalarField<double>& area, double speed, const FlowFields<T>& fields,
                        const ScalarField<double>& gain) {
  dress(exec, "vug::open_boundary::normal_speed", nodes, links, fields, gain, NormalSpeedRule<T>{area, speed});
}

template <class T>
struct TakeDensity {
  Kokkos::View<const int*> fluid;
  Density<T> value;
  ScalarField<double> density;
  KOKKOS_FUNCTION void operator()(int link) const { density(link) = static_cast<double>(value(fluid(link))); }
};

template <class T>
void take_density(const Exec& exec, const FluidNodes& nodes, const BoundaryLinks& links, const FlowFields<T>& fields,
                  const ScalarField<double>& density) {
  for_each_node(exec, "vug::open_boundary::density", links.count,
                TakeDensity<T>{links.fluid, Density<T>(nodes, fields), density});
}

template <class T>
void dress_outflow(const Exec& exec, const FluidNodes& nodes, const BoundaryLinks& links,
                   const ScalarField<double>& density, const FlowFields<T>& fields, const ScalarField<double>& gain) {
  dress(exec, "vug::open_boundary::outflow", nodes, links, fields, gain, OutflowRule<T>{density, fields.u});
}

#define VUG_INSTANTIATE(T)                                                                                           \
  template void dress_pressure(const Exec&, const FluidNodes&, const BoundaryLinks&, double, const FlowFields<T>&,   \
                               const ScalarField<double>&);                                                          \
  template void dress_velocity(const Exec&, const FluidNodes&, const BoundaryLinks&, std::array<double, 2>,          \
                               const FlowFields<T>&, const ScalarField<double>&);                                    \
  template void dress_normal_speed(const Exec&, const FluidNodes&, const BoundaryLinks&, const ScalarField<double>&, \
                                   double, const FlowFields<T>&, const ScalarField<double>&);                        \
  template void take_density(const Exec&, const FluidNodes&, const BoundaryLinks&, const FlowFields<T>&,             \
                             const ScalarField<double>&);                                                            \
  template void dress_outflow(const Exec&, const FluidNodes&, const BoundaryLinks&, const ScalarField<double>&,      \
                              const FlowFields<T>&, const ScalarField<double>&);
VUG_INSTANTIATE(float)
VUG_INSTANTIATE(double)
#undef VUG_INSTANTIATE

}  // namespace vug
