#pragma once
// Acid and product that react at walls and are carried, in one pass over the fluid.
#include "kernels/reaction/reactive_wall.hpp"

namespace vug {

/// A lattice step of reactant and product, which may be null, then react_at_wall; they must have taken as many steps.
/// On a host block by block, so that the reaction finds the populations in the cache, where the sweep has left them:
/// alone it would fetch nearly every line of them, to use one number in five. The bits are those of the three in turn.
template <class Set, class T>
void advance_reacting_solutes(const Exec& exec, const FluidNodes& nodes, const SoluteCarrier<T>& carrier,
                              const ReactiveWall& wall, const ReactiveLinks<T>& links,
                              const SteppingSolute<T>& reactant, const SteppingSolute<T>* product);

}  // namespace vug
