#pragma once
// Boundary conditions of the flow at links that leave it: each overwrites ("dresses") the outgoing population of a
// link before the sweep, whose bounce-back then brings it in. Call them after the sweep, once per step and link.
// All act half way between the node and its neighbour beyond the link.
#include "kernels/flow/flow.hpp"
#include "kernels/nodes/dressed_links.hpp"

#include <span>

namespace vug {

/// Velocities on the links past the ends of a stretch: of what slides; of a pressure or an outflow, where a velocity is
/// given beyond.
struct SlidingEnds {
  int link[2] = {-1, -1};  ///< -1: none
  double velocity[2][2] = {{0, 0}, {0, 0}};
};

/// The link past an end of a pressure or an outflow, where another one begins. On the same side its mirror image starts
/// there, at another stretch's node; out of a corner of the lattice it has none.
struct LinkPastEnd {
  int link = -1;                  ///< in the list of this stretch; -1: none
  int fluid = -1, direction = 0;  ///< of the image; -1: a corner
  double leaving = 0;             ///< population that leaves along the image in this step
};

/// The condition at the links of one stretch, made by the functions below.
struct FlowCondition : DressedLinks {
  enum class Kind { none, pressure, outflow, velocity, sliding, normal_speed };
  Kind kind = Kind::none;
  const int* mirror = nullptr;   ///< (link) mirror image, for pressures, outflows and what slides
  const double* part = nullptr;  ///< (link) share of a velocity, area of a normal speed
  double value[2] = {0, 0};
  int axis = 0;  ///< along the side, of what slides
  SlidingEnds ends{};
  LinkPastEnd* past = nullptr;  ///< (end) of pressures and outflows; null: none
  double faces = 0, *total = nullptr, *level = nullptr, *along = nullptr;  ///< as in OutflowState
  int pieces = 0, longest = 0;                                             ///< as in OutflowState
  const int *order = nullptr, *piece = nullptr, *face = nullptr;           ///< as in OutflowState
  double* room = nullptr;                                                  ///< as in OutflowState

  /// Number of links that this process must know: all links of an outflow of which it dresses some, because the
  /// condition follows from their mean.
  int known() const { return kind == Kind::outflow && faces > 0 && own_count > 0 ? count : 0; }
};

/// Pressure p (gauge, lattice units) and no velocity along the surface. The population that comes in along a link is
///   f_in = -A' + 2 w [3 p + 9/2 (c'.u')^2 - 3/2 u'^2],
/// where A' is the population that leaves along its mirror image (find_mirror_links), c' the direction of the image and
/// u' the velocity of its node. Anti-bounce-back sets the pressure. With the image's population it also reverses the
/// velocity along the surface, whereas anti-bounce-back with the link's own leaves the shear free. Creeping flow that
/// leaves at right angles is continued exactly: with its sign reversed and mirrored it is a flow again. Where another
/// pressure or an outflow goes on along the side, the image of the link past the end is that of the other (`past`);
/// where a velocity is given there, that link has its component across the side (`ends`). Any other link without an
/// image is a wall. The same holds for outflows.
FlowCondition pressure_condition(const BoundaryLinks& links, const IndexList& mirror, double pressure,
                                 const ScalarField<double>& gain);

/// Velocity of the wall, or of the fluid that enters through it: f_in = A + 6 w c_in . velocity; the velocity is
/// multiplied by share(link) where `share` is not empty. Links to solid nodes may be in the list as well: a moving wall
/// whose displacement is neglected.
FlowCondition velocity_condition(const BoundaryLinks& links, std::array<double, 2> velocity,
                                 const ScalarField<double>& share, const ScalarField<double>& gain);

/// The rule of a velocity on a side, whose component along the axis `along` moves mass along the wall: 6 w velocity
/// from node to node, by the two links that cross in between. Mass is conserved because a link without an image (beside
/// rock, at the end of the stretch) has only the component normal to the side, unless it is one of `ends`.
FlowCondition sliding_condition(const BoundaryLinks& links, const IndexList& mirror, int along,
                                std::array<double, 2> velocity, const ScalarField<double>& share,
                                const SlidingEnds& ends, const ScalarField<double>& gain);

/// Fluid that enters at `speed` (negative: leaves) normal to the surface of an opening: f_in = A + area speed, with
/// area (link) the surface that belongs to each link (link_areas in opening.hpp). This is the rule above with u_w =
/// speed n.
FlowCondition normal_speed_condition(const BoundaryLinks& links, const ScalarField<double>& area, double speed,
                                     const ScalarField<double>& gain);

/// Data of an outflow that are kept from step to step, on the device.
struct OutflowState {
  double faces = 0;           ///< straight links
  ScalarField<double> speed;  ///< (block of links) work space for a sum
  /// Entry 0: mean outward speed, remembered over the time in which sound crosses the lattice four times. Entry 1: rho'
  /// at the surface in this step. Zeros at rest.
  ScalarField<double> level;
  ScalarField<double> along;    ///< (link) work space; for straight links: rho' there minus that of `level`
  int pieces = 0, longest = 0;  ///< number of straight pieces, and of faces of the longest one
  IndexList order;              ///< (face) the straight links piece by piece, along each towards higher coordinates
  IndexList piece;              ///< (piece + 1) where each piece begins in `order`, and the end of the last one
  IndexList face;               ///< (link) the straight link of its node, for a straight link itself; -1: none or two
  ScalarField<double> room;     ///< (3 link) work space for sums and slopes
};

/// Allocates the arrays of `state` for `links` and lists the straight pieces; keeps the level.
void fit_to_links(const Exec& exec, const FluidNodes& nodes, const BoundaryLinks& links, OutflowState& state);

/// Outflow: the pressure rule, but with the nodes' velocity along the surface (no gradient) and with two terms added to
/// the reference pressure. The first, for the whole surface, is c_s times the recent change of the mean outward speed:
/// sound that arrives leaves (Thompson 1987; Poinsot and Lele 1992, with their relaxation to a pressure far away), and
/// the mean pressure returns to the reference. The second, along each straight piece, is a pressure of mean zero with
/// which vortices are carried out unchanged (PressureAlong in outflow_pressure.hpp). Where two outflows meet at a
/// corner of the lattice, fluid leaves there with the velocity of its node, f_in = A - 6 w max(c.u, 0), and none
/// enters.
FlowCondition outflow_condition(const BoundaryLinks& links, const IndexList& mirror, const OutflowState& state,
                                const ScalarField<double>& gain);

/// Dresses the links of all stretches, which must have no link in common. One launch, three more where there are
/// outflows, and one where pressures or outflows meet on a side.
template <class T>
void dress(const Exec& exec, const FluidNodes& nodes, std::span<const FlowCondition> conditions,
           const FlowFields<T>& fields);

}  // namespace vug
