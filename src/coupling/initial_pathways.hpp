#pragma once
// The pathways that give the rock its initial porosity (paper Fig. 4b; closure in docs/model.md, "Pathways").
#include "dem/assembly.hpp"

#include <cstdint>
#include <functional>
#include <vector>

namespace vug {

/// Chooses the bonds that carry a pathway from the start: the joints between blocks of rock, each block the triangles
/// nearest to one of so many random triangles that the joints take about `target`. Joints, notches and the walls
/// of holes that do not meet are connected by the shortest ways between them. How many triangles a block has follows
/// from the porosity, so the network does not change its nature when the triangles get smaller, and all bonds are
/// joints when the porosity asks for it.
/// fixed: (bond, in the order of find_edges) is open anyway (notches), counts and stays; taken(open): what the pathways
/// along such bonds take of the rock, in the unit of `target`, more the more there are. Returns one flag per bond.
std::vector<bool> choose_pathways(const Assembly& assembly, const std::vector<bool>& fixed, double target,
                                  std::uint64_t seed, const std::function<double(const std::vector<bool>&)>& taken);

/// How many nodes pathways along the `open` bonds have whose strips (bond) overlap where bonds meet.
int count_nodes(const std::vector<bool>& open, const std::vector<std::vector<int>>& strips);

}  // namespace vug
