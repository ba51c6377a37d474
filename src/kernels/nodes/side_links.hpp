#pragma once
// Links through a side where it matters which of two sides has the link out of their corner.
#include "kernels/nodes/fluid_nodes.hpp"

namespace vug {

using SideOrder = std::array<Side, 4>;

/// As find_boundary_links of fluid_nodes.hpp, for which `order` is all_sides: a diagonal link out of a corner belongs
/// to the side that comes first in `order`.
BoundaryLinks find_boundary_links(const Exec& exec, const FluidNodes& nodes, Side side, int first, int last,
                                  int directions, const SideOrder& order);

/// (link) Area of the side that each of its links stands for, cells: 6 w, scaled to one per straight link where a
/// corner has given a diagonal one to another side. Computed on the host: not inside a step.
ScalarField<double> side_link_areas(const BoundaryLinks& links, int directions);

}  // namespace vug
