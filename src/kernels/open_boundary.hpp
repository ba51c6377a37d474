#pragma once
// Boundary conditions of the flow at links that leave it: each overwrites ("dresses") the outgoing population of a
// link before the sweep, whose bounce-back then brings it in. Call them after the sweep, once per step and link.
// All act half way between the node and its neighbour beyond the link.
#include "kernels/flow.hpp"

namespace vug {

/// Pressure p (gauge, lattice units) by anti-bounce-back with the velocity of the node itself:
///   f_in = -A + 2 w [3 p + 9/2 (c.u)^2 - 3/2 u^2],  A the outgoing population.
/// gain(link) += what entered minus what left (as for all conditions here), for the balance of mass.
template <class T>
void dress_pressure(const Exec& exec, const FluidNodes& nodes, const BoundaryLinks& links, double pressure,
                    const FlowFields<T>& fields, const ScalarField<double>& gain);

/// Velocity of the wall, or of the fluid that enters through it: f_in = A + 6 w c_in . velocity.
/// Links to solid nodes may be in the list as well: a wall that moves, its own displacement left out.
template <class T>
void dress_velocity(const Exec& exec, const FluidNodes& nodes, const BoundaryLinks& links,
                    std::array<double, 2> velocity, const FlowFields<T>& fields, const ScalarField<double>& gain);

/// Fluid that enters at `speed` (negative: leaves) normal to the surface of an opening, area (link) of which belongs to
/// each link (link_areas in opening.hpp): f_in = A + area speed, which is the rule above with u_w = speed n.
template <class T>
void dress_normal_speed(const Exec& exec, const FluidNodes& nodes, const BoundaryLinks& links,
                        const ScalarField<double>& area, double speed, const FlowFields<T>& fields,
                        const ScalarField<double>& gain);

/// density(link) = rho' of the node of each link, for dress_outflow. Before any condition is dressed, since they
/// overwrite what it adds up.
template <class T>
void take_density(const Exec& exec, const FluidNodes& nodes, const BoundaryLinks& links, const FlowFields<T>& fields,
                  const ScalarField<double>& density);

/// Outflow by zero gradient: the pressure rule with the density (link) of the node itself. (Handing back the population
/// that already moves inwards, the other common form, diverges where a sliding wall meets the outflow.) Only what
/// enters elsewhere and the friction behind it fix the level of pressure.
template <class T>
void dress_outflow(const Exec& exec, const FluidNodes& nodes, const BoundaryLinks& links,
                   const ScalarField<double>& density, const FlowFields<T>& fields, const ScalarField<double>& gain);

}  // namespace vug
