// Normals and areas of surfaces of rock.
#include "kernels/reaction/surface_normal.hpp"

#include "../reference/drawn_box.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace vug {
namespace {

using reference::Box;
using reference::box_of;
using test::edit;
using test::host_copy;

TEST(SurfaceNormal, PointsFromTheSolidIntoTheFluid) {
  const std::array<std::pair<std::vector<std::string>, std::array<double, 2>>, 4> walls{{
      {{".....", ".....", "#####", "#####", "#####"}, {0, 1}},
      {{"#####", "#####", "#####", ".....", "....."}, {0, -1}},
      {{"###..", "###..", "###..", "###..", "###.."}, {1, 0}},
      {{"..###", "..###", "..###", "..###", "..###"}, {-1, 0}},
  }};
  for (const auto& [rows, direction] : walls) {
    Box box = box_of(rows);
    VectorField<double> normal;
    find_normals(box.exec, box.nodes, box.surface, box.V, box.dissolved, normal);
    const auto n = host_copy(normal);
    for (int s = 0; s < box.surface.count; ++s)
      for (int axis = 0; axis < 2; ++axis) EXPECT_NEAR(n(s, axis), direction[axis], 1e-15);
    EXPECT_NEAR(surface_area<D2Q5>(box.exec, box.nodes, box.surface, normal), 5, 1e-14);
  }
}

/// Rock whose opened pathways have handed their solid to the nodes beside them is as flat as any.
TEST(SurfaceNormal, DoesNotSeeWhereSolidOfOpenedPathwaysHasGone) {
  for (const int slope : {0, 1, 2}) {  // a wall that rises by `slope` nodes in 2
    constexpr int nx = 40, ny = 60;
    Box box(
        nx, ny, [&](int x, int y) { return 2 * y < slope * x + 20; }, solute_parameters(0.1));
    VectorField<double> uncracked, cracked;
    find_normals(box.exec, box.nodes, box.surface, box.V, box.dissolved, uncracked);
    const double area = surface_area<D2Q5>(box.exec, box.nodes, box.surface, uncracked);
    edit(box.V, [&](const auto& V) {
      for (int y = 0; y < ny; ++y)
        for (int x = 0; x < nx; ++x) {
          const int n = box.lattice.node(x, y);
          if (V(n) > 0 && (x / 7 + y / 5) % 2) V(n) = 1.5;  // one triangle, and its neighbour with 1
        }
    });
    find_normals(box.exec, box.nodes, box.surface, box.V, box.dissolved, cracked);
    const auto of_cracked = host_copy(cracked), of_uncracked = host_copy(uncracked);
    for (int s = 0; s < box.surface.count; ++s)
      for (int axis = 0; axis < 2; ++axis) ASSERT_EQ(of_cracked(s, axis), of_uncracked(s, axis)) << slope << " " << s;
    EXPECT_EQ(surface_area<D2Q5>(box.exec, box.nodes, box.surface, cracked), area);
    const auto node = host_copy(box.surface.node), index = host_copy(box.nodes.index);
    double length = 0;  // between columns 6 and 34, away from the sides
    for (int s = 0; s < box.surface.count; ++s)
      for (int q = 1; q < D2Q5::Q; ++q) {
        const int n = node(s), x = box.lattice.x(n);
        if (x < 6 || x >= 34 || index(n + box.lattice.offset(q)) < 0) continue;
        length += link_area_share(of_cracked(s, 0), of_cracked(s, 1), D2Q9::c(q, 0), D2Q9::c(q, 1));
      }
    EXPECT_NEAR(length / (28 * std::hypot(1.0, 0.5 * slope)), 1, slope == 1 ? 5e-3 : 1e-14)
        << slope;  // uncracked likewise
    // half dissolved it is what rock of one cell is, half dissolved
    VectorField<double> half, half_cracked;
    for (const double of_node : {1.0, 1.5}) {
      for (const auto& field : {box.V, box.dissolved})
        edit(field, [&](const auto& host) {
          for (int s = 0; s < box.surface.count; ++s) host(node(s)) = of_node / 2;
        });
      find_normals(box.exec, box.nodes, box.surface, box.V, box.dissolved, of_node == 1 ? half : half_cracked);
    }
    const auto of_half = host_copy(half), of_half_cracked = host_copy(half_cracked);
    for (int s = 0; s < box.surface.count; ++s)
      for (int axis = 0; axis < 2; ++axis) ASSERT_NEAR(of_half_cracked(s, axis), of_half(s, axis), 1e-14);
  }
}

TEST(SurfaceNormal, IsUndefinedForAWallOfOnePixelHoweverItsVolumeVaries) {
  Box box = box_of({"..#..", "..#..", "..#..", "..#..", "..#.."});
  edit(box.V, [&](const auto& V) {
    for (int y = 0; y < 5; ++y) V(box.lattice.node(2, y)) = 0.5 + 0.1 * y;
  });
  VectorField<double> normal;
  find_normals(box.exec, box.nodes, box.surface, box.V, box.dissolved, normal);
  EXPECT_NEAR(surface_area<D2Q5>(box.exec, box.nodes, box.surface, normal), 10 * 3.14159265358979 / 4, 1e-14);
}

TEST(SurfaceNormal, IsUndefinedForALonePixelWhichCountsAsADisc) {
  Box box = box_of({".....", ".....", "..#..", ".....", "....."});
  VectorField<double> normal;
  find_normals(box.exec, box.nodes, box.surface, box.V, box.dissolved, normal);
  EXPECT_EQ(host_copy(normal)(0, 0), 0);
  EXPECT_NEAR(surface_area<D2Q5>(box.exec, box.nodes, box.surface, normal), 3.14159265358979, 1e-14);
}

}  // namespace
}  // namespace vug
