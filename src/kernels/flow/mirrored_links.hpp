#pragma once
// What enters through the links of pressures and outflows, along each of which comes what leaves along its mirror
// image.
#include "kernels/flow/equilibrium.hpp"
#include "kernels/flow/open_boundary.hpp"

namespace vug {

/// Rule of a pressure: given density, no velocity along the surface.
template <class T>
struct PressureRule {
  static constexpr bool slides = false;
  T value;  ///< 3 p
  KOKKOS_FORCEINLINE_FUNCTION T density(int) const { return value; }
};

/// Rule of an outflow: density of this step, with its variation along the surface; the nodes' velocity along it.
template <class T>
struct OutflowRule {
  static constexpr bool slides = true;
  FlowCondition links;
  KOKKOS_FORCEINLINE_FUNCTION T density(int link) const {
    const int face = links.face[link];
    return T(face < 0 ? links.level[1] : links.level[1] + links.along[face]);
  }
};

/// Dresses both links of each pair of mirror images by a rule, in the call for the first of them, and books the change
/// of mass of either. Touches a population, a velocity and 25 bytes of lists and ledger per link.
template <class T, class Rule>
struct DressMirrored {
  FlowCondition links;
  ScalarField<T> f;
  VectorField<T> u;
  int capacity;
  Rule rule;

  KOKKOS_FUNCTION void operator()(int item) const {
    const int link = links.link(item), image = links.mirror[link];
    if (image < 0) return dress_past_end(link);
    if (image < link) return;  // dressed in the call for its image
    const T here = returned(link, image), there = returned(image, link), slip = slide(link, image);
    bring_in(link, there - slip);
    if (image != link) bring_in(image, here + slip);
  }

 private:
  /// The population that leaves along `image`, returned along `link`: -A + w [rho' + 9/2 (c.u)^2 - 3/2 u^2] of both
  /// directions; the velocity along the surface is reversed with the image unless fluid may slide.
  KOKKOS_FORCEINLINE_FUNCTION T returned(int image, int link) const {
    const int i = links.fluid[image], q = links.direction[image];
    return returned(i, q, f(q * capacity + i), rule.density(image), links.direction[link]);
  }
  KOKKOS_FORCEINLINE_FUNCTION T returned(int i, int q, T leaving, T rho, int along) const {
    return even(q, i, rho) + even(Rule::slides ? along : q, i, rho) - leaving;
  }
  /// f_in = A - 6 w max(c.u, 0): what flows out of a corner takes the velocity of its node; nothing flows in.
  KOKKOS_FORCEINLINE_FUNCTION T carried_out(int link) const {
    const int i = links.fluid[link], q = links.direction[link];
    const T out = T(D2Q9::c(q, 0)) * u(i, 0) + T(D2Q9::c(q, 1)) * u(i, 1);
    return f(q * capacity + i) - T(6 * D2Q9::w(q)) * Kokkos::max(out, T(0));
  }
  KOKKOS_FORCEINLINE_FUNCTION T even(int q, int i, T rho) const {
    const T ux = u(i, 0), uy = u(i, 1);
    return T(0.5) * (equilibrium(q, rho, ux, uy) + equilibrium(D2Q9::opposite(q), rho, ux, uy));
  }
  /// 6 w t.u, where u is the mean velocity of both nodes and t the part of the link's direction along the surface.
  KOKKOS_FORCEINLINE_FUNCTION T slide(int link, int image) const {
    return slide(link, links.fluid[image], links.direction[image]);
  }
  KOKKOS_FORCEINLINE_FUNCTION T slide(int link, int j, int p) const {
    if constexpr (!Rule::slides) return T(0);
    const int i = links.fluid[link], q = links.direction[link];
    const T along =
        T(D2Q9::c(q, 0) - D2Q9::c(p, 0)) * (u(i, 0) + u(j, 0)) + T(D2Q9::c(q, 1) - D2Q9::c(p, 1)) * (u(i, 1) + u(j, 1));
    return T(1.5 * D2Q9::w(q)) * along;
  }
  /// A link without an image in this stretch: one past an end, or a wall.
  KOKKOS_FUNCTION void dress_past_end(int link) const {
    for (int end = 0; end < 2; ++end) {
      if (links.ends.link[end] == link) {
        const int q = links.direction[link];
        const double* const given = links.ends.velocity[end];
        const T across = T(D2Q9::c(q, 0) * given[0] + D2Q9::c(q, 1) * given[1]);
        return bring_in(link, f(q * capacity + links.fluid[link]) - T(6 * D2Q9::w(q)) * across);
      }
      if (links.past == nullptr || links.past[end].link != link) continue;
      const LinkPastEnd& image = links.past[end];
      if (image.fluid < 0) return bring_in(link, carried_out(link));
      const T returns =
          returned(image.fluid, image.direction, T(image.leaving), rule.density(link), links.direction[link]);
      return bring_in(link, returns - slide(link, image.fluid, image.direction));
    }
  }
  KOKKOS_FORCEINLINE_FUNCTION void bring_in(int link, T incoming) const {
    const int slot = links.direction[link] * capacity + links.fluid[link];
    links.gain[link] += double(incoming) - double(f(slot));
    f(slot) = incoming;
  }
};

/// Takes the populations that leave along images of other stretches, before these are dressed.
template <class T>
struct TakePastEnds {
  using Entry = FlowCondition;
  ScalarField<T> f;
  int capacity;
  static int count(const FlowCondition& c) { return c.past ? 2 : 0; }
  template <class Run>
  KOKKOS_FUNCTION void operator()(const FlowCondition& c, const Run& run) const {
    run([c, populations = f, stride = capacity](int end) {
      LinkPastEnd& image = c.past[end];
      if (image.fluid >= 0) image.leaving = double(populations(image.direction * stride + image.fluid));
    });
  }
};

}  // namespace vug
