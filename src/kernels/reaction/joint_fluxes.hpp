#pragma once
// Reactions at one link that read what others of them change: all fluxes at once.
#include "kernels/reaction/reaction.hpp"

namespace vug {

/// Most reactions at a wall that may depend on each other.
inline constexpr int most_joint_reactions = 6;

/// One of them, in lattice units.
struct LinkReaction {
  double conductance = 0;  ///< kinetic_conductance; for an order other than 1 the rate constant
  double equilibrium = 0;  ///< 1/K_eq
  double yield = 1;        ///< moles of product that a mole of the reactant becomes
  double order = 1;        ///< other than 1: irreversible, at C_ref k (C/C_ref)^order
  double reference = 1;    ///< C_ref
  int reactant = 0;        ///< number of the species
  int product = -1;        ///< -1: none
};

/// What a mole turned over by reaction `by` adds to C_reactant - C_product/K_eq of reaction `of`, in moles.
KOKKOS_INLINE_FUNCTION double drive(const LinkReaction& of, const LinkReaction& by) {
  const auto gain = [&](int species) {
    return (species == by.product ? by.yield : 0.0) - (species == by.reactant ? 1.0 : 0.0);
  };
  return gain(of.reactant) - (of.equilibrium != 0 ? of.equilibrium * gain(of.product) : 0.0);
}

/// Solves M x = b in place, with the solution in b. No pivots: where no circle of reactions makes more than it takes,
/// the pivots of joint_fluxes are positive. Where one does and is fast, no concentrations at the wall solve the
/// equations, and what comes out has no meaning.
template <int Most>
KOKKOS_INLINE_FUNCTION void solve_in_place(double (&M)[Most][Most], double (&b)[Most], int n) {
  for (int k = 0; k < n; ++k)
    for (int i = k + 1; i < n; ++i) {
      const double part = M[i][k] / M[k][k];
      for (int j = k; j < n; ++j) M[i][j] -= part * M[k][j];
      b[i] -= part * b[k];
    }
  for (int i = n - 1; i >= 0; --i) {
    for (int j = i + 1; j < n; ++j) b[i] -= M[i][j] * b[j];
    b[i] /= M[i][i];
  }
}

/// Fluxes J (moles) of `count` reactions at a link whose outgoing populations are A(species). With A + dA what returns,
/// the concentration at the wall is (A + dA/2)/w. Each reaction therefore sees half of what the others do,
///   J_i = c_i (drive of A + 1/2 sum over m != i of drive(i, m) J_m),
/// a linear system. A reaction of another order n takes J = 2 w C_ref y from the concentration a over C_ref that it
/// sees, with y of `converted`, by Newton's method: dy/da = n y/(a - y + n y).
template <int Most>
KOKKOS_INLINE_FUNCTION void joint_fluxes(const LinkReaction (&r)[Most], int count, const double* A, double weight,
                                         double (&J)[Most]) {
  for (int i = 0; i < count; ++i) J[i] = 0;
  constexpr int rounds = 40;
  for (int round = 0; round < rounds; ++round) {
    double M[Most][Most], b[Most];
    bool linear = true;
    for (int i = 0; i < count; ++i) {
      const double outgoing = A[r[i].reactant];
      double slope = r[i].conductance, at_zero = slope * outgoing;
      if (r[i].equilibrium != 0) at_zero -= slope * r[i].equilibrium * A[r[i].product];
      if (r[i].order != 1) {
        double by_others = 0;
        for (int m = 0; m < count; ++m)
          if (m != i) by_others += 0.5 * drive(r[i], r[m]) * J[m];
        const double whole = weight * r[i].reference, n = r[i].order, a = (outgoing + by_others) / whole;
        const double y = converted(a, 3 * r[i].conductance, n);
        slope = y > 0 ? 2 * n * y / (a - y + n * y) : 0;
        at_zero = 2 * whole * y - slope * by_others;
        linear = false;
      }
      for (int m = 0; m < count; ++m) M[i][m] = m == i ? 1.0 : -slope * (0.5 * drive(r[i], r[m]));
      b[i] = at_zero;
    }
    solve_in_place(M, b, count);
    bool settled = true;
    for (int i = 0; i < count; ++i) {
      settled = settled && Kokkos::abs(b[i] - J[i]) <= 1e-15 * Kokkos::abs(b[i]);
      J[i] = b[i];
    }
    if (linear || settled) return;
  }
}

}  // namespace vug
