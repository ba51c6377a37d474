#pragma once
// The cohesive bond at one integration point: strengths, the unified linear traction-separation law and the resulting
// damage. Stresses in Pa, openings in m, tension and opening positive. Equation numbers are the paper's.
#include "base/base.hpp"
#include "dem/parameters.hpp"

namespace vug {

// By value: the references that Kokkos::max and min return keep loops from being vectorised.
KOKKOS_FORCEINLINE_FUNCTION constexpr double at_least(double bound, double x) {
  return x > bound ? x : bound;
}
KOKKOS_FORCEINLINE_FUNCTION constexpr double at_most(double bound, double x) {
  return x < bound ? x : bound;
}

/// The fit at chemical damage d_c.
KOKKOS_FORCEINLINE_FUNCTION constexpr double value_of(const QuadraticFit& fit, double d_c) {
  return (fit.square * d_c + fit.linear) * d_c + fit.constant;
}

/// d_c from 0 to 1 at which a fit that falls at first has its minimum, 1 if it falls all the way.
constexpr double turning_point(const QuadraticFit& fit) {
  return fit.square > 0 && -fit.linear < 2 * fit.square ? -fit.linear / (2 * fit.square) : 1;
}

/// The fits of a ChemicalDamageLaw as they act on a bond (Eqs. 27, 29).
struct ChemicalFactors {
  QuadraticFit f1, f2;
  double f1_unit, f2_unit;  ///< by which they are divided: their values at d_c = 0 if normalised, else 1
  double turning;           ///< d_c beyond which f2 would rise and dissolved rock become tougher; f2 is constant there
  double failure_at;        ///< a bond fails at this d_c

  explicit ChemicalFactors(const ChemicalDamageLaw& law)
      : f1(law.strength),
        f2(law.energy),
        f1_unit(law.normalised ? law.strength.constant : 1),
        f2_unit(law.normalised ? law.energy.constant : 1),
        turning(turning_point(law.energy)),
        failure_at(law.failure_at) {}

  /// Share of the strength left at d_c.
  KOKKOS_FORCEINLINE_FUNCTION double strength(double d_c) const { return value_of(f1, d_c) / f1_unit; }
  /// Share of the fracture energy left at d_c.
  KOKKOS_FORCEINLINE_FUNCTION double energy(double d_c) const {
    const double d = d_c < turning ? d_c : turning;
    return value_of(f2, d) / f2_unit;
  }
};

/// Shear strength by Mohr-Coulomb: c + tan(phi) <-sigma_n>. Compression increases it, tension does not reduce it.
KOKKOS_FORCEINLINE_FUNCTION constexpr double shear_strength(double cohesion, double tan_phi, double sigma_n) {
  return cohesion + tan_phi * at_least(0, -sigma_n);
}

/// Stiffness and strengths of one integration point at its current chemical damage.
struct BondPoint {
  double k_n;      ///< M_n (1 - d_c) / L, Pa/m
  double k_t;      ///< M_t (1 - d_c) / L, Pa/m
  double sigma_n;  ///< normal strength, Pa
  double sigma_t;  ///< shear strength at the current normal stress, Pa
  double G_I;      ///< N/m
  double G_II;     ///< N/m
};

/// Square of the undamaged stress over the strength ellipse: 1 or more means damage (Eq. 11).
KOKKOS_FORCEINLINE_FUNCTION double ellipse(const BondPoint& p, double delta_n, double delta_t) {
  constexpr double smallest = 1e-300, largest = 1e100;  // a strength may be zero
  const double n = p.k_n * at_least(0, delta_n) / at_least(smallest, p.sigma_n);
  const double t = p.k_t * delta_t / at_least(smallest, p.sigma_t);
  return at_most(largest, n * n + t * t);
}

/// Whether the undamaged stress is on the strength ellipse or beyond it; without divisions, because a strength may be
/// zero.
KOKKOS_FORCEINLINE_FUNCTION constexpr bool is_overstressed(const BondPoint& p, double delta_n, double delta_t) {
  const double n = p.k_n * at_least(0, delta_n) * p.sigma_t, t = p.k_t * delta_t * p.sigma_n;
  const double strength = p.sigma_n * p.sigma_t;
  return n * n + t * t >= strength * strength;
}

/// Damage that the unified linear law gives for an opening. With the mixity of the current opening delta_e,
///   delta_0 = delta_e / r,                       r = sqrt(ellipse)                     (onset, Eq. 11)
///   delta_f = 2 delta_e r / W,                   W = k_n <delta_n>^2 / G_I + k_t delta_t^2 / G_II
///   d_m     = delta_f (delta_e - delta_0) / (delta_e (delta_f - delta_0)) = 2 r (r - 1) / (2 r^2 - W),
/// so that the equivalent stress falls linearly from the ellipse to zero and W_I/G_I + W_II/G_II = 1 on a proportional
/// path. If delta_f <= delta_0 (stored energy above G), the bond snaps: d_m = 1 at once.
KOKKOS_FORCEINLINE_FUNCTION double damage_of_opening(const BondPoint& p, double delta_n, double delta_t) {
  constexpr double smallest = 1e-300, largest = 1e100;
  const double opening = at_least(0, delta_n);
  const double e = ellipse(p, delta_n, delta_t);
  const double r = Kokkos::sqrt(e);
  const double w = at_most(largest * largest, p.k_n * opening * opening / at_least(smallest, p.G_I) +
                                                  p.k_t * delta_t * delta_t / at_least(smallest, p.G_II));
  const double span = 2 * e - w;
  const double softening = span > 0 ? at_most(1, 2 * r * (r - 1) / span) : 1.0;
  return r > 1 ? softening : 0.0;
}

/// Whether the onset is by tension rather than by shear: the larger term of Eq. 11.
KOKKOS_FORCEINLINE_FUNCTION bool onset_in_tension(const BondPoint& p, double delta_n, double delta_t) {
  constexpr double smallest = 1e-300;
  return p.k_n * at_least(0, delta_n) * at_least(smallest, p.sigma_t) >
         p.k_t * Kokkos::abs(delta_t) * at_least(smallest, p.sigma_n);
}

/// Energy per area that damage can release between the openings of two moments, J/m2: k delta delta' / 2, the form that
/// the leapfrog keeps (accounts.hpp). Compression is not degraded and releases nothing.
KOKKOS_FORCEINLINE_FUNCTION constexpr double undamaged_energy(const BondPoint& p, double delta_n, double delta_n_before,
                                                              double delta_t, double delta_t_before) {
  return 0.5 * (p.k_n * at_least(0, delta_n) * at_least(0, delta_n_before) + p.k_t * delta_t * delta_t_before);
}

/// Share of the normal stiffness that damage leaves: 1 in compression, 1 - d_m in tension (Eq. 12).
KOKKOS_FORCEINLINE_FUNCTION constexpr double normal_integrity(double d_m, double delta_n) {
  return delta_n > 0 ? 1 - d_m : 1;
}

}  // namespace vug
