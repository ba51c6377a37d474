// The rock on the lattice: owners, regions of bonds, strips, pathways, and what opening them does to the solid.
#include "coupling/rock_map.hpp"

#include "coupling/initial_pathways.hpp"
#include "coupling/pathways.hpp"

#include <gmock/gmock.h>

#include <numeric>

namespace vug {
namespace {

/// The square [0, 8] x [0, 8] cells, cut along its diagonal.
Assembly cut_square() {
  return {{{0, 0}, {8, 0}, {8, 8}, {0, 8}}, {{0, 1, 2}, {0, 2, 3}}, {}};
}

template <class ViewType>
auto on_host(const ViewType& view) {
  return Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, view);
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
  // the diagonal's 8 nodes go to the triangle of the lower number
  EXPECT_THAT(nodes, testing::ElementsAre(36, 28));
  EXPECT_EQ(std::accumulate(regions.begin(), regions.end(), 0), 64);
  EXPECT_GT(*std::min_element(regions.begin(), regions.end()), 0);
}

TEST(StripNodes, MeetWhereTheirLinesMeet) {
  const Lattice lattice(20, 20);
  const auto first = strip_nodes({2.5, 2.5}, {10.5, 10.5}, 1.5, lattice, 1.0);
  const auto second = strip_nodes({10.5, 10.5}, {18.5, 10.5}, 1.5, lattice, 1.0);
  std::vector<int> shared;
  for (const StripNode& a : first)
    for (const StripNode& b : second)
      if (a.node == b.node) shared.push_back(a.node);
  EXPECT_GE(shared.size(), 4u);
  EXPECT_NEAR(static_cast<double>(second.size()), 8 * 3 + 7, 4);  // three cells wide, round ends
}

TEST(InitialPathways, AreConnectedAndMeetTheTarget) {
  // a 7 x 7 grid of vertices; every edge opens three nodes of its own and shares one with all edges of its ends
  const int side = 7;
  std::vector<std::array<int, 2>> edges;
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) {
      if (x + 1 < side) edges.push_back({y * side + x, y * side + x + 1});
      if (y + 1 < side) edges.push_back({y * side + x, (y + 1) * side + x});
    }
  std::vector<std::vector<int>> strips;
  for (std::size_t e = 0; e < edges.size(); ++e) {
    const int own = 1000 + 3 * static_cast<int>(e);
    strips.push_back({edges[e][0], edges[e][1], own, own + 1, own + 2});
  }
  for (const int target : {100, 190, 260}) {
    const auto chosen = choose_pathways(edges, strips, std::vector<bool>(edges.size(), false), side * side, target, 7);
    std::set<int> open;
    std::vector<int> component(side * side);
    std::iota(component.begin(), component.end(), 0);
    for (int sweep = 0; sweep < side * side; ++sweep)
      for (std::size_t e = 0; e < edges.size(); ++e)
        if (chosen[e])
          component[edges[e][0]] = component[edges[e][1]] = std::min(component[edges[e][0]], component[edges[e][1]]);
    std::set<int> components;
    for (std::size_t e = 0; e < edges.size(); ++e) {
      if (!chosen[e]) continue;
      open.insert(strips[e].begin(), strips[e].end());
      components.insert(component[edges[e][0]]);
    }
    EXPECT_EQ(components.size(), 1u) << target;
    EXPECT_NEAR(static_cast<double>(open.size()), target, 4) << target;
    EXPECT_EQ(chosen, choose_pathways(edges, strips, std::vector<bool>(edges.size(), false), side * side, target, 7));
    EXPECT_NE(chosen, choose_pathways(edges, strips, std::vector<bool>(edges.size(), false), side * side, target, 8));
  }
}

TEST(PathwayAperture, GrowsLinearlyWithDamage) {
  EXPECT_EQ(pathway_aperture(0, 0, 3), 0);
  EXPECT_EQ(pathway_aperture(0.5, 1, 3), 2);
  EXPECT_EQ(pathway_aperture(1, 0, 3), 3);
}

/// One bond along y = 4 through one particle that owns the whole 8 x 8 lattice.
struct OneBond {
  Lattice lattice{8, 8};
  Kokkos::View<NodeType*> type{"type", std::size_t(Lattice(8, 8).size())};
  ScalarField<double> volume{"volume", std::size_t(Lattice(8, 8).size())};
  ScalarField<double> d_m{"d_m", 1};
  Groups particle;
  PathwayNodes nodes;

  OneBond() {
    Kokkos::deep_copy(type, NodeType::solid);
    const auto v = Kokkos::create_mirror_view(volume);
    for (int y = 0; y < 8; ++y)
      for (int x = 0; x < 8; ++x) v(lattice.node(x, y)) = 1 - 0.01 * x;
    Kokkos::deep_copy(volume, v);
    particle = group_nodes(std::vector<int>(64, 0), 1, lattice);
    const auto strip = strip_nodes({0, 4}, {8, 4}, 1.5, lattice, 1.0);
    const int n = static_cast<int>(strip.size());
    nodes = {IndexList("node", n),
             IndexList("offset", n + 1),
             IndexList("bond", n),
             ScalarField<double>("distance", n),
             ScalarField<double>("closed", 1),
             ScalarField<double>("open", 1)};
    const auto node = Kokkos::create_mirror_view(nodes.node), offset = Kokkos::create_mirror_view(nodes.offset);
    const auto distance = Kokkos::create_mirror_view(nodes.distance);
    for (int c = 0; c < n; ++c) {
      node(c) = lattice.node(strip[c].node % 8, strip[c].node / 8);
      distance(c) = strip[c].distance;
      offset(c + 1) = c + 1;
    }
    Kokkos::deep_copy(nodes.node, node);
    Kokkos::deep_copy(nodes.offset, offset);
    Kokkos::deep_copy(nodes.distance, distance);
    Kokkos::deep_copy(nodes.open, 3.0);
  }
  double total() const {
    const auto v = on_host(volume);
    double sum = 0;
    for (std::size_t i = 0; i < v.extent(0); ++i) sum += v(i);
    return sum;
  }
};

TEST(PathwayOpener, OpensWithDamageNeverClosesAndKeepsTheSolidVolume) {
  OneBond rock;
  PathwayOpener opener(rock.lattice, rock.nodes, rock.particle);
  const double before = rock.total();
  EXPECT_EQ(opener.open(Exec{}, rock.d_m, rock.type, rock.volume), 0);
  Kokkos::deep_copy(rock.d_m, 0.5);  // aperture 1.5: the two rows beside the line
  EXPECT_EQ(opener.open(Exec{}, rock.d_m, rock.type, rock.volume), 16);
  EXPECT_NEAR(rock.total(), before, 1e-12 * before);
  Kokkos::deep_copy(rock.d_m, 0.2);
  EXPECT_EQ(opener.open(Exec{}, rock.d_m, rock.type, rock.volume), 0);
  Kokkos::deep_copy(rock.d_m, 1.0);
  EXPECT_EQ(opener.open(Exec{}, rock.d_m, rock.type, rock.volume), 16);
  EXPECT_NEAR(rock.total(), before, 1e-12 * before);
  const auto type = on_host(rock.type);
  const auto volume = on_host(rock.volume);
  for (int x = 0; x < 8; ++x) {
    EXPECT_EQ(type(rock.lattice.node(x, 3)), NodeType::fluid);
    EXPECT_EQ(volume(rock.lattice.node(x, 3)), 0);
    EXPECT_GT(volume(rock.lattice.node(x, 0)), 1);
  }
}

}  // namespace
}  // namespace vug
