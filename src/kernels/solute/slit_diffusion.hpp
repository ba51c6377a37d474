#pragma once
// Diffusion along cracks narrower than a cell (docs/model.md, "Cracks narrower than a cell").
#include "kernels/nodes/slit_nodes.hpp"
#include "kernels/solute/solute.hpp"

namespace vug {

/// Part of its diffusivity D that each node of the narrowest strip must keep so that what diffuses along a crack of
/// `aperture` w cells is w D times the gradient along its line, which rises by 0 <= slope s <= 1 per column: a column
/// has 1 + s links, each 1/(part D) of resistance, where the line has sqrt(1 + s^2)/(w D). At most 1.
KOKKOS_FORCEINLINE_FUNCTION double slit_openness(double aperture, double slope) {
  return Kokkos::fmin(1.0, aperture * (1 + slope) / Kokkos::sqrt(1 + slope * slope));
}

/// How much of what a link of `weight` would pass it sends back, so that it conducts `conductance` instead of D: what
/// leaves one node is weight C + alpha j of the flux j with 1 - 2 alpha = weight/D, and of the difference between the
/// two that meet 1 - r pass, so that weight/conductance = 1/(1 - r) - 1 + weight/D.
KOKKOS_FORCEINLINE_FUNCTION double reflected_share(double weight, double D, double conductance) {
  const double added = weight * (1 / conductance - 1 / D);
  return added > 0 ? added / (1 + added) : 0;
}

/// Holds back what diffuses over the links of slits, to be called right after a step of a species, when the
/// populations that go out are those of `nodes` and, where processes share them, of the nodes around. Both halves of a
/// link count, so that it conducts D over the mean of 1/openness, but no less than |u|/2 (as in hybrid differencing,
/// Spalding 1972: what flows makes no waves). What flows, 6 weight C u.c of the means of both, passes. Conserves the
/// species to rounding.
template <class Set, class T>
void resist_in_slits(const Exec& exec, const FluidNodes& nodes, const SlitNodes& slits, const SoluteCarrier<T>& carrier,
                     const SoluteParameters& parameters, const SoluteFields<T>& s);

}  // namespace vug
