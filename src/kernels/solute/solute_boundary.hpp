#pragma once
// Boundary conditions of a species at the sides of the lattice: the outgoing population is overwritten (dressed) before
// the sweep, whose bounce-back brings it in. Zero flux needs no condition. Where several conditions meet, outflow comes
// first.
#include "kernels/nodes/dressed_links.hpp"
#include "kernels/scalar/scalar_equilibrium.hpp"
#include "kernels/solute/solute.hpp"

#include <span>
#include <type_traits>

namespace vug {

/// The condition of a species on the links of one stretch, made by the functions below.
template <class T>
struct SoluteCondition : DressedLinks {
  enum class Kind { outflow, concentration, flux };
  Kind kind = Kind::outflow;
  int turned = 0;                ///< of the populations (streaming.hpp)
  T* h = nullptr;                ///< populations of the species
  const T* C = nullptr;          ///< (fluid) concentrations
  const double* part = nullptr;  ///< (link) area of a flux
  double value = 0;
  T slope = 0;  ///< outflow_slope(tau_1)
  Rounding<T> rounding{};
};

/// Given concentration half way along the links: h_in = -A + 2 w_q C_b, where A is the outgoing population; where fluid
/// crosses the boundary, the second term is multiplied by Crossing::pair.
template <class T>
SoluteCondition<T> concentration_condition(const BoundaryLinks& links, double C_b, const SoluteFields<T>& s,
                                           const ScalarField<double>& gain);

/// Given flux, amount per step and cell of the surface: h_in = A + area flux; area (link): the surface that belongs to
/// each link.
template <class T>
SoluteCondition<T> flux_condition(const BoundaryLinks& links, const ScalarField<double>& area, double flux,
                                  const SoluteFields<T>& s, const ScalarField<double>& gain);

/// Outflow without gradient: h_in is the node's own population of the incoming direction minus its diffusive part,
/// (tau_1 - 1) w_q times the rise of C from the node before. At the node the gradient is half of that rise, because
/// there is none beyond it; this population and the one that leaves each lack (tau_1 - 1) w_q of it.
template <class T>
SoluteCondition<T> outflow_condition(const BoundaryLinks& links, const SoluteParameters& parameters,
                                     const SoluteFields<T>& s, const ScalarField<double>& gain);

/// Dresses the links of all stretches of any number of species. No link may be in two stretches. One launch; where
/// fluid is `narrow` (is_narrow), one launch for each stretch, in their order, and two for an outflow: first the links
/// that lead down or left, then those that lead up or right. `crossing` is that of the flow that carries the species,
/// if any.
template <class Set, class T>
void dress(const Exec& exec, const FluidNodes& nodes, std::span<const SoluteCondition<T>> conditions,
           bool narrow = false, const std::type_identity_t<Crossing<T>>& crossing = {});

/// Whether, at the node of one of the links, the opposite link also leads through a side or into an opening: an outflow
/// reads there what another condition writes.
bool is_narrow(const Exec& exec, const FluidNodes& nodes, const BoundaryLinks& links);

}  // namespace vug
