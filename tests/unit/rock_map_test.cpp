// The rock on the lattice: owners, regions of bonds, strips, pathways, and what opening them does to the solid.
#include "coupling/rock_map.hpp"

#include "coupling/initial_pathways.hpp"
#include "coupling/pathways.hpp"
#include "coupling/slits.hpp"
#include "coupling/strip.hpp"
#include "dem/edges.hpp"
#include "kernels/launch.hpp"
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
    const auto chosen = choose_pathways(rock.assembly, rock.strips, rock.fixed, target, 7);
    EXPECT_EQ(rock.pieces(chosen), 1) << target;
    EXPECT_NEAR(static_cast<double>(rock.opened(chosen).size()), target, 15) << target;
    EXPECT_EQ(chosen, choose_pathways(rock.assembly, rock.strips, rock.fixed, target, 7));
    EXPECT_NE(chosen, choose_pathways(rock.assembly, rock.strips, rock.fixed, target, 8));
  }
}

TEST(InitialPathways, AreAllBondsWhenThePorosityAsksForIt) {
  const CutSquares rock(5);
  const auto chosen = choose_pathways(rock.assembly, rock.strips, rock.fixed, 100000, 7);
  EXPECT_EQ(std::count(chosen.begin(), chosen.end(), true), static_cast<long>(rock.bonds.size()));
}

/// Away from the sides a joint ends only where it meets others: there are no dead ends.
TEST(InitialPathways, EndOnlyAtTheSides) {
  const int side = 13;
  const CutSquares rock(side);
  const auto chosen = choose_pathways(rock.assembly, rock.strips, rock.fixed, 600, 7);
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
    const auto chosen = choose_pathways(rock.assembly, rock.strips, rock.fixed, 200, seed);
    EXPECT_EQ(rock.pieces(chosen), 1) << seed;
    for (std::size_t b = 0; b < rock.bonds.size(); ++b) EXPECT_TRUE(chosen[b] || !rock.fixed[b]);
  }
}

TEST(PathwayAperture, GrowsLinearlyWithDamage) {
  EXPECT_EQ(pathway_aperture(0, 0, 3), 0);
  EXPECT_EQ(pathway_aperture(0.5, 1, 3), 2);
  EXPECT_EQ(pathway_aperture(1, 0, 3), 3);
}

TriangleNeighbours no_neighbours(int triangles) {
  const TriangleNeighbours neighbours("neighbours", triangles);
  Kokkos::deep_copy(neighbours, -1);
  return neighbours;
}

/// One bond along y = 4 through one particle that owns the whole 8 x 8 lattice.
struct OneBond {
  Lattice lattice{8, 8};
  Kokkos::View<NodeType*> type{"type", std::size_t(Lattice(8, 8).size())};
  ScalarField<double> volume{"volume", std::size_t(Lattice(8, 8).size())};
  ScalarField<double> dissolved{"dissolved", std::size_t(Lattice(8, 8).size())};
  ScalarField<double> d_m{"d_m", 1};
  NodeGroups particle;
  PathwayNodes nodes;

  OneBond() {
    Kokkos::deep_copy(type, NodeType::solid);
    const auto v = Kokkos::create_mirror_view(volume);
    for (int y = 0; y < 8; ++y)
      for (int x = 0; x < 8; ++x) v(lattice.node(x, y)) = 1 - 0.01 * x;
    Kokkos::deep_copy(volume, v);
    particle = group_nodes(std::vector<int>(64, 0), 1, lattice);
    const auto strip = strip_nodes({0, 4}, {8, 4}, 3, lattice, 1.0);
    const int n = static_cast<int>(strip.size());
    nodes = {IndexList("node", n),
             IndexList("offset", n + 1),
             IndexList("bond", n),
             ScalarField<double>("least", n),
             ScalarField<double>("closed", 1),
             ScalarField<double>("open", 1),
             ScalarField<double>("slope", 1),
             IndexList("in_order", n),
             IndexList("first", 2)};
    const auto node = Kokkos::create_mirror_view(nodes.node), offset = Kokkos::create_mirror_view(nodes.offset);
    const auto least = Kokkos::create_mirror_view(nodes.least);
    const auto in_order = Kokkos::create_mirror_view(nodes.in_order), first = Kokkos::create_mirror_view(nodes.first);
    first(1) = n;
    Kokkos::deep_copy(nodes.first, first);
    for (int c = 0; c < n; ++c) {
      node(c) = lattice.node(strip[c].node % 8, strip[c].node / 8);
      least(c) = strip[c].aperture;
      offset(c + 1) = c + 1;
      in_order(c) = n - 1 - c;
    }
    Kokkos::deep_copy(nodes.in_order, in_order);
    Kokkos::deep_copy(nodes.node, node);
    Kokkos::deep_copy(nodes.offset, offset);
    Kokkos::deep_copy(nodes.least, least);
    Kokkos::deep_copy(nodes.open, 3.0);
  }
  double total() const {
    const auto v = test::host_copy(volume);
    double sum = 0;
    for (std::size_t i = 0; i < v.extent(0); ++i) sum += v(i);
    return sum;
  }
};

