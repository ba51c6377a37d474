#pragma once
// Heat at the sides of the lattice and at openings in it: the populations that should come in are written to
// the halo, or to the nodes of the opening, before `conduct` pulls them. Every wall plane lies half a node outside the
// first node.
#include "kernels/heat/heat.hpp"
#include "kernels/nodes/opening.hpp"
#include "kernels/scalar/scalar_equilibrium.hpp"

#include <span>
#include <type_traits>
#include <vector>

namespace vug {

/// How fluid crosses sides and openings. By default nothing flows.
template <class T>
struct HeatCrossing {
  IndexList index{};  ///< (dense node) as of FluidNodes
  Crossing<T> fluid{};
};

/// A stretch of one side with a condition of its own, nodes [first, last] along the side.
struct HeatSide {
  Side side = Side::left;
  int first = 0;
  int last = -1;
  HeatCondition condition = HeatCondition::adiabatic;
  double value = 0;               ///< theta of the wall, or the flux in theta nodes per step, in fluid heat capacities
  ScalarField<double> energy_in;  ///< (node of the stretch) heat that entered so far, in fluid heat capacities
  /// D2Q9: whether the diagonal links through the corners at its lower and upper end belong to this side.
  std::array<bool, 2> corners{false, false};
  double transfer = 0;  ///< h of convection per step, in fluid heat capacities; then `value` is theta outside
};

/// Nodes of a stretch, in their order along the side.
std::vector<int> nodes_of(const Lattice& lattice, const HeatSide& side);

/// A stretch of a side. Stretches of one side must not overlap.
HeatSide make_heat_side(Side side, int first, int last, HeatCondition condition, double value = 0);

/// Assigns each corner where two of the sides meet to one of them: a temperature or outflow comes before a flux or
/// convection, and these before an adiabatic side; among equals it is the left or right side. A profile along an
/// adiabatic side then stays one-dimensional up to its end.
void assign_corners(const Lattice& lattice, std::vector<HeatSide>& sides);

/// Fills the halo beside the rows of `fields` at the sides in one launch, and books what enters in energy_in of each.
/// On D2Q9 three links of a node cross the side, which share a flux as 1/6, 2/3, 1/6; where one through a corner is not
/// this side's, its share goes to the straight link. An adiabatic side, one with a flux or convection and an outflow of
/// rock reflect what moves diagonally between like nodes as a mirror does: sent back the way it came it would hold back
/// the heat that flows along the side. To be called after join_heat_sides.
template <class T>
void fill_heat_sides(const Exec& exec, const HeatFields<T>& fields, std::span<const HeatSide> sides,
                     const std::type_identity_t<HeatCrossing<T>>& crossing = {});

/// The surface of an opening with its condition. Its links start at fluid and solid nodes alike: births do not change
/// them.
struct HeatOpening {
  DenseLinks links;
  HeatCondition condition = HeatCondition::adiabatic;
  double value = 0;               ///< as of a side
  ScalarField<double> energy_in;  ///< (link) heat that entered so far, in fluid heat capacities
  double transfer = 0;            ///< as of a side
};

/// The links of `fields` into an opening; `type` and `periodic` as given to make_heat_fields.
template <class T>
HeatOpening make_heat_opening(const Exec& exec, const HeatFields<T>& fields, const Kokkos::View<NodeType*>& type,
                              std::array<bool, 2> periodic, const Opening& opening, HeatCondition condition,
                              double value = 0);

/// Writes the populations that should come out of the openings into their nodes, as fill_heat_sides does to the halo,
/// and books what enters. A flux is per true area of the surface (link_areas). No mirror: on D2Q9
/// what moves diagonally goes back the way it came. To be called before join_heat_sides.
template <class T>
void fill_heat_openings(const Exec& exec, const HeatFields<T>& fields, std::span<const HeatOpening> openings,
                        const std::type_identity_t<HeatCrossing<T>>& crossing = {});

/// Joins the opposite sides across `axis` (0: left and right, 1: bottom and top). Axis 0 must be joined before axis 1.
template <class T>
void join_heat_sides(const Exec& exec, const HeatFields<T>& fields, int axis);

}  // namespace vug
