// The compact list of fluid nodes on lattices small enough to check by hand.
#include "kernels/nodes/fluid_nodes.hpp"

#include "base/lattice_size.hpp"
#include "support/flow_setup.hpp"
#include "support/host_copy.hpp"

#include <gtest/gtest.h>

#include <set>
#include <vector>

namespace vug {
namespace {

using test::draw;

TEST(Lattice, HaloSurroundsEveryNodeWithoutWrapping) {
  const Lattice lattice(5, 3);
  EXPECT_EQ(lattice.x(lattice.node(4, 2)), 4);
  EXPECT_EQ(lattice.y(lattice.node(4, 2)), 2);
  std::set<int> distinct;
  for (int y = -1; y <= 3; ++y)
    for (int x = -1; x <= 5; ++x) {
      const int n = lattice.node(x, y);
      EXPECT_GE(n, 0);
      EXPECT_LT(n, lattice.size());
      distinct.insert(n);
    }
  EXPECT_EQ(distinct.size(), 35u);
}

TEST(FluidNodes, EverySlotIsPulledExactlyOnceByStreamingOrBounceBack) {
  const Lattice lattice(4, 4);
  const FluidNodes nodes = make_fluid_nodes(Exec{}, lattice, draw(lattice, {"....", ".##.", "..#.", "...."}));
  ASSERT_EQ(nodes.count, 13);
  const auto source = test::host_copy(nodes.source);
  std::multiset<int> pulled;
  for (int q = 0; q < 9; ++q)
    for (int i = 0; i < nodes.count; ++i) pulled.insert(source(q * nodes.capacity + i));
  for (int q = 0; q < 9; ++q)
    for (int i = 0; i < nodes.count; ++i) EXPECT_EQ(pulled.count(q * nodes.capacity + i), 1u) << q << ' ' << i;
}

TEST(FluidNodes, PeriodicSidesJoinAndLeaveNoSideLinks) {
  const Lattice lattice(3, 3);
  const FluidNodes nodes = make_fluid_nodes(Exec{}, lattice, draw(lattice, {"...", "...", "..."}), {true, false});
  const auto source = test::host_copy(nodes.source);
  const auto side = test::host_copy(nodes.side_links);
  // direction 1 at (0, 1) comes from (2, 1)
  EXPECT_EQ(source(1 * nodes.capacity + 3), 1 * nodes.capacity + 5);
  EXPECT_EQ(side(3), 0);
  // direction 2 at (0, 0) comes back from the bottom wall
  EXPECT_EQ(source(2 * nodes.capacity + 0), 4 * nodes.capacity + 0);
  EXPECT_EQ(side(0), (1u << 4) | (1u << 7) | (1u << 8));
}

TEST(FluidNodes, BirthsAppendInOrderAndKeepNumbers) {
  const Lattice lattice(4, 3);
  auto type = draw(lattice, {"####", "#..#", "####"});
  FluidNodes nodes = make_fluid_nodes(Exec{}, lattice, type);
  ASSERT_EQ(nodes.count, 2);
  const auto host = Kokkos::create_mirror_view(type);
  Kokkos::deep_copy(host, type);
  host(lattice.node(3, 2)) = NodeType::fluid;
  host(lattice.node(0, 0)) = NodeType::fluid;
  Kokkos::deep_copy(type, host);
  EXPECT_EQ(append_births(Exec{}, type, nodes), 2);
  EXPECT_EQ(append_births(Exec{}, type, nodes), 0);
  const auto node = test::host_copy(nodes.node);
  EXPECT_EQ(std::vector<int>(node.data(), node.data() + 4),
            (std::vector<int>{lattice.node(1, 1), lattice.node(2, 1), lattice.node(0, 0), lattice.node(3, 2)}));
  // the newborn at (0, 0) now feeds direction 5 of (1, 1)
  EXPECT_EQ(test::host_copy(nodes.source)(5 * nodes.capacity + 0), 5 * nodes.capacity + 2);
}

TEST(FluidNodes, TablesAfterBirthsAreThoseOfAFreshStart) {
  const Lattice lattice(45, 31);
  for (const bool joined : {false, true}) {
    auto type = draw(lattice, std::vector<std::string>(31, std::string(45, '#')));
    const auto host = Kokkos::create_mirror_view(type);
    Kokkos::deep_copy(host, type);
    const auto open = [&](int step, int of) {
      for (int y = 0; y < lattice.ny; ++y)
        for (int x = 0; x < lattice.nx; ++x)
          if ((7 * x + 13 * y * y) % of == step) host(lattice.node(x, y)) = NodeType::fluid;
      Kokkos::deep_copy(type, host);
    };
    open(0, 3);
    FluidNodes nodes = make_fluid_nodes(Exec{}, lattice, type, {joined, false});
    for (int step = 0; step < 12; ++step) {
      open(step, 36);
      append_births(Exec{}, type, nodes);
      FluidNodes fresh = make_fluid_nodes(Exec{}, lattice, type, {joined, false});
      set_fluid_nodes(Exec{}, Kokkos::subview(nodes.node, std::pair(0, nodes.count)), nodes.capacity, fresh);
      ASSERT_EQ(fresh.count, nodes.count);
      const auto solid = test::host_copy(nodes.solid_links), side = test::host_copy(nodes.side_links);
      const auto expected_solid = test::host_copy(fresh.solid_links), expected_side = test::host_copy(fresh.side_links);
      const auto source = test::host_copy(nodes.source), expected_source = test::host_copy(fresh.source);
      for (int i = 0; i < nodes.count; ++i) {
        ASSERT_EQ(expected_solid(i), solid(i)) << step << ' ' << i;
        ASSERT_EQ(expected_side(i), side(i)) << step << ' ' << i;
        for (int q = 0; q < D2Q9::Q; ++q)
          ASSERT_EQ(expected_source(q * nodes.capacity + i), source(q * nodes.capacity + i));
      }
      const auto windows = test::host_copy(nodes.windows), expected = test::host_copy(fresh.windows);
      for (int w = 0; has_source_windows && w < nodes.count / nodes_per_window * nodes_per_window; ++w)
        ASSERT_TRUE(windows(w) == expected(w)) << step << ' ' << w;
    }
  }
}

TEST(FluidNodes, GrowthKeepsPopulations) {
  ScalarField<double> h("h", 5 * 16);
  const auto host = Kokkos::create_mirror_view(h);
  for (int q = 0; q < 5; ++q)
    for (int i = 0; i < 7; ++i) host(q * 16 + i) = 10 * q + i;
  Kokkos::deep_copy(h, host);
  const auto moved = test::host_copy(restride(Exec{}, h, 5, 7, 16, 32));
  for (int q = 0; q < 5; ++q)
    for (int i = 0; i < 7; ++i) EXPECT_EQ(moved(q * 32 + i), 10 * q + i);
}

/// The list never asks for more than the lattice has, so that slots of nine directions keep numbers that an int holds.
TEST(FluidNodes, GrowByHalfButNotBeyondTheLattice) {
  EXPECT_EQ(grown_capacity(100, 100, 1000), 1500);
  EXPECT_EQ(grown_capacity(100, 100, 6667), 10000);
  EXPECT_EQ(grown_capacity(100, 100, 10000), 10000);
  EXPECT_EQ(dense_nodes(70, 5), Lattice(70, 5).size());
  const int nx = 15440, ny = 15420;  // 238 million nodes
  ASSERT_LE(dense_nodes(nx, ny), most_nodes);
  for (const int count : {150000000, 160000000, 200000000, nx * ny}) {
    const int capacity = grown_capacity(nx, ny, count);
    EXPECT_GE(capacity, count);
    EXPECT_LE((capacity + 15) / 16 * 16, most_nodes) << count;
  }
  // of a lattice that is nearly full
  const Lattice lattice(9, 9);
  auto type = draw(lattice, std::vector<std::string>(9, std::string(9, '.')));
  const auto host = test::host_copy(type);
  host(lattice.node(4, 4)) = NodeType::solid;
  Kokkos::deep_copy(type, host);
  FluidNodes nodes = make_fluid_nodes(Exec{}, lattice, type);
  EXPECT_EQ(nodes.capacity, 80);
  host(lattice.node(4, 4)) = NodeType::fluid;
  Kokkos::deep_copy(type, host);
  append_births(Exec{}, type, nodes);
  EXPECT_EQ(nodes.count, 81);
  EXPECT_EQ(nodes.capacity, 96);
}

}  // namespace
}  // namespace vug