TEST(PathwayOpener, OpensWithDamageNeverClosesAndKeepsTheSolidVolume) {
  OneBond rock;
  PathwayOpener opener(rock.lattice, rock.nodes, SolidSpread(rock.particle, no_neighbours(1)));
  const double before = rock.total();
  const auto open = [&](double d_m) {
    Kokkos::deep_copy(rock.d_m, d_m);
    return opener.look(Exec{}, rock.d_m).changed > 0 ? opener.open(Exec{}, rock.type, rock.volume, rock.dissolved) : 0;
  };
  EXPECT_EQ(open(0), 0);
  EXPECT_EQ(open(0.3), 0);       // narrower than a cell
  EXPECT_EQ(open(2.0 / 3), 16);  // the two rows beside the line
  EXPECT_NEAR(rock.total(), before, 1e-12 * before);
  EXPECT_EQ(open(0.2), 0);
  EXPECT_EQ(open(1.0), 8);  // the third row, the lower one of two as near
  EXPECT_NEAR(rock.total() + sum_in_order(opener.waiting()), before, 1e-12 * before);
  const auto type = test::host_copy(rock.type);
  const auto volume = test::host_copy(rock.volume);
  for (int x = 0; x < 8; ++x) {
    EXPECT_EQ(type(rock.lattice.node(x, 3)), NodeType::fluid);
    EXPECT_EQ(volume(rock.lattice.node(x, 3)), 0);
    EXPECT_EQ(type(rock.lattice.node(x, 2)), NodeType::fluid);
    EXPECT_EQ(type(rock.lattice.node(x, 5)), NodeType::solid);
    EXPECT_GT(volume(rock.lattice.node(x, 0)), 1.3);
    EXPECT_LE(volume(rock.lattice.node(x, 0)), most_solid * (1 + 1e-14));
  }
}

/// Its nodes stay open and must be dragged, also where it closes at once and for good.
TEST(PathwayOpener, SeesACrackThatIsNarrowerThanItHasBeen) {
  OneBond rock;
  PathwayOpener opener(rock.lattice, rock.nodes, SolidSpread(rock.particle, no_neighbours(1)));
  const auto narrow = [&](double d_m) {
    Kokkos::deep_copy(rock.d_m, d_m);
    return opener.look(Exec{}, rock.d_m).narrow;
  };
  EXPECT_EQ(narrow(0), 0);
  EXPECT_EQ(narrow(1), 0);        // three whole rows
  EXPECT_EQ(narrow(2.0 / 3), 1);  // two of them
  EXPECT_EQ(narrow(0), 1);
  EXPECT_EQ(narrow(1), 0);
}

