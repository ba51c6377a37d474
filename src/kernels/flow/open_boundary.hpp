#pragma once
// Boundary conditions of the flow at links that leave it: each overwrites ("dresses") the outgoing population of a
// link before the sweep, whose bounce-back then brings it in. Call them after the sweep, once per step and link.
// All act half way between the node and its neighbour beyond the link.
#include "kernels/flow/flow.hpp"
#include "kernels/nodes/dressed_links.hpp"

#include <span>

namespace vug {

/// The condition on the links of one stretch, made by the functions below.
struct FlowCondition : DressedLinks {
  enum class Kind { none, pressure, outflow, velocity, velocity_profile, normal_speed };
  Kind kind = Kind::none;
  const int* mirror = nullptr;   ///< (link) of pressures and outflows
  const double* part = nullptr;  ///< (link) share of a velocity, area of a normal speed
  double value[2] = {0, 0};
  double faces = 0, *total = nullptr, *level = nullptr, *along = nullptr;  ///< those of an OutflowState
  const int *next = nullptr, *previous = nullptr, *face = nullptr;         ///< likewise

  /// Links of an outflow of which this process dresses some, and must know all: its conditions follow from their mean.
  int known() const { return kind == Kind::outflow && faces > 0 && own_count > 0 ? count : 0; }
};

/// Pressure p (gauge, lattice units) and no velocity along the surface: what comes in along a link is
///   f_in = -A' + 2 w [3 p + 9/2 (c'.u')^2 - 3/2 u'^2],
/// A' the population that leaves along its mirror image (mirror_links.hpp), c' and u' the direction and node of that.
/// Anti- bounce-back holds the pressure; taken from the image it also turns the velocity along the surface round, where
/// anti-bounce-back of the link itself leaves the shear free. Creeping flow that runs straight out is carried on
/// exactly: reversed in sign and mirrored it is a flow again. A link without an image is a wall.
FlowCondition pressure_condition(const BoundaryLinks& links, const IndexList& mirror, double pressure,
                                 const ScalarField<double>& gain);

/// Velocity of the wall, or of the fluid that enters through it: f_in = A + 6 w c_in . velocity; where it is spread
/// over the links share(link) of it, all of it where `share` is empty. Links to solid nodes may be in the list as well:
/// a wall that moves, its own displacement left out.
FlowCondition velocity_condition(const BoundaryLinks& links, std::array<double, 2> velocity,
                                 const ScalarField<double>& share, const ScalarField<double>& gain);

/// Fluid that enters at `speed` (negative: leaves) normal to the surface of an opening, area (link) of which belongs to
/// each link (link_areas in opening.hpp): f_in = A + area speed, which is the rule above with u_w = speed n.
FlowCondition normal_speed_condition(const BoundaryLinks& links, const ScalarField<double>& area, double speed,
                                     const ScalarField<double>& gain);

/// What an outflow keeps from step to step, on the device.
struct OutflowState {
  double faces = 0;           ///< straight links
  ScalarField<double> speed;  ///< (block of links) room for a sum
  /// 0: mean outward speed, forgotten over the time that sound takes to cross the lattice four times;
  /// 1: rho' at the surface in this step. At rest: zeros.
  ScalarField<double> level;
  ScalarField<double> along;  ///< (link) of straight links, room for what rho' differs from that along the surface
  IndexList next, previous;   ///< (link) of straight links, those beside it on the same straight piece; -1: its ends
  IndexList face;             ///< (link) straight link of its node, which is the link itself; -1: none
};

/// Room for `links` and how they lie; keeps the level that is there.
void fit_to_links(const Exec& exec, const FluidNodes& nodes, const BoundaryLinks& links, OutflowState& state);

/// Outflow: the pressure rule with the velocity along the surface that the nodes have (no gradient) and two things
/// beside the reference pressure. All over the surface, c_s times what the mean outward speed has changed by of late:
/// sound that arrives leaves (Thompson 1987; Poinsot and Lele 1992, with their relaxation to a pressure far away), the
/// mean pressure returns to the reference. Along each straight piece, the pressure under which a vortex is carried
/// out as it is (PressureAlong in outflow.hpp), with no mean.
FlowCondition outflow_condition(const BoundaryLinks& links, const IndexList& mirror, const OutflowState& state,
                                const ScalarField<double>& gain);

/// Dresses the links of all stretches, no link of which is in two: one launch, and three more where there are outflows.
template <class T>
void dress(const Exec& exec, const FluidNodes& nodes, std::span<const FlowCondition> conditions,
           const FlowFields<T>& fields);

}  // namespace vug
