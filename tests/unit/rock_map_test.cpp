// The rock on the lattice: owners, regions of bonds, strips, initial pathways.
#include "coupling/rock_map.hpp"

#include "coupling/initial_pathways.hpp"
#include "coupling/strip.hpp"
#include "dem/edges.hpp"
#include "support/host_copy.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <numeric>
#include <set>

namespace vug {
namespace {

/// The square [0, 8] x [0, 8] cells, cut along its diagonal.
Assembly cut_square() {
  return {{{0, 0}, {8, 0}, {8, 8}, {0, 8}}, {{0, 1, 2}, {0, 2, 3}}, {}};
}

TEST(RockRaster, EveryNodeHasOneOwnerAndTheRegionsTileTheTriangles) {
  const Lattice lattice(8, 8);
  const RockRaster raster = rasterise(cut_square(), lattice, 1.0);
  std::array<int, 2> nodes{0, 0};
  std::array<int, 6> regions{};
  for (std::size_t n = 0; n < raster.owner.size(); ++n) {
    ASSERT_GE(raster.owner[n], 0);
    ++nodes[raster.owner[n]];
    ++regions[3 * raster.owner[n] + raster.edge[n]];
  }
  // the diagonal's 8 nodes go to the triangle right of it
  EXPECT_THAT(nodes, testing::ElementsAre(36, 28));
  EXPECT_EQ(std::accumulate(regions.begin(), regions.end(), 0), 64);
  EXPECT_GT(*std::min_element(regions.begin(), regions.end()), 0);
}

/// Edges along and through centres of cells, with what rounding leaves of coordinates: each centre has one owner, the
/// one to the right or above, in any order of the triangles.
TEST(RockRaster, TiesAreNotDecidedByOrderOrRounding) {
  const Lattice lattice(8, 8);
  for (const double spacing : {1.0, 5e-5, 1e-3 / 3})
    for (const double shift : {0.0, 1e-12, -1e-12}) {
      const auto at = [&](double x, double y) { return std::array{x * spacing, (y + shift) * spacing}; };
      Assembly rock{{at(0, 0), at(8, 0), at(8, 3.5), at(0, 3.5), at(8, 8), at(0, 8)},
                    {{0, 1, 2}, {0, 2, 3}, {3, 2, 4}, {3, 4, 5}},
                    {}};
      for (int order = 0; order < 2; ++order) {
        const RockRaster raster = rasterise(rock, lattice, spacing);
        for (int n = 0; n < 64; ++n) {
          ASSERT_GE(raster.owner[n], 0);
          const bool upper = (raster.owner[n] >= 2) != (order == 1);
          EXPECT_EQ(upper, n / 8 >= 3) << n;  // the centres of row 3 lie on the edge
        }
        std::reverse(rock.triangles.begin(), rock.triangles.end());
      }
    }
}

/// side x side vertices, every square cut in two; strips in which every bond opens three nodes of its own and shares
/// one with all bonds of its ends.
struct CutSquares {
  Assembly assembly;
  std::vector<Edge> bonds;
  std::vector<std::vector<int>> strips;
  std::vector<bool> fixed;

