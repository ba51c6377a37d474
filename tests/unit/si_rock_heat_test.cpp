// What triangles and their bonds feel of the heat of the lattice, in SI.
#include "dem_support.hpp"
#include "support/coupled_run.hpp"
#include "support/meshed_rock.hpp"
#include "support/nodes_of_groups.hpp"
#include "support/rock_output.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace vug {
namespace {

using test::Point;

constexpr double dx = 2e-3;

const std::string rock_in_a_gradient = R"(
[lattice]
size = [0.048, 0.040]
spacing = 2e-3
time_step = 0.05
[time]
steps = 100000
[geometry]
type = "rock"
[heat]
fluid_diffusivity = 3e-5
solid_diffusivity = 3e-5
fluid_density = 2000
fluid_heat_capacity = 1000
solid_density = 2000
solid_heat_capacity = 1000
initial_temperature = 330
[mechanics]
substeps = 1
force_unstable = true  # a lone triangle
[boundary.bottom]
heat = { type = "temperature", temperature = 300 }
[boundary.top]
heat = { type = "temperature", temperature = 400 }
)";

/// The triangle's temperature is the mean over its nodes, from the initial one.
TEST(HeatInSI, TriangleHasTheMeanTemperatureOfItsNodes) {
  const Point a{8.3 * dx, 4.2 * dx}, b{17.6 * dx, 8.1 * dx}, c{10.2 * dx, 15.7 * dx};
  test::TemporaryFolder folder;
  test::write_text(folder / "rock.msh", test::mesh_text({a, b, c}, {{0, 1, 2}}));
  test::CoupledRun run(rock_in_a_gradient, {"rock.mesh=\"" + (folder / "rock.msh") + "\""});
  run.steps(6000);
  const std::vector<Point> nodes = test::nodes_inside(a, b, c, 24, 20, dx);
  double mean = 0;
  for (const Point& p : nodes) mean += (300 + 100 * p[1] / (20 * dx)) / static_cast<double>(nodes.size());
  EXPECT_NEAR(test::of_triangles(run.rock(), "temperature_change")[0], mean - 330, 1e-8);
}

/// One so small that it lies between the centres of four nodes has the temperature of the node at its centroid.
TEST(HeatInSI, TriangleWithoutANodeHasTheTemperatureAtItsCentroid) {
  const Point a{8.7 * dx, 4.6 * dx}, b{9.4 * dx, 4.6 * dx}, c{9.2 * dx, 5.2 * dx};
  ASSERT_TRUE(test::nodes_inside(a, b, c, 24, 20, dx).empty());
  test::TemporaryFolder folder;
  test::write_text(folder / "rock.msh", test::mesh_text({a, b, c}, {{0, 1, 2}}));
  test::CoupledRun run(rock_in_a_gradient, {"rock.mesh=\"" + (folder / "rock.msh") + "\""});
  run.steps(6000);
  EXPECT_NEAR(test::of_triangles(run.rock(), "temperature_change")[0], 300 + 100 * 4.5 / 20 - 330, 1e-8);
}

/// Triangles under an opening have its temperature of now where it has one given, else that of the rock around it.
TEST(HeatInSI, TrianglesInAnOpeningFollowIt) {
  std::string well = R"(
[lattice]
size = [0.020, 0.016]
spacing = 1e-3
time_step = 1e-6
[time]
steps = 100000
[geometry]
type = "rock"
[[geometry.shapes]]
type = "disc"
name = "well"
centre = [0.010, 0.008]
radius = 0.005
[rock]
element_size = 3e-3
[heat]
fluid_diffusivity = 0.5
solid_diffusivity = 0.5
initial_temperature = 320
[mechanics]
local_damping = 0.7
[mechanics.bond]
normal_strength = 1e12
cohesion = 1e12
[boundary.shape.well]
)";
  for (const std::string side : {"left", "right", "bottom", "top"})
    well += "[boundary." + side + "]\nheat = { type = \"temperature\", temperature = 290 }\n";
  const auto inside = [](const test::CoupledRun& run) {
    std::vector<int> found;
    const auto nodes = test::nodes_of_groups(run.parts().rock->nodes_of_particle);
    for (std::size_t p = 0; p < nodes.size(); ++p)
      if (nodes[p].empty()) found.push_back(static_cast<int>(p));
    EXPECT_GT(found.size(), 3u);
    return found;
  };
  test::CoupledRun warmed(well, {"boundary.shape.well.heat.type=temperature", "accuracy.update_interval=1",
                                 "boundary.shape.well.heat.temperature=[[0, 320], [2e-5, 340]]"});
  for (int step = 1; step <= 30; ++step) {
    warmed.steps(1);
    const std::vector<double> change = test::of_triangles(warmed.rock(), "temperature_change");
    for (const int p : inside(warmed)) ASSERT_NEAR(change[p], std::min(20.0, step - 1.0), 1e-12) << step;
  }
  test::CoupledRun cooled(well);
  cooled.steps(3000);
  EXPECT_FALSE(inside(cooled).empty());
  for (const double change : test::of_triangles(cooled.rock(), "temperature_change")) EXPECT_NEAR(change, -30, 1e-6);
}

/// Two triangles that cannot move and are warmed: their bond is pressed by what they would have grown,
/// alpha dT (x_a - x_b) across a bond of length chi h, h the distance of the two centroids across the edge.
TEST(HeatInSI, WarmedTrianglesPressTheirBond) {
  const std::string held = R"(
[lattice]
size = [0.020, 0.016]
spacing = 1e-3
time_step = 1e-6
[time]
steps = 100000
[geometry]
type = "rock"
[heat]
fluid_diffusivity = 0.5
solid_diffusivity = 0.5
initial_temperature = 320
[mechanics]
thermal_expansion = 1.2e-5
[mechanics.bond]
normal_modulus = 2e10
tangential_modulus = 0.8e10
length_factor = 0.7
normal_strength = 1e12
cohesion = 1e12
)";
  test::TemporaryFolder folder;
  const Point p{0, 0}, q{0.020, 0.016}, low{0.020, 0}, high{0, 0.016};
  test::write_text(folder / "rock.msh", test::mesh_text({p, low, q, high}, {{0, 1, 2}, {0, 2, 3}}));
  for (const double change : {50.0, -50.0}) {
    std::string sides;
    for (const std::string side : {"left", "right", "bottom", "top"})
      sides += "[boundary." + side +
               "]\nheat = { type = \"temperature\", temperature = " + std::to_string(320 + change) +
               " }\ntraction = { support = \"fixed\" }\n";
    test::CoupledRun run(held + sides, {"rock.mesh=\"" + (folder / "rock.msh") + "\""});
    run.steps(3000);
    const Point from = test::centroid(p, low, q), to = test::centroid(p, q, high);
    const double length = std::hypot(q[0], q[1]);
    const Point t{q[0] / length, q[1] / length}, n{-t[1], t[0]};  // n from the first to the second, t across it
    const Point d{to[0] - from[0], to[1] - from[1]};
    const double h = d[0] * n[0] + d[1] * n[1], across = d[0] * -n[1] + d[1] * n[0];
    const std::vector<double> stress = test::of_bonds(run.rock(), "stress");
    EXPECT_NEAR(test::of_triangles(run.rock(), "temperature_change")[0], change, 1e-9);
    EXPECT_NEAR(stress[0] / (-2e10 * 1.2e-5 * change / 0.7), 1, 1e-9);
    EXPECT_NEAR(stress[1] / (-0.8e10 * 1.2e-5 * change * across / (0.7 * h)), 1, 1e-9);
  }
}

}  // namespace
}  // namespace vug
