#pragma once
// The force of the fluid on the solid nodes that it touches.
#include "kernels/flow/flow.hpp"

#include <optional>

namespace vug {

/// The links between the fluid and groups of solid nodes, such as the nodes of a particle: found anew when the pores
/// change, so that a step reads the populations of these links and nothing else of the lattice.
struct WallLinks {
  IndexList first;  ///< (group + 1) links of group g: [first(g), first(g + 1)), node by node in the order of q
  /// (link) of the population that leaves the fluid into the solid along q; links_ahead entries longer than there are
  /// links, so that what is asked for ahead lies inside.
  IndexList slot;
  /// (link) 16 arm + 4 (c_y + 1) + c_x + 1; arm: torque per momentum about the group's first node, nodes
  IndexList lever;
  VectorField<double> origin;         ///< (group, axis) that node as seen from the centre of the group, nodes
  Kokkos::View<std::uint8_t*> touch;  ///< (entry of the list of nodes) bit q - 1: fluid along -q; for the search
  int groups() const { return static_cast<int>(first.extent(0)) - 1; }
};

/// Finds the links of groups of solid nodes: group g holds node(k) (dense) for k in [offset(g), offset(g + 1)).
/// centre: (group, axis), in units of `spacing` nodes from the lattice's corner. Reuses the allocations that fit.
void find_wall_links(const Exec& exec, const FluidNodes& nodes, const IndexList& offset, const IndexList& node,
                     const VectorField<double>& centre, double spacing, WallLinks& links);

/// force(g, :) and torque(g) = what the fluid gives to group g in one step, lattice units (times rho0 dx^3/dt^2: N per
/// metre of depth; the torque times a node more), by momentum exchange: sum over its links of c 2A, A the population
/// about to leave along c into the solid and to return. It is the gauge force, relative to the reference pressure,
/// exact for fluid at rest beside any staircase. Each link's force lies along the link through the centre of its solid
/// node, so the torque about that is zero and the force may be taken to act there. force_scale and torque_scale
/// multiply. Double whatever T is; 8 bytes of table and a population per link.
///
/// Valid between sweeps, before or after the sides are dressed. Where links to solid nodes themselves are dressed (a
/// moving wall) it is the mean of a call before and a call after. Of the groups listed in `only`, where given; the
/// others are left as they are.
template <class T>
void exchange_momentum(const Exec& exec, const FlowFields<T>& fields, const WallLinks& links, double force_scale,
                       double torque_scale, const VectorField<double>& force, const ScalarField<double>& torque,
                       const std::optional<IndexList>& only = {});

}  // namespace vug
