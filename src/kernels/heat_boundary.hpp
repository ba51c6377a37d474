#pragma once
// Heat at the sides of the lattice: the populations that should come in are written to the halo before `conduct`
// pulls them. Every wall plane lies half a node outside the first node.
#include "kernels/heat.hpp"

namespace vug {

enum class HeatCondition {
  adiabatic,    ///< in = A: nothing passes
  temperature,  ///< in = -A + 2 w theta_wall: the wall plane has that temperature
  flux,         ///< in = A + share q / c: the heat q enters per node and step, c the node's heat capacity
  outflow       ///< in = the node's own population of the same direction: zero gradient
};

/// A stretch of one side with a condition of its own, nodes [first, last] along the side.
struct HeatSide {
  Side side = Side::left;
  int first = 0;
  int last = -1;
  HeatCondition condition = HeatCondition::adiabatic;
  double value = 0;               ///< theta of the wall, or the flux in theta nodes per step, in fluid heat capacities
  ScalarField<double> energy_in;  ///< (block) heat that entered so far, in fluid heat capacities
};

/// A whole side, or a stretch of it. Stretches of one side must not overlap.
HeatSide make_heat_side(const Lattice& lattice, Side side, HeatCondition condition, double value = 0);
HeatSide make_heat_side(Side side, int first, int last, HeatCondition condition, double value = 0);

/// Fills the halo beside `side`, and books what enters in side.energy_in. On D2Q9 three links of a node cross the side,
/// which share a flux as 1/6, 2/3, 1/6; the one through a corner of two sides that are not joined belongs to the left
/// or right side, its share to the straight link. Sides that are joined come first.
template <class T>
void fill_heat_side(const Exec& exec, const HeatFields<T>& fields, const HeatSide& side);

/// Joins the opposite sides across `axis` (0: left and right, 1: bottom and top), 0 before 1.
template <class T>
void join_heat_sides(const Exec& exec, const HeatFields<T>& fields, int axis);

}  // namespace vug
