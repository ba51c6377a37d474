#pragma once
// Cracks narrower than a cell: the walls' drag is a force on the fluid of their nodes.
#include "kernels/flow/flow.hpp"
#include "kernels/nodes/slit_nodes.hpp"

namespace vug {

/// Gives the fluid of slits the drag F = -nu u/k (Darcy's law; Brinkman 1949), to be called right after the sweep that
/// collided it without. With the velocity u_0 that it had then u = u_0/(1 + nu/2k), and what left it gains
/// 3 w_q c_q . F: to first order in u Guo's forcing (2002) with a force that depends on u, stable for any k. Mass is
/// kept. Of slits only those among the fluid nodes that this process computes. nu in lattice units, or of each node
/// with step.spread.
template <class T>
void drag_in_slits(const Exec& exec, const FluidNodes& nodes, const SlitNodes& slits, double viscosity,
                   const FlowStep<T>& step, FlowFields<T>& fields);

/// force(g, :) and torque(g) += what the fluid of the slits in group g gives to their walls in a step, lattice units;
/// the torque about centre (group, axis), in units of `spacing` nodes from the lattice's corner. The factors as of
/// exchange_momentum.
template <class T>
void add_slit_drag(const Exec& exec, const FluidNodes& nodes, const SlitNodes& slits, double viscosity,
                   const FlowStep<T>& step, const FlowFields<T>& fields, const VectorField<double>& centre,
                   double spacing, double force_scale, double torque_scale, const VectorField<double>& force,
                   const ScalarField<double>& torque);

}  // namespace vug
