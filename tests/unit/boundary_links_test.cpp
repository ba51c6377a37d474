// Links from fluid to rock, sides and openings on lattices small enough to check by hand.
#include "kernels/nodes/opening.hpp"
#include "support/flow_setup.hpp"
#include "support/host_copy.hpp"

#include <gmock/gmock.h>

#include <string>
#include <vector>

namespace vug {
namespace {

using test::draw;
using ::testing::ElementsAre;

TEST(Surface, IsTheSolidThatTouchesFluid) {
  const Lattice lattice(5, 5);
  const auto type = draw(lattice, {"#####", "#####", "##.##", "#####", "#####"});
  const FluidNodes nodes = make_fluid_nodes(Exec{}, lattice, type);
  Surface surface;
  find_surface(Exec{}, nodes, type, surface);
  ASSERT_EQ(surface.count, 8);
  EXPECT_EQ(test::host_copy(surface.node)(0), lattice.node(1, 1));
}

TEST(BoundaryLinks, CornerDiagonalsBelongToOneSideOnly) {
  const Lattice lattice(3, 3);
  const FluidNodes nodes = make_fluid_nodes(Exec{}, lattice, draw(lattice, {"...", "...", "..."}));
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
    const auto type = draw(lattice, {"......", "......", "......", "......", "....#."});
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

TEST(OpenLinks, AreThoseThatWereMarkedHoweverManyOfANode) {
  const Exec exec;
  const Lattice lattice(33, 3);  // several links of a node, and nodes side by side
  const FluidNodes nodes = make_fluid_nodes(exec, lattice, draw(lattice, std::vector(3, std::string(33, '.'))));
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
