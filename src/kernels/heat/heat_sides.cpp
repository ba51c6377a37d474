// The stretches of the sides with their conditions for the heat, and the assignment of corners to them.
#include "kernels/base/require.hpp"
#include "kernels/heat/heat_boundary.hpp"
#include "kernels/launch/launch.hpp"

namespace vug {

HeatSide make_heat_side(Side side, int first, int last, HeatCondition condition, double value) {
  if (first < 0 || last < first)
    throw InputError("heat: a stretch of a side from node " + std::to_string(first) + " to " + std::to_string(last));
  HeatSide made{side, first, last, condition, value, {}, {}, 0};
  made.energy_in = ScalarField<double>("vug::heat::energy_in", last - first + 1);
  return made;
}

namespace {

/// Precedence at a corner: the side of higher rank has its diagonal links; among equals, the left or right side.
int rank(const HeatSide& side) {
  const bool flux = side.condition == HeatCondition::flux || side.condition == HeatCondition::convection;
  return side.condition == HeatCondition::adiabatic ? 0 : flux ? 1 : 2;
}

}  // namespace

void assign_corners(const Lattice& lattice, std::vector<HeatSide>& sides) {
  const auto at_end = [&](const HeatSide& side, int end) {
    return end == 0 ? side.first == 0 : side.last == side_length(lattice, side.side) - 1;
  };
  for (HeatSide& upright : sides)
    for (HeatSide& flat : sides) {
      if (!is_upright(upright.side) || is_upright(flat.side)) continue;
      const int on_flat = upright.side == Side::left ? 0 : 1, on_upright = flat.side == Side::bottom ? 0 : 1;
      if (!at_end(upright, on_upright) || !at_end(flat, on_flat)) continue;
      flat.corners[on_flat] = rank(flat) > rank(upright);
      upright.corners[on_upright] = !flat.corners[on_flat];
    }
}

}  // namespace vug
