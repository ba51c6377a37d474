#pragma once
// The force of the fluid on the solid nodes that it touches.
#include "kernels/flow.hpp"

namespace vug {

/// force(s, :) = what the fluid gives to surface node s in one step, lattice units (times rho0 dx^3/dt^2: N per metre
/// of depth), by momentum exchange over its fluid links: sum of c 2A, A the population about to leave along c into
/// the solid and to return. It is the gauge force, relative to the reference pressure, exact for fluid at rest beside
/// any staircase. Each link's force lies along the link through the node's centre, so the torque about the centre is
/// zero and the force may be taken to act there. Overwrites `force`; double whatever T is.
///
/// Valid between sweeps, before or after the sides are dressed. Where links to solid nodes themselves are dressed (a
/// moving wall) it is the mean of a call before and a call after.
template <class T>
void exchange_momentum(const Exec& exec, const FluidNodes& nodes, const Surface& surface, const FlowFields<T>& fields,
                       const VectorField<double>& force);

}  // namespace vug
