#pragma once
// The change of a uniform scalar by streaming in a velocity field that is not divergence-free node by node.
#include "kernels/nodes/fluid_nodes.hpp"
#include "kernels/scalar/scalar_equilibrium.hpp"

#include <type_traits>

namespace vug {

/// e(x) = sum_i w_i (h_i^eq/(w_i C) - 1) over the populations that arrive at fluid node x when C is uniform
/// (docs/model.md, "Advective form"; for D2Q5 e = sum_i e_i / 2 with e_i = c_i.u(x - c_i) for a fluid neighbour,
/// -c_i.u(x) for a closed link and +c_i.u(x) for an open one). Subtracting C e after streaming turns conservation form
/// into advective form, so that a uniform scalar stays uniform beside stair-steps and while the density changes.
/// The even part of the equilibrium, which D2Q9 has, is multiplied by `even_weight`: a scheme whose even and odd parts
/// build up at different rates (heat.hpp) has a different defect.
/// `u` is the displacement that the populations were last collided with. e: (fluid).
/// Sums to zero over a closed domain. Bytes per node (D2Q5, double): 16 + 10 + 6 read, 8 written, by windows.
template <class Set, class T>
void advective_defect(const Exec& exec, const FluidNodes& nodes, const std::type_identity_t<Displacement<T>>& u,
                      const ScalarField<T>& e, T even_weight = 1);

}  // namespace vug
