#include "dem/require_edges.hpp"

#include "base/require.hpp"

#include <algorithm>
#include <string>

namespace vug {

namespace {

bool acts(const SidePart& part) {
  return part.support != Support::free || part.changes || part.moves() || part.stiffness != 0 ||
         value_at(part.traction[0], 0) != 0 || value_at(part.traction[1], 0) != 0;
}

bool acts(const Loads& loads, std::size_t side) {
  const std::array<double, 2> none{};
  return loads.support[side] != Support::free || loads.traction[side] != none || loads.velocity[side] != none ||
         loads.stiffness[side] != 0;
}

/// Edges of the rock that are left to a part, or to a side (part = -1); slivers due to rounding do not count.
struct Found {
  bool edge = false, holds = false;
  Found(const std::vector<LoadedPiece>& pieces, int part, int side, double tolerance) {
    for (const LoadedPiece& piece : pieces) {
      if (piece.part != part || piece.side != side) continue;
      edge = edge || piece.holds || piece.length > tolerance;
      holds = holds || piece.holds;
    }
  }
  bool serves(Support support) const { return support == Support::free ? edge : holds; }
};

[[noreturn]] void fail(const std::string& name, Support support, const char* where) {
  const bool held = support != Support::free;
  throw InputError(
      name + ": the rock has no edge " + where + (held ? " to hold" : " to push") +
      "; an edge is of a side when it faces that way and both its ends lie on that side of the rectangle around "
      "the rock" +
      (held ? ", and is held where more than a half of it lies in the support" : ""));
}

}  // namespace

void require_edges(const Assembly& assembly, const std::vector<BoundaryEdge>& boundary, const Loads& loads,
                   const Particles& particles) {
  const std::vector<LoadedPiece> pieces = pieces_of_boundary(assembly, boundary, loads, particles);
  Loads alone;  // without parts that hide others
  const std::vector<LoadedPiece> sides = pieces_of_boundary(assembly, boundary, alone, particles);
  double longest = 0;
  for (const LoadedPiece& edge : sides) longest = std::max(longest, edge.length);
  const double tolerance = 1e-6 * longest;
  for (int side = 0; side < rock_side_count; ++side) {
    const auto s = static_cast<std::size_t>(side);
    const Found found(pieces, -1, side, tolerance), whole(sides, -1, side, tolerance);
    if (acts(loads, s) && !found.serves(loads.support[s]) && (found.edge || !whole.edge))
      fail(loads.name[s], loads.support[s], "on this side");
  }
  for (std::size_t p = 0; p < loads.parts.size(); ++p) {
    const SidePart& part = loads.parts[p];
    const int side = static_cast<int>(part.side);
    const Found found(pieces, static_cast<int>(p), side, tolerance);
    if (!acts(part) || found.serves(part.support)) continue;
    alone.parts = {part};
    const Found whole(pieces_of_boundary(assembly, boundary, alone, particles), 0, side, tolerance);
    if (found.edge || !whole.serves(part.support)) fail(part.name, part.support, "between its ends");
  }
}

}  // namespace vug
