#include "kernels/open_boundary.hpp"

#include "kernels/launch.hpp"

#include <algorithm>
#include <cmath>

namespace vug {

/// Density given; no velocity along the surface.
template <class T>
struct PressureRule {
  static constexpr bool slides = false;
  T value;  ///< 3 p
  KOKKOS_FORCEINLINE_FUNCTION T density() const { return value; }
};

/// Density of the step; the nodes' velocity along the surface.
template <class T>
struct OutflowRule {
  static constexpr bool slides = true;
  Kokkos::View<const double*> level;
  KOKKOS_FORCEINLINE_FUNCTION T density() const { return T(level(1)); }
};

/// Dresses each pair of links that are images of each other by a rule, from the first of them, and books the change of
/// mass of either. Touches a population, a velocity and 25 bytes of lists and ledger per link.
template <class T, class Rule>
struct DressMirrored {
  Kokkos::View<const int*> fluid;
  Kokkos::View<const std::uint8_t*> direction;
  Kokkos::View<const int*> mirror;
  ScalarField<T> f;
  VectorField<T> u;
  ScalarField<double> gain;
  int capacity;
  Rule rule;

  KOKKOS_FUNCTION void operator()(int link) const {
    const int image = mirror(link);
    if (image < link) return;  // a wall, or dressed from its image
    const T here = returned(link, image), there = returned(image, link), slip = slide(link, image);
    bring_in(link, there - slip);
    if (image != link) bring_in(image, here + slip);
  }

