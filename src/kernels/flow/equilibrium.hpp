#pragma once
// The incompressible equilibrium of D2Q9 in pressure form. Populations are deviations from rest at the reference
// pressure: f = 0 is fluid at rest there, so that creeping flow keeps its digits in float.
#include "base/velocity_set.hpp"

namespace vug {

/// Gauge density rho' = 3 p' and velocity of one node, lattice units (reference density 1, so u is the momentum).
template <class T>
struct Macroscopic {
  T rho, ux, uy;
};

/// feq_q = w_q [rho' + 3 c.u + 9/2 (c.u)^2 - 3/2 u^2], the incompressible form of He and Luo.
template <class T>
KOKKOS_FORCEINLINE_FUNCTION constexpr T equilibrium(int q, T rho, T ux, T uy) {
  const T cu = along(q, ux, uy);
  return T(D2Q9::w(q)) * (rho + T(3) * cu + T(4.5) * cu * cu - T(1.5) * (ux * ux + uy * uy));
}

/// rho' = sum f_q, u = sum c_q f_q: one node's moments of order 0 and 1.
template <class T>
KOKKOS_FORCEINLINE_FUNCTION constexpr Macroscopic<T> macroscopic(const T (&f)[9]) {
  const T d57 = f[5] - f[7], d86 = f[8] - f[6];
  return {f[0] + ((f[1] + f[3]) + (f[2] + f[4])) + ((f[5] + f[7]) + (f[6] + f[8])), (f[1] - f[3]) + (d57 + d86),
          (f[2] - f[4]) + (d57 - d86)};
}

}  // namespace vug
