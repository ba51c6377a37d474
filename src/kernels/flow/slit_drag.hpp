#pragma once
// Cracks narrower than a cell: the walls' drag is a force on the fluid of their nodes.
#include "kernels/flow/flow.hpp"
#include "kernels/nodes/slit_nodes.hpp"

namespace vug {

/// Applies the drag F = -nu u/k (Darcy's law; Brinkman 1949) to the fluid of slits; to be called right after the sweep,
/// which has collided it without drag. With u_0 the velocity of that sweep, u = u_0/(1 + nu/2k), and the populations
/// that left gain 3 w_q c_q . F. To first order in u this is Guo's forcing (2002) with a force that depends on u,
/// stable for any k. Mass is kept. Only slits among the fluid nodes of this process are treated. nu in lattice units,
/// or of each node with step.spread.
template <class T>
void drag_in_slits(const Exec& exec, const FluidNodes& nodes, const SlitNodes& slits, double viscosity,
                   const FlowStep<T>& step, FlowFields<T>& fields);

/// Adds to force(g, :) and torque(g) the force of the fluid of the slits in group g on their walls in a step and its
/// torque, lattice units. The torque is about centre (group, axis), from the lattice's corner, in the unit in which
/// nodes are `spacing` apart. The factors are those of exchange_momentum.
template <class T>
void add_slit_drag(const Exec& exec, const FluidNodes& nodes, const SlitNodes& slits, double viscosity,
                   const FlowStep<T>& step, const FlowFields<T>& fields, const VectorField<double>& centre,
                   double spacing, double force_scale, double torque_scale, const VectorField<double>& force,
                   const ScalarField<double>& torque);

}  // namespace vug
