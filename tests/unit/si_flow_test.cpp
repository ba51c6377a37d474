// The flow as a case gives it: SI in, SI out, with a pressure scale, a spacing and a time step that are not one.
#include "support/coupled_run.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

namespace vug {
namespace {

constexpr int nx = 12, ny = 9;
constexpr double dx = 2e-3, dt = 1e-3, density = 800, viscosity = 1.2e-3, scale = 5;

const std::string box = R"(
[lattice]
size = [0.024, 0.018]
spacing = 2e-3
time_step = 1e-3
[time]
steps = 100000
[geometry]
type = "open"
[flow]
density = 800
viscosity = 1.2e-3
initial_pressure = 3e5
pressure_scale = 5
)";
const std::string periodic_in_x =
    "[boundary.left]\nflow = { type = \"periodic\" }\n"
    "[boundary.right]\nflow = { type = \"periodic\" }\n";
const std::string periodic_in_y =
    "[boundary.bottom]\nflow = { type = \"periodic\" }\n"
    "[boundary.top]\nflow = { type = \"periodic\" }\n";

/// Largest difference of the velocity from exact(x, y) in m, over `speed`.
template <class Exact>
double velocity_error(const test::CoupledRun& run, double speed, const Exact& exact) {
  const std::vector<double> velocity = run.nodes("velocity");
  double worst = 0;
  for (int y = 0; y < ny; ++y)
    for (int x = 0; x < nx; ++x) {
      const std::array<double, 2> u = exact((x + 0.5) * dx, (y + 0.5) * dx);
      for (int axis = 0; axis < 2; ++axis)
        worst = std::max(worst, std::abs(velocity[2 * (y * nx + x) + axis] - u[axis]) / speed);
    }
  return worst;
}

TEST(FlowInSI, WallsThatMoveDragALinearProfile) {
  test::CoupledRun along_x(box + periodic_in_x + "[boundary.top]\nflow = { type = \"wall\", velocity = [0.05, 0] }\n");
  along_x.steps(2000);
  EXPECT_LE(velocity_error(along_x, 0.05,
                           [](double, double y) {
                             return std::array{0.05 * y / (ny * dx), 0.0};
                           }),
            1e-10);
  test::CoupledRun along_y(box + periodic_in_y +
                           "[boundary.left]\nflow = { type = \"wall\", velocity = [0, -0.05] }\n");
  along_y.steps(2000);
  EXPECT_LE(velocity_error(along_y, 0.05,
                           [](double x, double) {
                             return std::array{0.0, -0.05 * (1 - x / (nx * dx))};
                           }),
            1e-10);
}

/// The lattice flows under what the case gives over the scale.
TEST(FlowInSI, BodyForceDrivesThePoiseuilleProfileOfTheScaledForce) {
  test::CoupledRun along_x(box + periodic_in_x, {"flow.body_force=[3.0, 0.0]"});
  along_x.steps(2000);
  const double h = ny * dx, top = 3.0 / scale * h * h / (8 * viscosity);
  EXPECT_LE(velocity_error(along_x, top,
                           [&](double, double y) {
                             return std::array{3.0 / scale * y * (h - y) / (2 * viscosity), 0.0};
                           }),
            1e-10);
  test::CoupledRun along_y(box + periodic_in_y, {"flow.body_force=[0.0, -3.0]"});
  along_y.steps(3000);
  const double w = nx * dx;
  EXPECT_LE(velocity_error(along_y, 3.0 / scale * w * w / (8 * viscosity),
                           [&](double x, double) {
                             return std::array{0.0, -3.0 / scale * x * (w - x) / (2 * viscosity)};
                           }),
            1e-10);
}

/// The mean of the field over the lattice, rock included: the superficial velocity, m/s.
TEST(FlowInSI, MeanVelocityIsThatOfAllNodes) {
  for (const char* precision : {"double", "single"}) {
    test::CoupledRun run(box + periodic_in_x + periodic_in_y,
                         {"flow.body_force=[3.0, -1.0]", "geometry.type=shapes",
                          R"(geometry.shapes=[{type="disc", centre=[0.010, 0.008], radius=0.005}])",
                          std::string("accuracy.precision=") + precision});
    run.steps(500);
    const std::vector<double> velocity = run.nodes("velocity");
    double x = 0, y = 0;
    for (int n = 0; n < nx * ny; ++n) {
      x += velocity[2 * n] / (nx * ny);
      y += velocity[2 * n + 1] / (nx * ny);
    }
    EXPECT_GT(x, 1e-3);
    EXPECT_NEAR(run.now("mean_velocity_x_m/s"), x, 1e-12 * x);
    EXPECT_NEAR(run.now("mean_velocity_y_m/s"), y, 1e-12 * x);
  }
}

/// At rest the pressure carries the body force, whatever the scale.
TEST(FlowInSI, PressureOfFluidAtRestIsThatOfItsWeight) {
  test::CoupledRun run(box, {"flow.body_force=[2.0, -9.81]"});
  run.steps(6000);
  const std::vector<double> pressure = run.nodes("pressure");
  for (int y = 0; y < ny; ++y)
    for (int x = 0; x < nx; ++x) {
      const double exact = 3e5 + density * (2.0 * (x + 0.5 - nx / 2.0) - 9.81 * (y + 0.5 - ny / 2.0)) * dx;
      EXPECT_NEAR(pressure[y * nx + x], exact, 1e-5) << x << ' ' << y;
    }
}

/// 0.03 m/s in and a thousandth less out through 18 mm for half a second; what stays stands under the pressure that
/// holds it.
TEST(FlowInSI, InletAddsItsMassAndThePressureOfTheLattice) {
  const int steps = 500;
  const double entered = density * 3e-5 * ny * dx * steps * dt;  // kg/m
  for (const double sign : {1.0, -1.0}) {
    const auto side = [&](const char* name, double speed) {
      return std::string("[boundary.") + name + "]\nflow = { type = \"velocity\", velocity = [" +
             std::to_string(speed * sign) + ", 0] }\n";
    };
    test::CoupledRun run(box + side("left", 0.03) + side("right", 0.02997));
    run.steps(steps);
    EXPECT_NEAR(run.gain("fluid_mass", "boundaries"), sign * entered, 1e-8 * entered);
    EXPECT_NEAR(run.now("fluid_mass_stored_kg_per_m"), sign * entered, 1e-8 * entered);
    double mean = 0;
    for (const double one : run.nodes("pressure")) mean += one / (nx * ny);
    const double sound2 = dx * dx / (3 * dt * dt);  // of the lattice
    EXPECT_NEAR(mean - 3e5, sign * scale * sound2 * entered / (nx * dx * ny * dx), 1e-6);
  }
}

/// A pressure is raised from the initial one; at both ends it is that of the case.
TEST(FlowInSI, PressureRisesWithItsRamp) {
  const std::string ends =
      "[boundary.left]\nflow = { type = \"pressure\", pressure = 300700, ramp_time = 4 }\n"
      "[boundary.right]\nflow = { type = \"pressure\", pressure = 300700, ramp_time = 4 }\n";
  for (const auto& [steps, rise] : {std::pair{2000, 350.0}, std::pair{9000, 700.0}}) {
    test::CoupledRun run(box + ends);
    run.steps(steps);
    for (const double one : run.nodes("pressure"))
      EXPECT_NEAR(one - 3e5, rise, steps < 4000 ? 5.0 : 1e-6);  // sound takes some steps to the middle
  }
}

/// Fluid that is pushed in through all of the left side as a plug leaves at the right with the same speed.
TEST(FlowInSI, PlugKeepsItsSpeed) {
  const std::string plug = R"(
[boundary.left]
flow = { type = "velocity", velocity = [0.03, 0] }
[boundary.right]
flow = { type = "velocity", velocity = [0.03, 0] }
[boundary.bottom]
flow = { type = "wall", velocity = [0.03, 0] }
[boundary.top]
flow = { type = "wall", velocity = [0.03, 0] }
)";
  test::CoupledRun run(box + plug);
  run.steps(6000);
  EXPECT_LE(velocity_error(run, 0.03, [](double, double) { return std::array{0.03, 0.0}; }), 1e-8);
  EXPECT_NEAR(run.gain("fluid_mass", "boundaries"), 0, 1e-9 * density * nx * ny * dx * dx);
}

