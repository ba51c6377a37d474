#pragma once
// Transport of acid and product and their reaction at walls, in one pass over the fluid.
#include "kernels/reaction/reactive_wall.hpp"

namespace vug {

/// A lattice step of reactant and product (which may be null), then react_at_wall. Both must have taken the same number
/// of steps. On a host this runs block by block, so that the reaction finds the populations in the cache, where the
/// sweep has left them: alone it would fetch nearly every line of them and use one number in five. The results are the
/// same to the bit as those of the three calls in turn.
template <class Set, class T>
void advance_reacting_solutes(const Exec& exec, const FluidNodes& nodes, const SoluteCarrier<T>& carrier,
                              const ReactiveWall& wall, const ReactiveLinks<T>& links,
                              const SteppingSolute<T>& reactant, const SteppingSolute<T>* product);

}  // namespace vug
