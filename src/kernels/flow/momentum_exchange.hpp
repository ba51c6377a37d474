#pragma once
// The force of the fluid on the solid nodes that it touches.
#include "kernels/flow/flow.hpp"

#include <optional>

namespace vug {

/// The links between the fluid and groups of solid nodes, such as the nodes of a particle. They are found anew when the
/// pores change, so that a step reads only the populations of these links.
struct WallLinks {
  IndexList first;  ///< (group + 1) links of group g: [first(g), first(g + 1)), node by node in the order of q
  /// (link) Slot of the population that leaves the fluid into the solid along q. It has links_ahead more entries than
  /// there are links, so that prefetches stay inside.
  IndexList slot;
  /// (link) 16 arm + 4 (c_y + 1) + c_x + 1; arm: torque about the group's first node per momentum, in nodes
  IndexList lever;
  VectorField<double> origin;  ///< (group, axis) that node relative to the centre of the group, nodes
  int groups() const { return static_cast<int>(first.extent(0)) - 1; }
};

/// Finds the links of groups of solid nodes: group g holds node(k) (dense) for k in [offset(g), offset(g + 1)). centre:
/// (group, axis), from the lattice's corner, in the unit in which nodes are `spacing` apart. Reuses the allocations
/// that fit.
void find_wall_links(const Exec& exec, const FluidNodes& nodes, const IndexList& offset, const IndexList& node,
                     const VectorField<double>& centre, double spacing, WallLinks& links);

/// Sets force(g, :) and torque(g) to the force of the fluid on group g and its torque in one step, lattice units (times
/// rho0 dx^3/dt^2: N per metre of depth; the torque times one more dx), by momentum exchange: the sum over its links of
/// c 2A, A the population about to leave along c into the solid and to return. It is the gauge force, relative to the
/// reference pressure, and exact for fluid at rest beside any staircase. The force of each link acts along the link
/// through the centre of its solid node, so its torque about that centre is zero and the force may be taken to act
/// there. force_scale and torque_scale are factors of the results. Sums are in double whatever T is; a link takes 8
/// bytes of table and a population.
///
/// Valid between sweeps, before or after the sides are dressed. Where links to solid nodes themselves are dressed (a
/// moving wall), the force is the mean of a call before and a call after. With `only`, the groups listed there are
/// computed and the others left as they are.
template <class T>
void exchange_momentum(const Exec& exec, const FlowFields<T>& fields, const WallLinks& links, double force_scale,
                       double torque_scale, const VectorField<double>& force, const ScalarField<double>& torque,
                       const std::optional<IndexList>& only = {});

}  // namespace vug
