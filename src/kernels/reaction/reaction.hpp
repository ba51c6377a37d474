#pragma once
// Rate laws of the reaction L1 + S1 -> y L2 at a wall (paper Eqs. 6-8, where y = 1), as pure functions of the data of
// one wall link. Lattice units; q = 1/K_eq (0 = irreversible); every form is accurate for rate constants from 1e-30 to
// 1e30, in float as well as in double.
#include "base/base.hpp"
#include "base/exponential.hpp"

namespace vug {

/// The range in which the Arrhenius law is used; temperatures outside are clamped to it.
inline constexpr double coldest_reaction = 250;  ///< K
inline constexpr double hottest_reaction = 600;  ///< K

/// Rate constant at temperature `temperature` in K (Eq. 8): k0 exp(Ea/R (T - T0)/(T T0)), where k0 is the constant at
/// T0. One product instead of the difference 1/T0 - 1/T; T is clamped to [250, 600] K.
template <class Real>
KOKKOS_FORCEINLINE_FUNCTION Real arrhenius(Real k0, Real activation_temperature, Real temperature, Real reference) {
  const Real least = Real(coldest_reaction), most = Real(hottest_reaction);
  const Real t = temperature < least ? least : temperature > most ? most : temperature;
  return k0 * Real(exponential(static_cast<double>(activation_temperature * (t - reference) / (t * reference))));
}

/// k/(1 + k b) without overflow for large k, where it is 1/b to the last digit.
template <class Real>
KOKKOS_FORCEINLINE_FUNCTION Real saturating_rate(Real k, Real b) {
  const Real large = Real(1e20), bounded = k < large ? k : large;
  return bounded / (Real(1) + bounded * b);
}

/// Conductance of a link by the closed form of Eq. 7. With a = A/w, the outgoing populations over the weight:
/// C_1w = a1 - 3 k r, C_2w = a2 + 3 y k r, r = C_1w - q C_2w, J = 6 w k r. Hence J = conductance (A1 - q A2), in which
/// w cancels. A1 - J and A2 + y J return. The balance is exact; |A1 - J| <= A1 for q = 0 and any k.
template <class Real>
KOKKOS_FORCEINLINE_FUNCTION Real kinetic_conductance(Real k, Real q, Real y = 1) {
  return Real(6) * saturating_rate(k, Real(3) * (Real(1) + q * y));
}

/// Reaction at a wall of order n: y from x + y = a and y = b x^n, with x the concentration at the wall, a that beside
/// it and b = 3 k (for n = 1: kinetic_conductance). With beta = b a^(n - 1), s = x/a solves s + beta s^n = 1, and t =
/// s^n solves beta t + t^(1/n) = 1. The one of the two that is convex is solved by Newton's method from above, which
/// descends without passing the root. 0 where there is nothing to react.
template <class Real>
KOKKOS_INLINE_FUNCTION Real converted(Real a, Real b, Real n) {
  if (!(a > Real(0)) || !(b > Real(0))) return Real(0);
  const Real beta = b * Kokkos::pow(a, n - Real(1));
  if (!(beta < Real(1e30))) return a;
  const bool of_wall = n > Real(1);  // the unknown z is s, else t: c z + d z^power = 1
  const Real power = of_wall ? n : Real(1) / n, c = of_wall ? Real(1) : beta, d = of_wall ? beta : Real(1);
  Real z = Real(1) < Real(1) / c ? Real(1) : Real(1) / c;
  if (of_wall && beta > Real(1)) z = Kokkos::pow(beta, -Real(1) / n);
  for (int round = 0; round < 40; ++round) {
    const Real raised = d * Kokkos::pow(z, power);
    const Real step = (c * z + raised - Real(1)) / (c + power * raised / z);
    if (!(step > Real(0)) || z - step == z) break;
    z -= step;
  }
  return of_wall ? a * beta * Kokkos::pow(z, n) : a * beta * z;
}

/// Eqs. 21-22 solved without the products K_eq D1 D2: rate = conductance (C1 - q C2), from both film resistances in
/// series.
template <class Real>
KOKKOS_FORCEINLINE_FUNCTION Real paper_conductance(Real k, Real q, Real D1, Real D2, Real y = 1) {
  return saturating_rate(k, Real(0.5) / D1 + Real(0.5) * q * y / D2);
}

/// Concentrations at the wall and rate per unit face of the paper's finite-difference wall (Eqs. 21, 22, 24).
template <class Real>
struct PaperWall {
  Real C1, C2;  ///< at the wall
  Real rate;    ///< k (C1 - q C2)
};

/// The paper's wall from its paper_conductance and the concentrations at the fluid node.
template <class Real>
KOKKOS_FORCEINLINE_FUNCTION PaperWall<Real> paper_wall(Real conductance, Real q, Real D1, Real D2, Real C1, Real C2,
                                                       Real y = 1) {
  const Real rate = conductance * (C1 - q * C2);
  return {C1 - Real(0.5) * rate / D1, C2 + y * Real(0.5) * rate / D2, rate};
}

/// Share of a wall link's area that is true surface: |n.c| with n the unit normal of the surface and c the link's
/// velocity, so that the links of a stair-step wall of any orientation add up to its true length. Where the normal is
/// undefined (a lone pixel), pi/4: the mean ratio of a disc's circumference to that of its staircase.
template <class Real>
KOKKOS_FORCEINLINE_FUNCTION Real link_area_share(Real nx, Real ny, int cx, int cy) {
  const Real share = Kokkos::abs(nx * Real(cx) + ny * Real(cy));
  return nx == Real(0) && ny == Real(0) ? Real(0.78539816339744831) : share;
}

}  // namespace vug
