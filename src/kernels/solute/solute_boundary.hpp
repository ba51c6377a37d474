#pragma once
// What happens to a species at the sides of the lattice: the outgoing population is dressed before the sweep, and the
// bounce-back in the table of sources brings it home. No flux needs nothing. Where several meet: outflow first.
#include "kernels/nodes/dressed_links.hpp"
#include "kernels/scalar/crossing.hpp"
#include "kernels/solute/solute.hpp"

#include <span>
#include <type_traits>

namespace vug {

/// The condition of a species on the links of one stretch, made by the functions below.
template <class T>
struct SoluteCondition : DressedLinks {
  enum class Kind { outflow, concentration, flux };
  Kind kind = Kind::outflow;
  int turned = 0;                ///< (streaming.hpp)
  T* h = nullptr;                ///< populations of the species
  const T* C = nullptr;          ///< (fluid) concentrations
  const double* part = nullptr;  ///< (link) area of a flux
  double value = 0;
  T slope = 0;  ///< outflow_slope(tau_1)
};

/// Given concentration half way along the links: h_in = -A + 2 w_q C_b with A the outgoing population; where fluid
/// crosses, times what the pair has there at equilibrium (crossing.hpp).
template <class T>
SoluteCondition<T> concentration_condition(const BoundaryLinks& links, double C_b, const SoluteFields<T>& s,
                                           const ScalarField<double>& gain);

/// Given flux: h_in = A + area flux, amount per step and cell of a surface of which area (link) belongs to each link.
template <class T>
SoluteCondition<T> flux_condition(const BoundaryLinks& links, const ScalarField<double>& area, double flux,
                                  const SoluteFields<T>& s, const ScalarField<double>& gain);

/// Outflow without gradient: h_in = the node's own population of the incoming direction, less what it diffuses,
/// (tau_1 - 1) w_q times the rise of C from the node before: at the node the gradient is half of that, beyond it none,
/// and the population and the one that leaves are both short of it.
template <class T>
SoluteCondition<T> outflow_condition(const BoundaryLinks& links, const SoluteParameters& parameters,
                                     const SoluteFields<T>& s, const ScalarField<double>& gain);

/// Dresses the links of all stretches, no link of which is in two, of any number of species: one launch; where fluid is
/// `narrow` one for each stretch, in their order. `crossing`: of what carries them, if anything does.
template <class Set, class T>
void dress(const Exec& exec, const FluidNodes& nodes, std::span<const SoluteCondition<T>> conditions,
           bool narrow = false, const std::type_identity_t<Crossing<T>>& crossing = {});

/// Whether one of the links leaves a node whose opposite link is one of a side or an opening too: what an outflow reads
/// there another condition writes.
bool is_narrow(const Exec& exec, const FluidNodes& nodes, const BoundaryLinks& links);

}  // namespace vug
