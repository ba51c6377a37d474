#pragma once
// The reaction L1 + S1 -> L2 at every link between solid and fluid, and what it takes off the solid (paper Eqs. 7, 9,
// 21-24). It dresses the outgoing populations of acid and product before the sweep.
#include "kernels/choices.hpp"
#include "kernels/link_area.hpp"
#include "kernels/reaction.hpp"
#include "kernels/solute.hpp"

namespace vug {

/// Constants of a reactive wall, in lattice units.
struct ReactiveWall {
  ReactiveWallLaw law = ReactiveWallLaw::kinetic;
  double molar_volume = 0;         ///< pixels dissolved per pixel of unit concentration; 0 = reacts, does not dissolve
  double inverse_equilibrium = 0;  ///< 1/K_eq
  double D_reactant = 1, D_product = 1;  ///< used by the paper's law
};

/// Rate policies: operator()(dense solid node, dense fluid node) gives the rate constant at their common face, in
/// lattice units. This one is the same everywhere.
struct UniformRate {
  double k = 0;
  KOKKOS_FORCEINLINE_FUNCTION double operator()(int, int) const { return k; }
};

/// Rate constant after Arrhenius (Eq. 8) at the temperature `temperature(solid, fluid)`, in K, of the face.
template <class FaceTemperature>
struct ArrheniusRate {
  double k0 = 0;                      ///< rate constant at the reference temperature, lattice units
  double activation_temperature = 0;  ///< Ea/R in K
  double reference_temperature = 0;   ///< K
  FaceTemperature temperature;
  KOKKOS_FORCEINLINE_FUNCTION double operator()(int solid, int fluid) const {
    return arrhenius<double>(k0, activation_temperature, temperature(solid, fluid), reference_temperature);
  }
};

/// Rate constants stored per solid node by store_rates: the temperature changes slowly, and its exponential is the
/// dearest part of a wall's step.
struct StoredRate {
  ScalarField<double> k;  ///< (dense node) lattice units; valid on surface nodes
  KOKKOS_FORCEINLINE_FUNCTION double operator()(int solid, int) const { return k(solid); }
};

/// Evaluates `rate` for StoredRate: the mean over the straight links of every surface node to fluid (all its links
/// where it has no straight one). To be called again every few steps and whenever the surface changed.
/// For rates other than UniformRate include reactive_wall_kernel.hpp.
template <class Rate>
void store_rates(const Exec& exec, const FluidNodes& nodes, const Surface& surface, const Rate& rate,
                 const ScalarField<double>& k);

/// What the reaction takes from the solid and from the fluid.
struct ReactionLedger {
  ScalarField<double> V;          ///< (dense node) solid volume, 1 -> 0 pixels; loses M J
  ScalarField<double> dissolved;  ///< (dense node) volume dissolved so far; gains M J
  ScalarField<double>
      consumed;  ///< (block of surface nodes) acid taken from the fluid; block_count(lattice.size()) suffices
  /// (dense node) product given to the fluid; wanted only with the paper's law, where it differs from the acid consumed
  ScalarField<double> released;
};

/// One step of reaction at all links of `surface`. `normal` from find_normals corrects the area of the stair-step; with
/// extent 0 it is left as it is. `product` may be null (L2 is not modelled; 1/K_eq must then be 0).
/// Instantiated for UniformRate and StoredRate; for other rates include reactive_wall_kernel.hpp.
template <class Set, class T, class Rate>
void react_at_wall(const Exec& exec, const FluidNodes& nodes, const Surface& surface, const ReactiveWall& wall,
                   const Rate& rate, const VectorField<double>& normal, const SoluteFields<T>& reactant,
                   const SoluteFields<T>* product, const ReactionLedger& ledger);

}  // namespace vug