/// A crack half a cell wide: one row is open, and its resistance is that of the cubic law and of what acid adds.
TEST(Slits, HaveTheResistanceOfTheCrackThatAcidWidens) {
  OneBond rock;
  Geometry geometry;
  geometry.lattice = rock.lattice;
  geometry.type = rock.type;
  geometry.dissolved = rock.dissolved;
  const BondPathways bonds{ScalarField<double>("strip", 1), ScalarField<double>("widest", 1),
                           ScalarField<double>("conductivity", 1)};
  Kokkos::deep_copy(bonds.strip, 1.0);
  Kokkos::deep_copy(bonds.widest, 1.0);
  Kokkos::deep_copy(bonds.conductivity, cubic_law(0.5));
  const auto type = Kokkos::create_mirror_view(rock.type);
  Kokkos::deep_copy(type, rock.type);
  for (int x = 0; x < 8; ++x) type(rock.lattice.node(x, 3)) = NodeType::fluid;
  Kokkos::deep_copy(rock.type, type);
  geometry.fluid = make_fluid_nodes(Exec{}, rock.lattice, rock.type);
  const auto dissolved = Kokkos::create_mirror_view(rock.dissolved);
  dissolved(rock.lattice.node(2, 4)) = 0.1;  // one wall of column 2, both of column 5, all of that of column 7
  dissolved(rock.lattice.node(5, 2)) = 0.2;
  dissolved(rock.lattice.node(5, 4)) = 0.3;
  dissolved(rock.lattice.node(7, 4)) = 1;
  Kokkos::deep_copy(rock.dissolved, dissolved);
  Slits slits(rock.nodes);
  slits.update(Exec{}, bonds, geometry);
  ASSERT_EQ(geometry.slits.count, 7);
  EXPECT_EQ(geometry.slit_changes, 1);
  slits.update(Exec{}, bonds, geometry);
  EXPECT_EQ(geometry.slit_changes, 1);
  const auto fluid = test::host_copy(geometry.slits.fluid);
  const auto resistance = test::host_copy(geometry.slits.resistance);
  const auto first = test::host_copy(geometry.slits.first);
  EXPECT_EQ(first(0), 0);
  EXPECT_EQ(first(1), 7);
  for (int k = 0; k < 7; ++k) {
    const int x = fluid(k);  // numbered along the row
    const double w = x == 2 ? 0.6 : x == 5 ? 1.0 : 0.5;
    EXPECT_NEAR(resistance(k), 12 / (w * w * w) - 8, 1e-9) << x;
  }
  // the crack closes: what it has opened is a hundredth of a cell wide
  Kokkos::deep_copy(bonds.strip, 0.0);
  slits.update(Exec{}, bonds, geometry);
  ASSERT_EQ(geometry.slits.count, 8);
  EXPECT_EQ(test::host_copy(geometry.slits.fluid)(7), 0);
  EXPECT_NEAR(test::host_copy(geometry.slits.resistance)(7) / (12 / 1e-6 - 8), 1, 1e-9);
}

/// A row of triangles, each of which owns 8 x 8 nodes of a strip of the lattice.
struct RowOfTriangles {
  static constexpr int count = 5, size = 8;
  Lattice lattice{size * count, size};
  Kokkos::View<NodeType*> type{"type", std::size_t(lattice.size())};
  Kokkos::View<std::uint8_t*> opening{"opening", std::size_t(lattice.size())};
  ScalarField<double> volume{"volume", std::size_t(lattice.size())};
  ScalarField<double> dissolved{"dissolved", std::size_t(lattice.size())};
  NodeGroups nodes;
  TriangleNeighbours neighbours = no_neighbours(count);

  RowOfTriangles() {
    std::vector<int> key;
    for (int n = 0; n < size * size * count; ++n) key.push_back(n % (size * count) / size);
    nodes = group_nodes(key, count, lattice);
    for (int t = 0; t < count; ++t) {
      neighbours(t, 0) = t - 1;
      neighbours(t, 1) = t + 1 < count ? t + 1 : -1;
      nodes.for_each(t, [&](int n) {
        type(n) = NodeType::solid;
        volume(n) = 1;
      });
    }
  }
  /// All nodes of a triangle but those of its last `left` columns.
  void open(int t, int left) {
    nodes.for_each(t, [&](int n) {
      if (lattice.x(n) % size >= size - left || type(n) == NodeType::fluid) return;
      type(n) = NodeType::fluid;
      opening(n) = 1;
    });
  }
  double held(int t) const {
    double sum = 0;
    nodes.for_each(t, [&](int n) { sum += volume(n); });
    return sum;
  }
  double most() const {
    double most = 0;
    for (int t = 0; t < count; ++t) nodes.for_each(t, [&](int n) { most = std::max(most, volume(n) + dissolved(n)); });
    return most;
  }
};

TEST(SolidSpread, StaysInTheTriangleWhereThereIsRoom) {
  if constexpr (!shares_host_memory) GTEST_SKIP() << "reads views on the host";
  RowOfTriangles rock;
  SolidSpread spread(rock.nodes, rock.neighbours);
  rock.open(2, 5);
  spread(Exec{}, rock.type, rock.opening, rock.volume, rock.dissolved);
  EXPECT_NEAR(rock.held(2), 64, 1e-12);
  EXPECT_NEAR(rock.most(), 8.0 / 5, 1e-14);
  EXPECT_EQ(rock.held(1), 64);
  for (int n = 0; n < rock.lattice.size(); ++n) EXPECT_EQ(rock.opening(n), 0);
}

