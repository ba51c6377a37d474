// Heat as a case gives it, and what triangles and their bonds feel of it, in SI.
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

constexpr double dx = 2e-3, dt = 0.05;

/// 16 x 10 cells, the left six of them rock.
const std::string half_rock = R"(
[lattice]
size = [0.032, 0.020]
spacing = 2e-3
time_step = 0.05
[time]
steps = 100000
[geometry]
type = "shapes"
[[geometry.shapes]]
type = "rectangle"
from = [0, 0]
to = [0.012, 0.020]
[heat]
fluid_diffusivity = 1.5e-5
solid_diffusivity = 4e-5
fluid_density = 900
fluid_heat_capacity = 3500
solid_density = 2600
solid_heat_capacity = 850
initial_temperature = 350
)";

/// 20 W/cm2 into the rock for 20 s, 3 W/cm2 out of the fluid through a part of its side.
TEST(HeatInSI, FluxIsInWattsAndHeatInJoules) {
  const std::string sides = R"(
[boundary.left]
heat = { type = "flux", flux = 2e5 }
[boundary.injection]
side = "right"
centre = 0.010
width = 0.012
heat = { type = "flux", flux = -3e4 }
)";
  for (const std::string set : {"d2q5", "d2q9"})
    for (const std::string interval : {"1", "2"}) {
      test::CoupledRun run(half_rock + sides, {"heat.velocity_set=" + set, "accuracy.heat_interval=" + interval});
      const int steps = 400;
      run.steps(steps);
      const double in = 2e5 * 0.020 * steps * dt, out = 3e4 * 0.012 * steps * dt;  // J/m
      EXPECT_NEAR(run.gain("heat", "sides") / in, 1, 1e-12) << set << interval;
      EXPECT_NEAR(run.gain("heat", "injection") / -out, 1, 1e-12) << set << interval;
      const std::vector<double> temperature = run.nodes("temperature");
      double stored = 0;
      for (int y = 0; y < 10; ++y)
        for (int x = 0; x < 16; ++x)
          stored += (x < 6 ? 2600 * 850.0 : 900 * 3500.0) * (temperature[y * 16 + x] - 350) * dx * dx;
      EXPECT_NEAR(stored / (in - out), 1, 1e-11) << set << interval;
      EXPECT_NEAR((run.now("heat_stored_J_per_m") - run.now("heat_initial_J_per_m")) / (in - out), 1, 1e-11);
    }
}

/// What two injections with names let in is theirs, not the side's.
TEST(HeatInSI, InjectionsWithNamesAreNotSides) {
  const std::string sides = R"(
[boundary.left]
heat = { type = "flux", flux = 2e5 }
[[boundary.injection]]
name = "hot"
side = "right"
centre = 0.006
width = 0.004
heat = { type = "flux", flux = 5e4 }
[[boundary.injection]]
name = "cold"
side = "top"
centre = 0.020
width = 0.012
heat = { type = "flux", flux = -3e4 }
)";
  test::CoupledRun run(half_rock + sides);
  const int steps = 100;
  run.steps(steps);
  EXPECT_NEAR(run.gain("heat", "sides") / (2e5 * 0.020 * steps * dt), 1, 1e-12);
  EXPECT_NEAR(run.gain("heat", "injection") / ((5e4 * 0.004 - 3e4 * 0.012) * steps * dt), 1, 1e-12);
}

/// In a steady state the flux that a held temperature lets in is that through rock and fluid in series.
TEST(HeatInSI, HeldTemperaturesDriveTheFluxOfTheConductivities) {
  const std::string ends =
      "[boundary.left]\nheat = { type = \"temperature\", temperature = 390 }\n"
      "[boundary.right]\nheat = { type = \"temperature\", temperature = 330 }\n";
  test::CoupledRun run(half_rock + ends);
  run.steps(20000);
  const double rock = 2600 * 850 * 4e-5, fluid = 900 * 3500 * 1.5e-5;  // W/(m K)
  const double flux = 60 / (6 * dx / rock + 10 * dx / fluid);
  const std::vector<double> temperature = run.nodes("temperature");
  for (int x = 0; x < 16; ++x) {
    const double at = (x + 0.5) * dx;
    const double exact = 390 - flux * (std::min(at, 6 * dx) / rock + std::max(0.0, at - 6 * dx) / fluid);
    EXPECT_NEAR(temperature[3 * 16 + x], exact, 1e-8) << x;
  }
  EXPECT_NEAR(run.now("largest_temperature_change_K"), 390 - flux * 0.5 * dx / rock - 350, 1e-8);
}

/// Through a side with a heat transfer coefficient h flows h times the difference of temperatures, however often heat
/// is stepped: the resistances 1/h, of the rock and of the fluid are in series.
TEST(HeatInSI, TransferCoefficientIsAResistanceInSeries) {
  const std::string ends =
      "[boundary.left]\nheat = { type = \"convection\", temperature = 390, coefficient = 3000 }\n"
      "[boundary.right]\nheat = { type = \"temperature\", temperature = 330 }\n";
  for (const std::string interval : {"1", "2"}) {
    test::CoupledRun run(half_rock + ends, {"accuracy.heat_interval=" + interval});
    run.steps(20000);
    const double rock = 2600 * 850 * 4e-5, fluid = 900 * 3500 * 1.5e-5;  // W/(m K)
    const double flux = 60 / (1 / 3000.0 + 6 * dx / rock + 10 * dx / fluid);
    const std::vector<double> temperature = run.nodes("temperature");
    EXPECT_NEAR(temperature[3 * 16], 390 - flux * (1 / 3000.0 + 0.5 * dx / rock), 1e-6) << interval;
    EXPECT_NEAR(temperature[3 * 16 + 15], 330 + flux * 0.5 * dx / fluid, 1e-6) << interval;
  }
}

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