 private:
  /// What goes out along `image` and comes in where `link` does: -A + w [rho' + 9/2 (c.u)^2 - 3/2 u^2] of both, the
  /// velocity along the surface turned round with the image unless fluid may slide.
  KOKKOS_FORCEINLINE_FUNCTION T returned(int image, int link) const {
    const int i = fluid(image), q = direction(image);
    return even(q, i) + even(Rule::slides ? direction(link) : q, i) - f(q * capacity + i);
  }
  KOKKOS_FORCEINLINE_FUNCTION T even(int q, int i) const {
    const T rho = rule.density(), ux = u(i, 0), uy = u(i, 1);
    return T(0.5) * (equilibrium(q, rho, ux, uy) + equilibrium(D2Q9::opposite(q), rho, ux, uy));
  }
  /// 6 w t.u with the mean velocity of both nodes and the part t of the direction that lies in the surface.
  KOKKOS_FORCEINLINE_FUNCTION T slide(int link, int image) const {
    if constexpr (!Rule::slides) return T(0);
    const int i = fluid(link), j = fluid(image), q = direction(link), p = direction(image);
    const T along =
        T(D2Q9::c(q, 0) - D2Q9::c(p, 0)) * (u(i, 0) + u(j, 0)) + T(D2Q9::c(q, 1) - D2Q9::c(p, 1)) * (u(i, 1) + u(j, 1));
    return T(1.5 * D2Q9::w(q)) * along;
  }
  KOKKOS_FORCEINLINE_FUNCTION void bring_in(int link, T incoming) const {
    const int slot = direction(link) * capacity + fluid(link);
    gain(link) += double(incoming) - double(f(slot));
    f(slot) = incoming;
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

/// The same with a share of the velocity on each link.
template <class T>
struct VelocityProfileRule {
  T ux, uy;
  Kokkos::View<const double*> share;
  KOKKOS_FORCEINLINE_FUNCTION T operator()(int link, int i, int q, T outgoing) const {
    const T here = T(share(link));
    return VelocityRule<T>{here * ux, here * uy}(link, i, q, outgoing);
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

template <class T, class Rule>
void dress_mirrored(const Exec& exec, const std::string& label, const FluidNodes& nodes, const BoundaryLinks& links,
                    const IndexList& mirror, const FlowFields<T>& fields, const ScalarField<double>& gain,
                    const Rule& rule) {
  for_each_node(
      exec, label, links.count,
      DressMirrored<T, Rule>{links.fluid, links.direction, mirror, fields.f, fields.u, gain, nodes.capacity, rule});
}

}  // namespace

template <class T>
void dress_pressure(const Exec& exec, const FluidNodes& nodes, const BoundaryLinks& links, const IndexList& mirror,
                    double pressure, const FlowFields<T>& fields, const ScalarField<double>& gain) {
  dress_mirrored(exec, "vug::open_boundary::pressure", nodes, links, mirror, fields, gain,
                 PressureRule<T>{T(3 * pressure)});
}

template <class T>
void dress_velocity(const Exec& exec, const FluidNodes& nodes, const BoundaryLinks& links,
                    std::array<double, 2> velocity, const FlowFields<T>& fields, const ScalarField<double>& gain) {
  dress(exec, "vug::open_boundary::velocity", nodes, links, fields, gain,
        VelocityRule<T>{T(velocity[0]), T(velocity[1])});
}

template <class T>
void dress_velocity(const Exec& exec, const FluidNodes& nodes, const BoundaryLinks& links,
                    std::array<double, 2> velocity, const ScalarField<double>& share, const FlowFields<T>& fields,
                    const ScalarField<double>& gain) {
  if (share.extent(0) == 0) return dress_velocity(exec, nodes, links, velocity, fields, gain);
  dress(exec, "vug::open_boundary::velocity_profile", nodes, links, fields, gain,
        VelocityProfileRule<T>{T(velocity[0]), T(velocity[1]), share});
}

template <class T>
void dress_normal_speed(const Exec& exec, const FluidNodes& nodes, const BoundaryLinks& links,
                        const ScalarField<double>& area, double speed, const FlowFields<T>& fields,
                        const ScalarField<double>& gain) {
  dress(exec, "vug::open_boundary::normal_speed", nodes, links, fields, gain, NormalSpeedRule<T>{area, speed});
}

struct IsFace {
  Kokkos::View<const std::uint8_t*> direction;
  KOKKOS_FUNCTION void operator()(int link, int& faces) const { faces += direction(link) < D2Q5::Q; }
};

void fit_to_links(const Exec& exec, const BoundaryLinks& links, OutflowState& state) {
  int faces = 0;
  Kokkos::parallel_reduce("vug::open_boundary::faces", Kokkos::RangePolicy<Exec>(exec, 0, links.count),
                          IsFace{links.direction}, faces);
  state.faces = faces;
  state.speed = ScalarField<double>("vug::open_boundary::speed", block_count(links.count));
  Kokkos::resize(exec, state.level, 2);
}

/// Outward speed through a face.
template <class T>
struct OutwardSpeed {
  Kokkos::View<const int*> fluid;
  Kokkos::View<const std::uint8_t*> direction;
  VectorField<T> u;
  KOKKOS_FUNCTION double operator()(int link) const {
    const int i = fluid(link), q = direction(link);
    return q < D2Q5::Q ? D2Q9::c(q, 0) * double(u(i, 0)) + D2Q9::c(q, 1) * double(u(i, 1)) : 0;
  }
};

/// rho' = 3 c_s (U - U_0), then U_0 += share (U - U_0), with the mean speed U whose sums it clears.
struct SetOutflowLevel {
  ScalarField<double> speed, level;
  double faces, share;
  KOKKOS_FUNCTION void operator()(int) const {
    double sum = 0;
    for (std::size_t block = 0; block < speed.extent(0); ++block) {
      sum += speed(block);
      speed(block) = 0;
    }
    const double change = sum / faces - level(0);
    level(1) = 3 * Kokkos::sqrt(c_s2) * change;
    level(0) += share * change;
  }
};

template <class T>
void dress_outflow(const Exec& exec, const FluidNodes& nodes, const BoundaryLinks& links, const IndexList& mirror,
                   const OutflowState& state, const FlowFields<T>& fields, const ScalarField<double>& gain) {
  if (state.faces == 0) return;
  const double crossing = std::max(nodes.lattice.nx, nodes.lattice.ny) / std::sqrt(c_s2);
  add_per_block(exec, "vug::open_boundary::outward_speed", links.count,
                OutwardSpeed<T>{links.fluid, links.direction, fields.u}, state.speed);
  for_each_node(exec, "vug::open_boundary::outflow_level", 1,
                SetOutflowLevel{state.speed, state.level, state.faces, 1 / (4 * crossing)});
  dress_mirrored(exec, "vug::open_boundary::outflow", nodes, links, mirror, fields, gain, OutflowRule<T>{state.level});
}

#define VUG_INSTANTIATE(T)                                                                                           \
  template void dress_pressure(const Exec&, const FluidNodes&, const BoundaryLinks&, const IndexList&, double,       \
                               const FlowFields<T>&, const ScalarField<double>&);                                    \
  template void dress_velocity(const Exec&, const FluidNodes&, const BoundaryLinks&, std::array<double, 2>,          \
                               const FlowFields<T>&, const ScalarField<double>&);                                    \
  template void dress_velocity(const Exec&, const FluidNodes&, const BoundaryLinks&, std::array<double, 2>,          \
                               const ScalarField<double>&, const FlowFields<T>&, const ScalarField<double>&);        \
  template void dress_normal_speed(const Exec&, const FluidNodes&, const BoundaryLinks&, const ScalarField<double>&, \
                                   double, const FlowFields<T>&, const ScalarField<double>&);                        \
  template void dress_outflow(const Exec&, const FluidNodes&, const BoundaryLinks&, const IndexList&,                \
                              const OutflowState&, const FlowFields<T>&, const ScalarField<double>&);
VUG_INSTANTIATE(float)
VUG_INSTANTIATE(double)
#undef VUG_INSTANTIATE

}  // namespace vug