TEST(SolidSpread, GoesOnToTheNeighboursBeforeANodeHoldsMoreThanTheBound) {
  if constexpr (!shares_host_memory) GTEST_SKIP() << "reads views on the host";
  RowOfTriangles rock;
  SolidSpread spread(rock.nodes, rock.neighbours);
  for (const int left : {3, 1, 0}) {
    rock.open(2, left);
    spread(Exec{}, rock.type, rock.opening, rock.volume, rock.dissolved);
    EXPECT_NEAR(rock.held(2), 2 * 8 * left, 1e-12);
    EXPECT_NEAR(rock.held(1), rock.held(3), 1e-12);
    EXPECT_NEAR(rock.held(0) + rock.held(1) + rock.held(2) + rock.held(3) + rock.held(4), 5 * 64, 1e-12);
    EXPECT_EQ(sum_in_order(spread.waiting()), 0);
    EXPECT_LE(rock.most(), most_solid);
  }
  for (const int t : {1, 3}) rock.open(t, 0);  // 128 nodes are left for the solid of 320
  spread(Exec{}, rock.type, rock.opening, rock.volume, rock.dissolved);
  EXPECT_NEAR(rock.held(0), 128, 1e-12);
  EXPECT_NEAR(sum_in_order(spread.waiting()), 320 - 256, 1e-12);
  rock.open(0, 4);  // what has been waiting waits on beside what is freed now
  spread(Exec{}, rock.type, rock.opening, rock.volume, rock.dissolved);
  EXPECT_NEAR(rock.held(0) + rock.held(4), 64 + 128, 1e-12);
  EXPECT_NEAR(sum_in_order(spread.waiting()), 320 - 192, 1e-12);
}

/// The rows of the lattice are two minerals in turn, of which one opens in the middle triangle.
TEST(SolidSpread, KeepsTheVolumeOfEachMineral) {
  if constexpr (!shares_host_memory) GTEST_SKIP() << "reads views on the host";
  RowOfTriangles rock;
  const Kokkos::View<std::uint8_t*> mineral("mineral", rock.lattice.size());
  for (int n = 0; n < rock.lattice.size(); ++n) mineral(n) = static_cast<std::uint8_t>((rock.lattice.y(n) + 2) % 2);
  SolidSpread spread(rock.nodes, rock.neighbours, {mineral, 2});
  const auto held = [&](int m) {
    double sum = 0;
    for (int t = 0; t < RowOfTriangles::count; ++t)
      rock.nodes.for_each(t, [&](int n) { sum += mineral(n) == m ? rock.volume(n) : 0.0; });
    return sum;
  };
  rock.open(2, 3);
  spread(Exec{}, rock.type, rock.opening, rock.volume, rock.dissolved);
  for (const int m : {0, 1}) EXPECT_NEAR(held(m), 5 * 32, 1e-12) << m;
  rock.nodes.for_each(1, [&](int n) {  // mineral 1 of the second triangle opens, all of it
    if (mineral(n) == 0 || rock.type(n) == NodeType::fluid) return;
    rock.type(n) = NodeType::fluid;
    rock.opening(n) = 1;
  });
  const double of_other = held(0);
  spread(Exec{}, rock.type, rock.opening, rock.volume, rock.dissolved);
  EXPECT_EQ(held(0), of_other);
  EXPECT_NEAR(held(1) + sum_in_order(spread.waiting(1)), 5 * 32, 1e-12);
  EXPECT_EQ(sum_in_order(spread.waiting(0)), 0);
}

TEST(SolidSpread, GivesAWallThatIsNearlyGoneNoMoreThanItHolds) {
  EXPECT_DOUBLE_EQ(room_for_solid(1, 0), most_solid - 1);
  EXPECT_DOUBLE_EQ(room_for_solid(0.1, 0.9), 0.1);
  EXPECT_DOUBLE_EQ(room_for_solid(1.5, 0.25), most_solid - 1.75);
  EXPECT_EQ(room_for_solid(1.5, 1), 0);
  EXPECT_EQ(room_for_solid(-0.1, 1.1), 0);
}

}  // namespace
}  // namespace vug
