// Forces of the fluid on sides and named shapes, in SI: balances that hold exactly.
#include "coupling/run_files.hpp"
#include "support/case_shapes.hpp"
#include "support/coupled_run.hpp"
#include "verification/surface_scenes.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace vug {
namespace {

using namespace test::surfaces;

std::string shape(double x, double y, double radius) {
  return test::disc(x * dx, y * dx, radius * dx, "name = \"post\"") + "[boundary.shape.post]\n";
}

double sum_of(const test::CoupledRun& run, const std::string& what) {
  double sum = 0;
  for (const char* name : {"left", "right", "bottom", "top", "shape_post"}) {
    const std::string column = std::string(name) + what;
    sum += run.now(column);
  }
  return sum;
}

/// The weight of the fluid rests on what is around it; Archimedes' law holds for what stands in it.
TEST(SurfaceForces, CarryTheWeightOfTheFluidAtRest) {
  constexpr int nx = 20, ny = 16;
  test::CoupledRun run(lattice(nx, ny) + flow + told + shape(9, 7, 3.2), {"flow.body_force=[0.4, -3.0]"});
  run.steps(4000);
  const double fluid = run.now("fluid_nodes_1"), post = nx * ny - fluid, node = density * dx * dx;
  EXPECT_NEAR(sum_of(run, "_force_x_N_per_m"), 0.4 * node * fluid, 1e-9 * node * fluid);
  EXPECT_NEAR(sum_of(run, "_force_y_N_per_m"), -3.0 * node * fluid, 1e-9 * node * fluid);
  EXPECT_NEAR(run.now("shape_post_force_x_N_per_m"), -0.4 * node * post, 1e-9 * node * fluid);
  EXPECT_NEAR(run.now("shape_post_force_y_N_per_m"), 3.0 * node * post, 1e-9 * node * fluid);
  EXPECT_NEAR(run.now("shape_post_torque_N"), 0, 1e-9 * node * fluid * dx);
  // the pressure on the left side grows downwards: its moment about the middle is rho g h^3 / 12, in whole cells
  const double n = ny, moment = density * -3.0 * dx * dx * dx * n * (n * n - 1) / 12;
  EXPECT_NEAR(run.now("left_torque_N"), moment, 1e-9 * std::abs(moment));
}

/// Fluid at rest pushes on every side with the pressure beside it, and along none: also at the links out of corners,
/// which are of one of two sides.
TEST(SurfaceForces, OfASideAreThePressureBesideIt) {
  constexpr int nx = 14, ny = 9;
  for (const std::string open : {"", "[boundary.left.flow]\ntype = \"pressure\"\npressure = 3e5\n"}) {
    const double down = open.empty() ? -3 : 0;  // no fluid is at rest beside a side of one pressure under its weight
    test::CoupledRun run(lattice(nx, ny) + flow + told + open, {fmt::format("flow.body_force=[0.4, {}]", down)});
    run.steps(6000);
    const std::vector<double> p = run.nodes("gauge_pressure");
    const double whole = density * 3.0 * nx * ny * dx * dx;
    const struct {
      const char* name;
      int first, stride, count, axis, outward;
    } sides[] = {{"left", 0, nx, ny, 0, -1},
                 {"right", nx - 1, nx, ny, 0, 1},
                 {"bottom", 0, 1, nx, 1, -1},
                 {"top", nx * (ny - 1), 1, nx, 1, 1}};
    for (const auto& side : sides) {
      const std::string name = side.name;
      const bool free = !open.empty() && name == "left";  // its pressure is given at the side, half a cell away
      double force = 0, torque = 0;
      for (int k = 0; k < side.count; ++k) {
        const double weight = (side.axis == 0 ? 0.4 : down) * density * side.outward * dx / 2;  // of half a cell
        const double of_node = side.outward * (p[side.first + k * side.stride] + weight) * dx;
        force += of_node;
        torque += (side.axis == 0 ? -1 : 1) * (k + 0.5 - side.count / 2.0) * dx * of_node;
      }
      const char normal = side.axis == 0 ? 'x' : 'y', along = side.axis == 0 ? 'y' : 'x';
      EXPECT_NEAR(run.now(name + "_force_" + along + "_N_per_m"), 0, 1e-6 * whole) << name << open;
      if (free) continue;
      EXPECT_NEAR(run.now(name + "_force_" + normal + "_N_per_m"), force, 1e-6 * whole) << name << open;
      EXPECT_NEAR(run.now(name + "_torque_N"), torque, 1e-6 * whole * dx * nx) << name << open;
    }
  }
}

/// Archimedes' law for a piece of a disc that a joined side cuts off: its flat face has its links across that side, and
/// what is displaced weighs on the lever of the nodes that there are.
TEST(SurfaceForces, TurnAnOpeningBesideAJoinedSideByTheWeightItDisplaces) {
  constexpr int nx = 20, ny = 18;
  for (const bool upright : {false, true}) {
    const std::string low = upright ? "bottom" : "left", high = upright ? "top" : "right";
    const double x = upright ? 9 : 18, y = upright ? 16 : 7;
    test::CoupledRun run(lattice(nx, ny) + flow + told + shape(x, y, 3.2) + "[boundary." + low +
                             ".flow]\ntype = \"periodic\"\n[boundary." + high + ".flow]\ntype = \"periodic\"\n",
                         {upright ? "flow.body_force=[-3.0, 0.0]" : "flow.body_force=[0.0, -3.0]"});
    run.steps(4000);
    const double node = density * dx * dx;
    double torque = 0;
    const std::vector<double> type = run.nodes("node_type");
    for (int n = 0; n < nx * ny; ++n)
      if (type[n] == 2) torque += 3.0 * node * dx * (upright ? -(n / nx + 0.5 - y) : n % nx + 0.5 - x);
    EXPECT_GT(std::abs(torque), 3.0 * node * dx);  // there is one
    EXPECT_NEAR(run.now("shape_post_torque_N"), torque, 1e-8 * node * nx * ny * dx) << upright;
  }
}

/// A run writes rows by place: a corner that opens must not change the order of columns, nor may joined sides have any.
TEST(SurfaceForces, HaveTheirColumnsWhateverTheCornersAre) {
  const auto columns = [](const std::string& more) {
    const Scene scene = parse_scene(lattice(9, 7) + flow + told + more, "case.toml");
    return history_columns(scene, Simulation(scene));
  };
  const auto corner = [](double x, double y) {
    return "[geometry]\ntype = \"shapes\"\n" + test::rectangle(x * dx, y * dx, (x + 1) * dx, (y + 1) * dx, "");
  };
  const std::string given =
      "[boundary.left.flow]\ntype = \"velocity\"\nvelocity = [0.01, 0]\n"
      "[boundary.bottom.flow]\ntype = \"velocity\"\nvelocity = [0, 0.01]\n"
      "[boundary.right.flow]\ntype = \"pressure\"\npressure = 3e5\n";
  for (const std::string& sides : {std::string(), given}) {
    const auto inside = columns(corner(4, 3) + sides);
    for (const auto& [x, y] : {std::pair{0, 0}, {8, 0}, {0, 6}, {8, 6}})
      EXPECT_EQ(columns(corner(x, y) + sides), inside) << sides;
  }
  for (const std::string& column :
       columns("[boundary.left.flow]\ntype = \"periodic\"\n[boundary.right.flow]\ntype = \"periodic\"\n"))
    EXPECT_FALSE(column.starts_with("left_") || column.starts_with("right_")) << column;
}

TEST(SurfaceForces, OnTheWallsOfAChannelAreTheShearThatDrivesIt) {
  constexpr int nx = 6, ny = 9;
  test::CoupledRun run(lattice(nx, ny) + flow + told +
                           "[boundary.left.flow]\ntype = \"periodic\"\n[boundary.right.flow]\ntype = \"periodic\"\n",
                       {"flow.body_force=[3.0, 0.0]"});
  run.steps(3000);
  const double each = density * 3.0 * nx * ny * dx * dx / 2;
  EXPECT_NEAR(run.now("bottom_force_x_N_per_m"), each, 1e-9 * each);
  EXPECT_NEAR(run.now("top_force_x_N_per_m"), each, 1e-9 * each);
}

/// On the fluid: pressure on both ends, shear on both walls. Walls of any length have all of it, links out of corners
/// included.
TEST(SurfaceForces, OfAPressureDropArePressureTimesArea) {
  for (const auto& [nx, ny] : {std::pair{24, 8}, {8, 16}}) {
    test::CoupledRun run(lattice(nx, ny) + flow + told +
                         "[boundary.left.flow]\ntype = \"pressure\"\npressure = 3.0000001e5\n"
                         "[boundary.right.flow]\ntype = \"pressure\"\npressure = 3e5\n");
    run.steps(6000);
    const double push = 0.01 * ny * dx;  // so little that momentum counts for nothing
    EXPECT_NEAR(run.now("bottom_force_x_N_per_m"), push / 2, 1e-4 * push);
    EXPECT_NEAR(run.now("top_force_x_N_per_m"), push / 2, 1e-4 * push);
    EXPECT_NEAR(run.now("left_force_x_N_per_m"), -push, 1e-4 * push);
    EXPECT_NEAR(run.now("right_force_x_N_per_m"), 0, 1e-4 * push);
    EXPECT_NEAR(run.now("left_force_x_N_per_m") + run.now("right_force_x_N_per_m") + run.now("bottom_force_x_N_per_m") +
                    run.now("top_force_x_N_per_m"),
                0, 1e-6 * push)
        << "steady";
    EXPECT_NEAR(run.now("left_mass_flow_kg_per_m_s"), -run.now("right_mass_flow_kg_per_m_s"),
                1e-9 * run.now("left_mass_flow_kg_per_m_s"));
  }
}

/// Couette's flow: rho nu U/h on every length of wall, and the same along both ends, where pressures or velocities are
/// given.
TEST(SurfaceForces, OfCouettesFlowAreItsShear) {
  const double speed = 2e-4 * dx / dt, h = 4 * dx;
  for (const int nx : {4, 12})
    for (const bool given : {false, true})
      for (const bool upright : {false, true}) {
        const auto vector = [&](double along) {
          return upright ? fmt::format("[0, {:.17g}]", along) : fmt::format("[{:.17g}, 0]", along);
        };
        std::string text = lattice(upright ? 4 : nx, upright ? nx : 4) + flow + told;
        for (const std::string end : {upright ? "bottom" : "left", upright ? "top" : "right"})
          text += "[boundary." + end + ".flow]\n" +
                  (given && (end == "left" || end == "bottom")
                       ? fmt::format("type = \"velocity\"\nvelocity = {}\nprofile = \"table\"\n"
                                     "profile_table = [[0, 0], [{:.17g}, 1]]\n",
                                     vector(speed), h)
                       : "type = \"pressure\"\npressure = 3e5\n");
        text += std::string("[boundary.") + (upright ? "right" : "top") +
                ".flow]\ntype = \"wall\"\nvelocity = " + vector(speed) + "\n";
        test::CoupledRun run(text);
        run.steps(4000);
        const double shear = 5 * density * 1.2e-3 * speed / h;  // times pressure_scale
        const char* along = upright ? "_force_y_N_per_m" : "_force_x_N_per_m";
        const char* across = upright ? "_force_x_N_per_m" : "_force_y_N_per_m";
        const double close = given ? 1e-4 : 1e-6;
        const auto force = [&](const std::string& side, const char* axis) { return run.now(side + axis); };
        EXPECT_NEAR(force(upright ? "left" : "bottom", along), shear * nx * dx, close * shear * nx * dx) << nx;
        EXPECT_NEAR(force(upright ? "right" : "top", along), -shear * nx * dx, close * shear * nx * dx) << nx;
        EXPECT_NEAR(force(upright ? "bottom" : "left", across), shear * h, 1e-3 * shear * h) << nx;
        EXPECT_NEAR(force(upright ? "top" : "right", across), -shear * h, 1e-3 * shear * h) << nx;
      }
}

/// A row of the history leaves the run as it was.
TEST(Surfaces, ALookDisturbsNothing) {
  const std::string text = lattice(24, 12) + flow + heat + shape(10, 6.3, 2.4) +
                           "[[solute.species]]\nname = \"A\"\ndiffusivity = 4e-4\n"
                           "[boundary.left]\nflow = { type = \"velocity\", velocity = [0.05, 0] }\n"
                           "heat = { type = \"temperature\", temperature = 300 }\n"
                           "solute = { type = \"concentration\", concentration = { A = 30 } }\n"
                           "[boundary.right]\nflow = { type = \"outflow\" }\nheat = { type = \"outflow\" }\n"
                           "solute = { type = \"outflow\" }\n"
                           "[boundary.top]\nheat = { type = \"convection\", temperature = 330, coefficient = 1e4 }\n"
                           "flow = { type = \"pressure\", pressure = 3e5 }\n";
  for (const std::string set : {"d2q5", "d2q9"}) {
    const std::vector<std::string> sets{"heat.velocity_set=" + set, "solute.velocity_set=" + set};
    test::CoupledRun silent(text, sets), telling(text + told, sets);
    silent.steps(31);
    for (int step = 0; step < 31; ++step) {
      telling.now("shape_post_force_x_N_per_m");
      telling.steps(1);
    }
    for (const char* field : {"pressure", "velocity", "temperature", "concentration_A"})
      EXPECT_EQ(silent.nodes(field), telling.nodes(field)) << field;
    EXPECT_THROW(silent.now("left_force_x_N_per_m"), std::invalid_argument);
  }
}

}  // namespace
}  // namespace vug