/// What is to enter through a stretch enters through all of it, wherever it lies: beside a wall in a corner the link
/// out of that is the stretch's.
TEST(FlowInSI, InjectionsInCornersLetInAllOfTheirFluid) {
  const auto cells = [](double count) { return std::to_string(count * dx); };
  for (const Side side : all_sides) {
    const int outward = static_cast<int>(side), length = D2Q9::c(outward, 0) != 0 ? ny : nx;
    const Side opposite = static_cast<Side>(D2Q9::opposite(outward));
    const std::string flow = "flow = { type = \"velocity\", velocity = [" +
                             std::to_string(-0.01 * D2Q9::c(outward, 0)) + ", " +
                             std::to_string(-0.01 * D2Q9::c(outward, 1)) + "] }\n";
    const std::string out = std::string("[boundary.") + name_of(opposite) + "]\nflow = { type = \"outflow\" }\n";
    const std::string told = "[output]\nflows = true\n";
    const auto through = [&](double centre, double width) {
      test::CoupledRun run(box + out + told + "[boundary.injection]\nside = \"" + name_of(side) +
                           "\"\ncentre = " + cells(centre) + "\nwidth = " + cells(width) + "\n" + flow);
      run.steps(100);
      EXPECT_NEAR(run.now("injection_mass_flow_kg_per_m_s"), density * 0.01 * width * dx, 1e-12)
          << width << " cells at " << centre << " of the " << name_of(side);
      return run.nodes("velocity");
    };
    through(2, 4);
    through(length - 2, 4);
    through(length / 2, 4);
    test::CoupledRun whole(box + out + told + "[boundary." + name_of(side) + "]\n" + flow);
    whole.steps(100);
    EXPECT_EQ(through(length / 2.0, length), whole.nodes("velocity")) << name_of(side);
  }
}

}  // namespace
}  // namespace vug
