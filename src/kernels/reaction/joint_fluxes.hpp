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

/// Solves M x = b in place, with the solution in b. No pivots: the matrix of joint_fluxes is that of resistances.
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

/// Fluxes J (moles) of n reactions at a link whose outgoing populations are A(species). With A + dA what returns, the
/// concentration at the wall is (A + dA/2)/w. Each reaction therefore sees half of what the others do,
///   J_i = c_i (drive of A + 1/2 sum over m != i of drive(i, m) J_m),
/// a linear system. A reaction of another order takes its flux from what it sees, in rounds; those of which no other
/// changes the reactant are known after the first.
template <int Most>
KOKKOS_INLINE_FUNCTION void joint_fluxes(const LinkReaction (&r)[Most], int n, const double* A, double weight,
                                         double (&J)[Most]) {
  for (int i = 0; i < n; ++i) J[i] = 0;
  constexpr int rounds = 40;
  for (int round = 0; round < rounds; ++round) {
    double M[Most][Most], b[Most];
    bool linear = true;
    for (int i = 0; i < n; ++i) {
      const bool first_order = r[i].order == 1;
      linear = linear && first_order;
      double seen = A[r[i].reactant] - (r[i].equilibrium != 0 ? r[i].equilibrium * A[r[i].product] : 0.0);
      for (int m = 0; m < n; ++m) {
        const double share = m == i ? 0.0 : 0.5 * drive(r[i], r[m]);
        M[i][m] = m == i ? 1.0 : first_order ? -r[i].conductance * share : 0.0;
        if (!first_order) seen += share * J[m];
      }
      const double whole = weight * r[i].reference;
      b[i] =
          first_order ? r[i].conductance * seen : 2 * whole * converted(seen / whole, 3 * r[i].conductance, r[i].order);
    }
    solve_in_place(M, b, n);
    bool settled = true;
    for (int i = 0; i < n; ++i) {
      settled = settled && Kokkos::abs(b[i] - J[i]) <= 1e-15 * Kokkos::abs(b[i]);
      J[i] = b[i];
    }
    if (linear || settled) return;
  }
}

}  // namespace vug
