#pragma once
// The pathways that give the rock its initial porosity (paper Fig. 4b; closure in docs/model.md, "Pathways").
#include "dem/assembly.hpp"

#include <cstdint>
#include <functional>
#include <vector>

namespace vug {

/// Chooses the bonds that carry a pathway from the start: the joints between blocks of rock. A block consists of the
/// triangles nearest to one of several random triangles, whose number is such that the joints take about `target`.
/// Joints, notches and the walls of holes that do not meet are connected by the shortest ways between them. The
/// porosity determines how many triangles a block has, so that the network keeps its nature when the triangles get
/// smaller; where the porosity requires it, all bonds are joints.
///
/// fixed: (bond, in the order of find_edges) is open anyway (notches), counts and stays; taken(open): what pathways
/// along these bonds take of the rock, in the unit of `target`; it grows with their number. Returns one flag per bond.
std::vector<bool> choose_pathways(const Assembly& assembly, const std::vector<bool>& fixed, double target,
                                  std::uint64_t seed, const std::function<double(const std::vector<bool>&)>& taken);

/// Number of nodes of pathways along the `open` bonds, whose strips (bond) overlap where bonds meet.
int count_nodes(const std::vector<bool>& open, const std::vector<std::vector<int>>& strips);

}  // namespace vug