  explicit CutSquares(int side) {
    for (int y = 0; y < side; ++y)
      for (int x = 0; x < side; ++x) assembly.vertices.push_back({double(x), double(y)});
    for (int y = 0; y + 1 < side; ++y)
      for (int x = 0; x + 1 < side; ++x) {
        const int a = y * side + x, b = a + 1, c = a + side, d = c + 1;
        assembly.triangles.push_back({a, b, d});
        assembly.triangles.push_back({a, d, c});
      }
    for (const Edge& edge : find_edges(assembly)) {
      if (edge.triangle[1] < 0) continue;
      const int own = 1000 + 3 * static_cast<int>(bonds.size());
      bonds.push_back(edge);
      strips.push_back({edge.vertex[0], edge.vertex[1], own, own + 1, own + 2});
    }
    fixed.assign(bonds.size(), false);
  }
  std::vector<bool> choose(int nodes, std::uint64_t seed) const {
    return choose_pathways(assembly, fixed, nodes, seed, [&](const auto& open) { return count_nodes(open, strips); });
  }
  std::set<int> opened(const std::vector<bool>& chosen) const {
    std::set<int> nodes;
    for (std::size_t b = 0; b < bonds.size(); ++b)
      if (chosen[b]) nodes.insert(strips[b].begin(), strips[b].end());
    return nodes;
  }
  /// Connected pieces of the chosen bonds.
  int pieces(const std::vector<bool>& chosen) const {
    std::vector<int> piece(assembly.vertices.size());
    std::iota(piece.begin(), piece.end(), 0);
    for (std::size_t sweep = 0; sweep < piece.size(); ++sweep)
      for (std::size_t b = 0; b < bonds.size(); ++b)
        if (chosen[b])
          piece[bonds[b].vertex[0]] = piece[bonds[b].vertex[1]] =
              std::min(piece[bonds[b].vertex[0]], piece[bonds[b].vertex[1]]);
    std::set<int> pieces;
    for (std::size_t b = 0; b < bonds.size(); ++b)
      if (chosen[b]) pieces.insert(piece[bonds[b].vertex[0]]);
    return static_cast<int>(pieces.size());
  }
};

TEST(NodeGroups, HoldEveryNodeOfTheirKeyInOrder) {
  const Lattice lattice(7, 5);
  std::vector<int> key;
  for (int n = 0; n < 35; ++n) key.push_back(n < 21 ? n / 3 % 3 : n % 4 - 1);  // runs that end with their row, gaps
  const NodeGroups groups = group_nodes(key, 4, lattice);
  const auto offset = test::host_copy(groups.offset), first = test::host_copy(groups.first),
             length = test::host_copy(groups.length), nodes = test::host_copy(groups.nodes);
  ASSERT_EQ(groups.count(), 4);
  for (int g = 0; g < 4; ++g) {
    std::vector<int> expected, found;
    for (int n = 0; n < 35; ++n)
      if (key[n] == g) expected.push_back(lattice.node(n % 7, n / 7));
    for (int r = offset(g); r < offset(g + 1); ++r)
      for (int i = 0; i < length(r); ++i) found.push_back(first(r) + i);
    EXPECT_EQ(found, expected) << g;
    EXPECT_EQ(nodes(g), static_cast<int>(expected.size())) << g;
  }
}

TEST(InitialPathways, AreConnectedAndMeetTheTarget) {
  const CutSquares rock(13);
  for (const int target : {300, 600, 900, 1200}) {
    const auto chosen = rock.choose(target, 7);
    EXPECT_EQ(rock.pieces(chosen), 1) << target;
    EXPECT_NEAR(static_cast<double>(rock.opened(chosen).size()), target, 15) << target;
    EXPECT_EQ(chosen, rock.choose(target, 7));
    EXPECT_NE(chosen, rock.choose(target, 8));
  }
}

TEST(InitialPathways, AreAllBondsWhenThePorosityAsksForIt) {
  const CutSquares rock(5);
  const auto chosen = rock.choose(100000, 7);
  EXPECT_EQ(std::count(chosen.begin(), chosen.end(), true), static_cast<long>(rock.bonds.size()));
}

/// Away from the sides a joint ends only where it meets others: there are no dead ends.
TEST(InitialPathways, EndOnlyAtTheSides) {
  const int side = 13;
  const CutSquares rock(side);
  const auto chosen = rock.choose(600, 7);
  std::vector<int> degree(rock.assembly.vertices.size(), 0);
  for (std::size_t b = 0; b < rock.bonds.size(); ++b)
    if (chosen[b])
      for (const int v : rock.bonds[b].vertex) ++degree[v];
  for (int y = 1; y + 1 < side; ++y)
    for (int x = 1; x + 1 < side; ++x) EXPECT_NE(degree[y * side + x], 1) << x << " " << y;
}

TEST(InitialPathways, ReachANotchThatLiesWithinABlock) {
  CutSquares rock(13);
  for (std::size_t b = 0; b < rock.bonds.size(); ++b)  // one bond in the middle
    rock.fixed[b] = std::ranges::is_permutation(rock.bonds[b].vertex, std::array{6 * 13 + 6, 6 * 13 + 7});
  ASSERT_EQ(std::count(rock.fixed.begin(), rock.fixed.end(), true), 1);
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const auto chosen = rock.choose(200, seed);
    EXPECT_EQ(rock.pieces(chosen), 1) << seed;
    for (std::size_t b = 0; b < rock.bonds.size(); ++b) EXPECT_TRUE(chosen[b] || !rock.fixed[b]);
  }
}

}  // namespace
}  // namespace vug
