// What is given over time at sides and shapes: each kind of value follows its table and its ramp, in SI.
#include "support/case_shapes.hpp"
#include "support/coupled_run.hpp"
#include "verification/surface_scenes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <utility>

namespace vug {
namespace {

using namespace test::surfaces;

/// A channel, `condition` at its left side and an outflow at its right one.
test::CoupledRun channel(const std::string& condition) {
  return test::CoupledRun(lattice(12, 10) + flow + told + "[boundary.left]\nflow = { type = \"velocity\", " +
                          condition + " }\n[boundary.right]\nflow = { type = \"outflow\" }\n");
}

void run_to(test::CoupledRun& run, int step) {
  run.steps(step - static_cast<int>(run.now("step_1")));
}

/// The channel carries the Poiseuille flow of the pressure of the moment, once that is older than its height squared
/// over the viscosity, 0.33 s.
TEST(FlowTables, OfAPressureDriveThePoiseuilleFlowOfThatMoment) {
  constexpr int nx = 12, ny = 10;
  test::CoupledRun run(lattice(nx, ny) + flow + told +
                       "[boundary.left]\nflow = { type = \"pressure\", pressure = [[0.010, 300000], [0.030, 300002], "
                       "[\"1 s\", 300002], [1.020, 299999]] }\n"
                       "[boundary.right]\nflow = { type = \"pressure\", pressure = 300000 }\n");
  const double height = ny * dx, pressure_scale = 5;
  const double per_pascal = std::pow(height, 3) / (12 * 1.2e-3 * nx * dx) / pressure_scale;  // kg/(m s)
  const auto expect = [&](int step, double pascal) {
    run_to(run, step);
    EXPECT_NEAR(run.now("left_mass_flow_kg_per_m_s") / per_pascal, pascal, 0.02 * std::abs(pascal)) << step;
    EXPECT_NEAR(run.now("right_mass_flow_kg_per_m_s") / per_pascal, -pascal, 0.02 * std::abs(pascal)) << step;
  };
  run_to(run, 10);
  EXPECT_EQ(run.now("left_mass_flow_kg_per_m_s"), 0);
  expect(1000, 2);
  expect(2000, -1);
}

TEST(FlowTables, OfRatesLetInTheRateOfThatMoment) {
  for (const std::string given :
       {"flow_rate = [[0, 0], [0.020, 6e-4], [0.025, 3e-4]]", "mass_flow_rate = [[0, 0], [0.020, 0.48], [0.025, 0.24]]",
        "flow_rate = [[0, 0], [0.020, 6e-4], [0.025, 3e-4]], profile = \"parabolic\""}) {
    test::CoupledRun run = channel(given);
    for (const auto& [step, rate] : {std::pair{5, 1.5e-4}, std::pair{15, 4.5e-4}, std::pair{30, 3e-4}}) {
      run_to(run, step);
      EXPECT_NEAR(run.now("left_mass_flow_kg_per_m_s"), density * rate, 1e-12) << given << ' ' << step;
    }
  }
}

TEST(FlowTables, RampsRaiseRatesFromZero) {
  for (const std::string given : {"flow_rate = 3e-4, ramp_time = 0.020", "mass_flow_rate = 0.24, ramp_time = 0.020",
                                  "flow_rate = [[0.010, 3e-4], [0.040, 3e-4]], ramp_time = 0.020"}) {
    test::CoupledRun run = channel(given);
    for (const auto& [step, share] : {std::pair{5, 0.25}, std::pair{15, 0.75}, std::pair{30, 1.0}}) {
      run_to(run, step);
      EXPECT_NEAR(run.now("left_mass_flow_kg_per_m_s"), share * 0.24, 1e-12) << given << ' ' << step;
    }
  }
}

/// Fluid that leaves a shape across its surface: speed times circumference.
TEST(FlowTables, OfTheSpeedAtAShapeAndItsRamp) {
  constexpr double radius = 2.7 * dx;
  const double full = density * 5e-3 * 2 * std::acos(-1.0) * radius;
  for (const std::string given : {"speed = [[0, 0], [0.020, 5e-3]]", "speed = 5e-3, ramp_time = 0.020"}) {
    test::CoupledRun well(lattice(20, 12) + flow + told + test::disc(9 * dx, 6 * dx, radius, "name = \"post\"") +
                          "[boundary.shape.post]\nflow = { type = \"velocity\", " + given +
                          " }\n[boundary.right]\nflow = { type = \"outflow\" }\n");
    for (const auto& [step, share] : {std::pair{5, 0.25}, std::pair{15, 0.75}, std::pair{30, 1.0}}) {
      run_to(well, step);
      EXPECT_NEAR(well.now("shape_post_mass_flow_kg_per_m_s"), share * full, 1e-9 * full) << given << ' ' << step;
    }
  }
}

/// A slab whose other sides are adiabatic takes on the last temperature of the table.
TEST(FlowTables, OfATemperatureAtASide) {
  test::CoupledRun run(
      lattice(12, 10) + heat + told +
      "[boundary.bottom]\nheat = { type = \"temperature\", temperature = [[0.0, 350], [0.1, 400]] }\n");
  run.steps(30000);
  for (const double value : run.nodes("temperature")) EXPECT_NEAR(value, 400, 1e-6);
}

}  // namespace
}  // namespace vug
