#pragma once
// What happens to a species at the sides of the lattice: the outgoing population is dressed before the sweep, and the
// bounce-back in the table of sources brings it home. No flux needs nothing. Where several meet: outflow first.
#include "kernels/solute.hpp"

namespace vug {

/// Given concentration half way along the links: h_in = -A + 2 w_q C_b with A the outgoing population.
///
/// gain(link) += what the fluid gains; it has links.count entries.
template <class Set, class T>
void dress_concentration(const Exec& exec, const FluidNodes& nodes, const BoundaryLinks& links, double C_b,
                         const SoluteFields<T>& s, const ScalarField<double>& gain);

/// As above with a concentration of its own on every link, C_b(link).
template <class Set, class T>
void dress_concentration(const Exec& exec, const FluidNodes& nodes, const BoundaryLinks& links,
                         const ScalarField<double>& C_b, const SoluteFields<T>& s, const ScalarField<double>& gain);

/// Given flux: h_in = A + area flux, amount per step and cell of a surface of which area (link) belongs to each link.
/// gain(link) as above.
template <class Set, class T>
void dress_flux(const Exec& exec, const FluidNodes& nodes, const BoundaryLinks& links, const ScalarField<double>& area,
                double flux, const SoluteFields<T>& s, const ScalarField<double>& gain);

/// Outflow without gradient: h_in = the node's own population of the incoming direction. gain(link) as above.
template <class Set, class T>
void dress_outflow(const Exec& exec, const FluidNodes& nodes, const BoundaryLinks& links, const SoluteFields<T>& s,
                   const ScalarField<double>& gain);

}  // namespace vug
