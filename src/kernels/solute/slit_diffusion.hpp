#pragma once
// Diffusion along cracks narrower than a cell (docs/model.md, "Cracks narrower than a cell").
#include "kernels/nodes/slit_nodes.hpp"
#include "kernels/solute/solute.hpp"

namespace vug {

/// Part of the diffusivity D that each node of the narrowest strip must keep so that the diffusive flux along a crack
/// of `aperture` w cells is w D times the gradient along its line. The line rises by 0 <= slope s <= 1 per column. A
/// column has 1 + s links with the resistance 1/(part D) each, and is to have sqrt(1 + s^2)/(w D). At most 1.
KOKKOS_FORCEINLINE_FUNCTION double slit_openness(double aperture, double slope) {
  return Kokkos::fmin(1.0, aperture * (1 + slope) / Kokkos::sqrt(1 + slope * slope));
}

/// Share r that a link of `weight` sends back of what it would pass, so that it conducts `conductance` instead of D. At
/// a flux j the population that leaves a node is weight C + alpha j, with 1 - 2 alpha = weight/D. Of the difference
/// between the two populations that meet, 1 - r passes. Hence weight/conductance = 1/(1 - r) - 1 + weight/D.
KOKKOS_FORCEINLINE_FUNCTION double reflected_share(double weight, double D, double conductance) {
  const double added = weight * (1 / conductance - 1 / D);
  return added > 0 ? added / (1 + added) : 0;
}

/// Reduces the diffusion over the links of slits. To be called right after a step of a species, when the outgoing
/// populations are those of `nodes` and, where processes share them, of the nodes around. Both halves of a link count:
/// it conducts D over the mean of 1/openness, but no less than |u|/2 (as in hybrid differencing, Spalding 1972, so that
/// advection makes no waves). The advected part, 6 weight C u.c with the means of both nodes, passes in full. Conserves
/// the species to rounding.
template <class Set, class T>
void resist_in_slits(const Exec& exec, const FluidNodes& nodes, const SlitNodes& slits, const SoluteCarrier<T>& carrier,
                     const SoluteParameters& parameters, const SoluteFields<T>& s);

}  // namespace vug
