// The compact list of fluid nodes on lattices small enough to check by hand.
#include "kernels/nodes/fluid_nodes.hpp"

#include "kernels/base/lattice_size.hpp"
#include "kernels/nodes/opening.hpp"
#include "kernels/scalar/advective_form.hpp"
#include "support/host_copy.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <set>
#include <vector>

namespace vug {
namespace {

using ::testing::ElementsAre;

/// Rows of '.', fluid, and '#', solid; the first row is the top.
Kokkos::View<NodeType*> node_types(const Lattice& lattice, const std::vector<std::string>& rows) {
  Kokkos::View<NodeType*> type("type", lattice.size());
  const auto host = Kokkos::create_mirror_view(type);
  Kokkos::deep_copy(host, NodeType::solid);
  for (int y = 0; y < lattice.ny; ++y)
    for (int x = 0; x < lattice.nx; ++x)
      if (rows[lattice.ny - 1 - y][x] == '.') host(lattice.node(x, y)) = NodeType::fluid;
  Kokkos::deep_copy(type, host);
  return type;
}

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
  const FluidNodes nodes = make_fluid_nodes(Exec{}, lattice, node_types(lattice, {"....", ".##.", "..#.", "...."}));
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
  const FluidNodes nodes = make_fluid_nodes(Exec{}, lattice, node_types(lattice, {"...", "...", "..."}), {true, false});
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
  auto type = node_types(lattice, {"####", "#..#", "####"});
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
    auto type = node_types(lattice, std::vector<std::string>(31, std::string(45, '#')));
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

TEST(Surface, IsTheSolidThatTouchesFluid) {
  const Lattice lattice(5, 5);
  const auto type = node_types(lattice, {"#####", "#####", "##.##", "#####", "#####"});
  const FluidNodes nodes = make_fluid_nodes(Exec{}, lattice, type);
  Surface surface;
  find_surface(Exec{}, nodes, type, surface);
  ASSERT_EQ(surface.count, 8);
  EXPECT_EQ(test::host_copy(surface.node)(0), lattice.node(1, 1));
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
  auto type = node_types(lattice, std::vector<std::string>(9, std::string(9, '.')));
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

TEST(BoundaryLinks, CornerDiagonalsBelongToOneSideOnly) {
  const Lattice lattice(3, 3);
  const FluidNodes nodes = make_fluid_nodes(Exec{}, lattice, node_types(lattice, {"...", "...", "..."}));
  int links = 0;
  for (const Side side : all_sides) links += find_boundary_links(Exec{}, nodes, side, 0, 2, 9).count;
  const auto side_links = test::host_copy(nodes.side_links);
  int bits = 0;
  for (int i = 0; i < nodes.count; ++i) bits += __builtin_popcount(side_links(i));
  EXPECT_EQ(links, bits);
  EXPECT_EQ(find_boundary_links(Exec{}, nodes, Side::left, 0, 2, 9).count, 9);
  EXPECT_EQ(find_boundary_links(Exec{}, nodes, Side::bottom, 0, 2, 9).count, 7);
  EXPECT_EQ(find_boundary_links(Exec{}, nodes, Side::top, 1, 1, 5).count, 1);
}

/// Two by two nodes in an opening, away from the edge and across joined sides.
TEST(Opening, TakesLinksFromFluidAndSharesItsAreaAmongThem) {
  const Lattice lattice(6, 5);
  for (const bool across : {false, true}) {
    const auto type = node_types(lattice, {"......", "......", "......", "......", "....#."});
    std::vector<int> inside;
    for (const int y : {1, 2})
      for (const int x : {across ? 5 : 2, across ? 0 : 3}) inside.push_back(lattice.node(x, y));
    const auto host = test::host_copy(type);
    for (const int n : inside) host(n) = NodeType::opening;
    Kokkos::deep_copy(type, host);
    const FluidNodes nodes = make_fluid_nodes(Exec{}, lattice, type, {across, false});
    EXPECT_EQ(nodes.count, 6 * 5 - 4 - 1);
    // the surface is the square: a link across its left or right face has a horizontal normal
    const Opening opening = make_opening(lattice, inside, [](const auto& at, const auto&) {
      return at[1] > 1 && at[1] < 3 ? std::array<double, 2>{1, 0} : std::array<double, 2>{0, 1};
    });
    for (const int directions : {5, 9}) {
      const BoundaryLinks links = find_opening_links(Exec{}, nodes, opening, directions);
      EXPECT_EQ(links.count, directions == 5 ? 8 : 8 + 12 - 1);  // two a face; the solid node has one of 12 diagonals
      const auto area = test::host_copy(link_areas(Exec{}, nodes, opening, directions));
      double total = 0;
      for (int l = 0; l < links.count; ++l) total += area(l);
      EXPECT_NEAR(total, 8, 1e-14) << directions;
      const auto fluid = test::host_copy(links.fluid);
      const auto direction = test::host_copy(links.direction);
      const auto side_links = test::host_copy(nodes.side_links);
      const auto solid_links = test::host_copy(nodes.solid_links);
      for (int l = 0; l < links.count; ++l) {
        EXPECT_TRUE(side_links(fluid(l)) >> direction(l) & 1);
        EXPECT_FALSE(solid_links(fluid(l)) >> direction(l) & 1);
      }
    }
  }
}

/// The defect of twelve nodes with velocities of some 0.02 in a closed domain, of `steps` steps of the flow.
template <class Set, class T>
std::vector<T> defect_of_closed_domain(int steps = 1) {
  const Lattice lattice(4, 4);
  const FluidNodes nodes = make_fluid_nodes(Exec{}, lattice, node_types(lattice, {"....", ".##.", "..#.", "...."}));
  VectorField<T> u("u", nodes.capacity);
  test::edit(u, [&](const auto& host) {
    for (int i = 0; i < nodes.count; ++i) {
      host(i, 0) = T(0.01 * (i % 5) - 0.02);
      host(i, 1) = T(0.015 * (i % 3) - 0.01);
    }
  });
  ScalarField<T> e("e", nodes.capacity);
  advective_defect<Set>(Exec{}, nodes, Displacement<T>(u, steps), e);
  const auto host = test::host_copy(e);
  return {host.data(), host.data() + nodes.count};
}

/// Not only to the digits that numbers near one have.
template <class Set, class T>
void expect_no_sum() {
  const std::vector<T> e = defect_of_closed_domain<Set, T>();
  const double sum = std::accumulate(e.begin(), e.end(), 0.0), eps = std::numeric_limits<T>::epsilon();
  EXPECT_LT(std::abs(sum), 0.1 * eps) << "in units of the last digit of one: " << sum / eps;
  EXPECT_GT(*std::max_element(e.begin(), e.end()), 1e-3);
}

TEST(AdvectiveDefect, SumsToZeroOverAClosedDomain) {
  expect_no_sum<D2Q5, double>();
  expect_no_sum<D2Q5, float>();
  expect_no_sum<D2Q9, double>();
  expect_no_sum<D2Q9, float>();
}

TEST(AdvectiveDefect, IsThriceThatOfOneStepWhereAScalarTakesThree) {
  const std::vector<double> once = defect_of_closed_domain<D2Q5, double>(),
                            thrice = defect_of_closed_domain<D2Q5, double>(3);
  for (std::size_t i = 0; i < once.size(); ++i) EXPECT_NEAR(thrice[i], 3 * once[i], 1e-15);
}

TEST(OpenLinks, AreThoseThatWereMarkedHoweverManyOfANode) {
  const Exec exec;
  const Lattice lattice(33, 3);  // several links of a node, and nodes side by side
  const FluidNodes nodes = make_fluid_nodes(exec, lattice, node_types(lattice, std::vector(3, std::string(33, '.'))));
  const auto expect_marked = [&](const auto& is_marked) {
    const auto open = test::host_copy(nodes.open_links), beyond = test::host_copy(nodes.side_links);
    const auto node = test::host_copy(nodes.node);
    for (int i = 0; i < nodes.count; ++i)
      for (int q = 0; q < 9; ++q)
        EXPECT_EQ(open(i) >> q & 1, is_marked(lattice.y(node(i)), q) ? beyond(i) >> q & 1 : 0) << i << " " << q;
  };
  constexpr SideOrder order{Side::bottom, Side::top, Side::left, Side::right};
  const auto mark = [&](Side side) {
    mark_open(exec, nodes, find_boundary_links(exec, nodes, side, 0, side_length(lattice, side) - 1, D2Q9::Q, order));
  };
  expect_marked([](int, int) { return false; });
  mark(Side::bottom);  // which has the diagonal links of its corners
  expect_marked([](int y, int q) { return y == 0 && D2Q9::c(q, 1) < 0; });
  for (const Side side : all_sides) mark(side);  // some for the second time
  expect_marked([](int, int) { return true; });
}

}  // namespace
}  // namespace vug
