#pragma once
// Acid and product that react at walls and are carried, in one pass over the fluid.
#include "kernels/reaction/reactive_wall.hpp"

#include <optional>

namespace vug {

/// What carries solutes: nothing, a flow, or a flow in advective form (advance_solute).
template <class T>
struct SoluteCarrier {
  std::optional<Displacement<T>> displacement;
  std::optional<ScalarField<T>> defect;
};

/// A species that takes a step.
template <class T>
struct SteppingSolute {
  const SoluteParameters& parameters;
  SoluteFields<T>& fields;
  ScalarField<double> correction;  ///< (block) gains what the advective form adds; unused without it
};

/// One lattice step of a species: advance_solute with what carries it.
template <class Set, class T>
void advance_solute(const Exec& exec, const FluidNodes& nodes, const SoluteCarrier<T>& carrier,
                    const SteppingSolute<T>& solute);

/// A lattice step of reactant and product, which may be null, then react_at_wall; they must have taken as many steps.
/// On a host block by block, so that the reaction finds the populations in the cache, where the sweep has left them:
/// alone it would fetch nearly every line of them, to use one number in five. The bits are those of the three in turn.
template <class Set, class T>
void advance_reacting_solutes(const Exec& exec, const FluidNodes& nodes, const SoluteCarrier<T>& carrier,
                              const ReactiveWall& wall, const ReactiveLinks<T>& links,
                              const SteppingSolute<T>& reactant, const SteppingSolute<T>* product);

}  // namespace vug
