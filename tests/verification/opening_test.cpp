// Openings inside the lattice against what they must equal: the sides of the lattice, and channels between them.
#include "support/case_shapes.hpp"
#include "support/coupled_run.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace vug {
namespace {

using test::CoupledRun;
using test::disc;
using test::rectangle;
using test::unit_lattice;

/// A channel of 20 cells with grains, between two ends with the given conditions: the ends are the sides of the
/// lattice, or shapes of `ends` columns beyond them.
std::string channel_between(const std::string& left, const std::string& right, int ends, const std::string& set) {
  const int nx = 20 + 2 * ends, ny = 31;  // higher than long: an outflow's memory is as long as the larger
  std::string text = unit_lattice(nx, ny) + "[geometry]\ntype = \"shapes\"\n";
  text += rectangle(0, 0, nx, 1) + rectangle(0, ny - 1, nx, ny);
  text += disc(ends + 7.3, 4.2, 1.8) + disc(ends + 14.1, 7.7, 1.4);
  if (ends > 0)
    text += rectangle(0, 0, ends, ny, "name = \"left\"") + rectangle(nx - ends, 0, nx, ny, "name = \"right\"");
  text += fmt::format(
      "[flow]\nviscosity = 0.09\ndensity = 1\ninitial_pressure = 0\n"
      "[heat]\nfluid_diffusivity = 0.05\nsolid_diffusivity = 0.13\ninitial_temperature = 350\nvelocity_set = \"{}\"\n"
      "[solute]\nvelocity_set = \"{}\"\n[[solute.species]]\nname = \"A\"\ndiffusivity = 0.04\n",
      // on D2Q9 a heated side and an outflow of rock mirror what moves diagonally, an opening sends it back
      // (fill_heat_openings)
      left.find("flux") == std::string::npos ? set : "d2q5", set);
  const std::string shape = ends > 0 ? "shape." : "";
  text += fmt::format("[boundary.{}left]\n{}\n[boundary.{}right]\n{}\n", shape, left, shape, right);
  // corners of the lattice belong to one of two sides: without any, sides and shapes are the same in every link
  return text + "[boundary.bottom]\nflow = { type = \"periodic\" }\n[boundary.top]\nflow = { type = \"periodic\" }\n";
}

struct Ends {
  const char *name, *left, *right, *left_shape;
};

void PrintTo(const Ends& ends, std::ostream* out) {
  *out << ends.name;
}

class ShapeAsSide : public testing::TestWithParam<Ends> {};

TEST_P(ShapeAsSide, GivesTheSameFieldsAsTheSideOfALattice) {
  for (const std::string set : {"d2q5", "d2q9"}) {
    constexpr int ends = 3, rows = 31, columns = 20;
    CoupledRun side(channel_between(GetParam().left, GetParam().right, 0, set));
    CoupledRun shape(channel_between(GetParam().left_shape, GetParam().right, ends, set));
    side.steps(400);
    shape.steps(400);
    for (const char* name : {"pressure", "velocity", "temperature", "concentration_A"}) {
      const std::vector<double> a = side.nodes(name), b = shape.nodes(name);
      const int components = static_cast<int>(a.size()) / (rows * columns);
      double difference = 0, size = 0;
      for (int y = 0; y < rows; ++y)
        for (int x = 0; x < columns * components; ++x) {
          const double expected = a[y * columns * components + x];
          size = std::max(size, std::abs(expected));
          difference = std::max(difference, std::abs(expected - b[(y * (columns + 2 * ends) + ends) * components + x]));
        }
      EXPECT_GT(size, 1e-4) << name;
      EXPECT_LE(difference, 1e-14 * size) << name << " " << set;  // sums of weights in another order, if at all
    }
    for (const auto& [quantity, gains] : {std::pair{"fluid_mass", std::vector{"boundaries"}},
                                          {"heat", {"injection", "sides"}},
                                          {"A", {"injected", "outflow"}}}) {
      double through_sides = 0;
      for (const char* gain : gains) through_sides += side.gain(quantity, gain);
      const double through_shapes = shape.gain(quantity, "shape_left") + shape.gain(quantity, "shape_right");
      EXPECT_NEAR(through_shapes, through_sides, 1e-12 * std::abs(shape.gain(quantity, "shape_left"))) << quantity;
    }
    EXPECT_LE(shape.worst_balance(), 1e-12);
  }
}

constexpr const char* flux_in =
    "flow = { type = \"velocity\", velocity = [0.01, 0] }\n"
    "heat = { type = \"flux\", flux = 2e4 }\n"
    "solute = { type = \"concentration\", concentration = { A = 3 } }";
constexpr const char* flux_in_shape =
    "flow = { type = \"velocity\", speed = 0.01 }\n"
    "heat = { type = \"flux\", flux = 2e4 }\n"
    "solute = { type = \"concentration\", concentration = { A = 3 } }";
constexpr const char* pressure_in =
    "flow = { type = \"pressure\", pressure = 2e-3, ramp_time = 100 }\n"
    "heat = { type = \"temperature\", temperature = 300 }\n"
    "solute = { type = \"concentration\", concentration = { A = 3 } }";
constexpr const char* all_out =
    "flow = { type = \"outflow\" }\nheat = { type = \"outflow\" }\nsolute = { type = \"outflow\" }";
constexpr const char* pressure_out =
    "flow = { type = \"pressure\", pressure = 0 }\nheat = { type = \"temperature\", temperature = 320 }\n"
    "solute = { type = \"outflow\" }";

INSTANTIATE_TEST_SUITE_P(Conditions, ShapeAsSide,
                         testing::Values(Ends{"pressures", pressure_in, pressure_out, pressure_in},
                                         Ends{"velocity and outflow", flux_in, all_out, flux_in_shape}));

/// Two shapes with pressures, in a closed box: between them the parabola of the gradient from the one to the other.
TEST(ChannelBetweenShapes, CarriesTheParabolaOfItsWholeLength) {
  constexpr int h = 9, length = 8 * h, ends = 3, nx = length + 2 * ends + 4, ny = h + 6;
  constexpr double nu = (0.764 - 0.5) / 3;
  CoupledRun run(unit_lattice(nx, ny) + "[geometry]\ntype = \"shapes\"\nbackground = \"solid\"\n" +
                 rectangle(2 + ends, 3, nx - 2 - ends, ny - 3, "material = \"fluid\"") +
                 rectangle(2, 2, 2 + ends, ny - 2, "name = \"inlet\"") +
                 rectangle(nx - 2 - ends, 2, nx - 2, ny - 2, "name = \"outlet\"") +
                 fmt::format("[flow]\nviscosity = {:.17g}\ndensity = 1\ninitial_pressure = 0\n", nu) +
                 "[boundary.shape.inlet]\nflow = { type = \"pressure\", pressure = 1e-4 }\n"
                 "[boundary.shape.outlet]\nflow = { type = \"pressure\", pressure = 0 }\n");
  run.steps(30000);
  const double in = run.gain("fluid_mass", "shape_inlet"), out = run.gain("fluid_mass", "shape_outlet");
  run.steps(1000);
  EXPECT_NEAR((out - run.gain("fluid_mass", "shape_outlet")) / (run.gain("fluid_mass", "shape_inlet") - in), 1, 1e-12);
  const std::vector<double> p = run.nodes("pressure"), u = run.nodes("velocity");
  constexpr double gradient = 1e-4 / length, top = gradient / (8 * nu) * h * h;
  for (int x = 0; x < length; ++x)
    for (int y = 0; y < h; ++y) {
      const int node = (y + 3) * nx + 2 + ends + x;
      EXPECT_NEAR(p[node], 1e-4 - gradient * (x + 0.5), 1e-8);  // inertia: u^2
      EXPECT_NEAR(u[2 * node], gradient / (2 * nu) * (y + 0.5) * (h - y - 0.5), 1e-5 * top);
      EXPECT_NEAR(u[2 * node + 1], 0, 1e-5 * top);
    }
  EXPECT_LE(run.worst_balance(), 1e-12);
}

/// A well in rock that its acid dissolves: births beside an opening, and all balances, until no rock is left.
TEST(WellInRock, DissolvesItAndLosesNothing) {
  for (const std::string set : {"d2q5", "d2q9"})
    for (const std::string fill : {"mean", "split"}) {
      const Scene scene =
          read_scene(VUG_SOURCE_DIR "/tests/cases/coupled/well.toml",
                     {"solute.velocity_set=" + set, "heat.velocity_set=" + set, "reaction.birth_fill=" + fill});
      CoupledRun run(scene);
      const Geometry& geometry = run.parts().geometry;
      const int well = static_cast<int>(geometry.openings.at(0).nodes.node.extent(0));
      EXPECT_GT(geometry.surface.count, 20);
      for (int look = 0; look < 80 && geometry.surface.count > 0; ++look) {
        run.steps(100);
        ASSERT_LE(run.worst_balance(), 1e-12) << look;
      }
      EXPECT_EQ(geometry.surface.count, 0);
      EXPECT_EQ(geometry.fluid.count, scene.lattice.nx * scene.lattice.ny - well);
      EXPECT_GT(run.gain("A", "shape_well"), 0);
    }
}

/// Cold acid from a well into rock at the hot end of Arrhenius' law, by which the rate grows 8e6 times: temperatures
/// and concentrations stay between those given, in either precision.
TEST(WellInRock, HoldsBetween250And600Kelvin) {
  for (const std::string precision : {"double", "single"}) {
    const Scene scene = read_scene(VUG_SOURCE_DIR "/tests/cases/coupled/well.toml",
                                   {"accuracy.precision=" + precision, "heat.initial_temperature=600",
                                    "boundary.shape.well.heat.temperature=250", "reaction.activation_energy=62.8e3"});
    CoupledRun run(scene);
    const double rounding = precision == "double" ? 1e-12 : 1e-5;
    for (int look = 0; look < 20; ++look) {
      run.steps(50);
      const std::vector<double> T = run.nodes("temperature"), C = run.nodes("concentration_A");
      const auto [coldest, hottest] = std::minmax_element(T.begin(), T.end());
      EXPECT_GE(*coldest, 250 - 600 * rounding);
      EXPECT_LE(*hottest, 600 + 600 * rounding);
      EXPECT_GE(*std::min_element(C.begin(), C.end()), -1000 * rounding);
      EXPECT_LE(*std::max_element(C.begin(), C.end()), 1000 * (1 + rounding));
      if (precision == "double") {
        EXPECT_LE(run.worst_balance(), 1e-12);
      }
    }
    EXPECT_LT(run.parts().geometry.surface.count, 20) << "rock that dissolves";
  }
}

/// A belt above a channel: its surface moves, nothing passes.
TEST(MovingShape, DragsACouetteFlow) {
  constexpr int h = 7, nx = 6, ny = h + 4;
  CoupledRun run(unit_lattice(nx, ny) + "[geometry]\ntype = \"shapes\"\n" +
                 rectangle(0, h, nx, h + 2, "name = \"belt\"") +
                 "[flow]\nviscosity = 0.088\ndensity = 1\ninitial_pressure = 0\n"
                 "[boundary.shape.belt]\nflow = { type = \"wall\", velocity = [0.05, 0] }\n"
                 "[boundary.left]\nflow = { type = \"periodic\" }\n[boundary.right]\nflow = { type = \"periodic\" }\n");
  run.steps(12000);
  const std::vector<double> u = run.nodes("velocity");
  for (int y = 0; y < h; ++y) {
    EXPECT_NEAR(u[2 * (y * nx + 2)], 0.05 * (y + 0.5) / h, 1e-13) << y;
    EXPECT_NEAR(u[2 * (y * nx + 2) + 1], 0, 1e-14) << y;
  }
  EXPECT_NEAR(run.gain("fluid_mass", "shape_belt"), 0, 1e-12);
}

}  // namespace
}  // namespace vug
