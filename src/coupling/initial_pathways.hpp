#pragma once
// The pathways that give the rock its initial porosity (paper Fig. 4b; closure in docs/model.md, "Pathways").
#include <array>
#include <cstdint>
#include <vector>

namespace vug {

/// Chooses the edges that carry a pathway from the start: a random spanning tree over the vertices, so that every
/// pathway is connected to every other, pruned leaf by leaf or filled up with further edges, in an order drawn from
/// the seed and the vertex names, until the nodes they open reach `target_nodes`.
/// edges: vertex pairs (low, high); strips: the nodes that a pathway along each edge opens (strips overlap where edges
/// meet; a node counts once); fixed: edges that are open anyway (notches), which count and stay. Returns one flag per
/// edge.
std::vector<bool> choose_pathways(const std::vector<std::array<int, 2>>& edges,
                                  const std::vector<std::vector<int>>& strips, const std::vector<bool>& fixed,
                                  int vertices, int target_nodes, std::uint64_t seed);

}  // namespace vug
