#pragma once
// The pathways that give the rock its initial porosity (paper Fig. 4b; closure in docs/model.md, "Pathways").
#include "dem/assembly.hpp"

#include <cstdint>
#include <vector>

namespace vug {

/// Chooses the bonds that carry a pathway from the start: the joints between blocks of rock, each block the triangles
/// nearest to one of so many random triangles that the joints open about `target_nodes`. Joints, notches and the walls
/// of holes that do not meet are connected by the shortest ways between them. How many triangles a block has follows
/// from the porosity, so the network does not change its nature when the triangles get smaller, and all bonds are
/// joints when the porosity asks for it.
/// strips: (bond, in the order of find_edges) the nodes that a pathway along it opens; strips overlap where bonds meet
/// and a node counts once; fixed: (bond) is open anyway (notches), counts and stays. Returns one flag per bond.
std::vector<bool> choose_pathways(const Assembly& assembly, const std::vector<std::vector<int>>& strips,
                                  const std::vector<bool>& fixed, int target_nodes, std::uint64_t seed);

}  // namespace vug
