// What the temperature does to the flow. Viscosity that depends on it: a plane Couette flow across a linear temperature
// profile has the same shear stress everywhere, so that u(y) = U I(y) / I(h), I the integral of 1 / nu(T(y)).
#include "support/case_shapes.hpp"
#include "support/coupled_run.hpp"
#include "support/record.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace vug {
namespace {

constexpr double wall = 0.02, cold = 300, hot = 380;

/// Between a cold wall at rest and a hot one that slides.
std::string couette(int cells, const std::string& law) {
  return test::unit_lattice(3, cells) + "[flow]\ninitial_pressure = 0\ndensity = 1\n" + law +
         "\n[heat]\nfluid_diffusivity = 0.3\nsolid_diffusivity = 0.3\ninitial_temperature = 340\n"
         "[boundary.left.flow]\ntype = \"periodic\"\n[boundary.right.flow]\ntype = \"periodic\"\n"
         "[boundary.bottom]\nheat = { type = \"temperature\", temperature = 300 }\n"
         "[boundary.top]\nflow = { type = \"wall\", velocity = [0.02, 0] }\n"
         "heat = { type = \"temperature\", temperature = 380 }\n";
}

/// Largest error of the profile over the wall's speed, against the integral by Simpson's rule.
double error_of(int cells, const std::string& law, const std::function<double(double)>& nu,
                const std::vector<std::string>& more = {}) {
  test::CoupledRun run(couette(cells, law), more);
  run.steps(cells * cells * 40);
  const auto fluidity = [&](double y) { return 1 / nu(cold + (hot - cold) * y / cells); };
  const auto integral = [&](double to) {
    constexpr int n = 400;
    double sum = 0;
    for (int i = 0; i < n; ++i) {
      const double a = to * i / n, b = to * (i + 1) / n;
      sum += (b - a) / 6 * (fluidity(a) + 4 * fluidity((a + b) / 2) + fluidity(b));
    }
    return sum;
  };
  const std::vector<double> velocity = run.nodes("velocity");
  double worst = 0;
  for (int y = 0; y < cells; ++y)
    worst = std::max(worst, std::abs(velocity[2 * (3 * y + 1)] / wall - integral(y + 0.5) / integral(cells)));
  return worst;
}

TEST(ThermalViscosity, ArrheniusCouetteProfileIsOfSecondOrder) {
  const std::string law = "viscosity = 0.2\nviscosity_activation_energy = 16000\nreference_temperature = 300";
  const auto nu = [](double T) { return 0.2 * std::exp(16000 / 8.314462618 * (1 / T - 1 / 300.0)); };
  const double coarse = error_of(8, law, nu), fine = error_of(16, law, nu);
  EXPECT_LT(fine, 1e-3);
  test::record("thermal_viscosity", {{"law", "Arrhenius"}, {"cells", 8}, {"error", coarse}});
  test::record("thermal_viscosity", {{"law", "Arrhenius"}, {"cells", 16}, {"error", fine}});
  EXPECT_NEAR(std::log2(coarse / fine), 2, 0.25) << coarse << " " << fine;
  EXPECT_LT(error_of(16, law, nu, {"flow.collision=bgk"}), 5e-3);
  EXPECT_LT(error_of(16, law, nu, {"accuracy.precision=single"}), 1e-3);
}

TEST(ThermalViscosity, TableIsLinearBetweenItsPoints) {
  const std::string law = "viscosity_table = [[300, 0.2], [340, 0.1], [\"106.85 degC\", 0.05]]";
  const auto nu = [](double T) { return T < 340 ? 0.2 - 0.1 * (T - 300) / 40 : 0.1 - 0.05 * (T - 340) / 40; };
  const double coarse = error_of(8, law, nu), fine = error_of(16, law, nu);
  EXPECT_NEAR(std::log2(coarse / fine), 2, 0.25) << coarse << " " << fine;
  test::record("thermal_viscosity", {{"law", "table"}, {"cells", 8}, {"error", coarse}});
  test::record("thermal_viscosity", {{"law", "table"}, {"cells", 16}, {"error", fine}});
}

/// Water heated from above lies still, and rounding must not shake it (25 cells, some hundred times the time in which
/// momentum of alternating sign would grow by e).
TEST(StableLayer, LiesStill) {
  for (const int interval : {1, 2, 3}) {
    test::CoupledRun run(
        "[lattice]\nsize = [0.0032, 0.020]\nspacing = 8e-4\ntime_step = 32e-3\n[time]\nend = 500\n"
        "[flow]\nviscosity = 1e-6\ngravity = [0, -9.81]\nthermal_expansion = 2e-4\nreference_temperature = 293.15\n"
        "[heat]\nfluid_diffusivity = 1.4e-7\nsolid_diffusivity = 1.4e-7\nfluid_heat_capacity = 4180\n"
        "initial_temperature = 293.15\n"
        "[boundary.left]\nflow = { type = \"periodic\" }\n[boundary.right]\nflow = { type = \"periodic\" }\n"
        "[boundary.bottom]\nheat = { type = \"temperature\", temperature = 288.15 }\n"
        "[boundary.top]\nheat = { type = \"temperature\", temperature = 298.15 }\n[output]\nflows = true\n",
        {fmt::format("accuracy.heat_interval={}", interval)});
    run.steps(15000);
    double fastest = 0;
    for (const double u : run.nodes("velocity")) fastest = std::max(fastest, std::abs(u));
    EXPECT_EQ(run.now("fluid_mass_balance_error_1"), 0) << interval;
    EXPECT_LT(fastest, 1e-7) << interval;  // m/s, as it warms; free convection reaches (g beta dT L)^1/2, 0.02
    const double conducted = 0.0032 * 1.4e-7 * 1000 * 4180 * 10 / 0.020;
    EXPECT_NEAR(run.now("top_heat_flow_W_per_m") / conducted, 1, 5e-3) << interval;
  }
}

/// The same viscosity everywhere gives the flow of one viscosity.
TEST(ThermalViscosity, OfNoDependenceIsThePlainFlow) {
  EXPECT_LT(error_of(8, "viscosity_table = [[300, 0.1], [310, 0.1]]", [](double) { return 0.1; }), 1e-9);
}

/// Free convection between a warm and a cold upright plate: the temperature is linear across, and nu v'' = -g beta (T -
/// T_0) makes v = g beta dT L^2 / (6 nu) (s^3 - s / 4), s from -1/2 at the warm plate to 1/2, upwards where it is warm.
double error_of_plates(int cells, const std::string& gravity, int axis, double reference) {
  const bool upright = axis == 1;
  const char* const warm = upright ? "left" : "bottom";
  const char* const cool = upright ? "right" : "top";
  test::CoupledRun run(
      test::unit_lattice(upright ? cells : 3, upright ? 3 : cells) +
      fmt::format("[flow]\ndensity = 7\ninitial_pressure = 0\nviscosity = 0.1\nthermal_expansion = 1e-6\n"
                  "gravity = {}\nreference_temperature = {}\n"
                  "[heat]\nfluid_diffusivity = 0.3\nsolid_diffusivity = 0.3\ninitial_temperature = 350\n"
                  "[boundary.{}]\nheat = {{ type = \"temperature\", temperature = 350 }}\n"
                  "[boundary.{}]\nheat = {{ type = \"temperature\", temperature = 330 }}\n"
                  "[boundary.{}.flow]\ntype = \"periodic\"\n[boundary.{}.flow]\ntype = \"periodic\"\n",
                  gravity, reference, warm, cool, upright ? "bottom" : "left", upright ? "top" : "right"));
  run.steps(cells * cells * 60);
  const double scale = 0.5 * 1e-6 * 20 * cells * cells / (6 * 0.1), top = scale * 0.0481;
  const std::vector<double> velocity = run.nodes("velocity");
  double worst = 0;
  for (int k = 0; k < cells; ++k) {
    const double s = (k + 0.5) / cells - 0.5;
    const int node = upright ? cells + k : 3 * k + 1;
    worst = std::max(worst, std::abs(velocity[2 * node + axis] - scale * (s * s * s - s / 4)) / top);
  }
  return worst;
}

TEST(FreeConvection, BetweenPlatesHasTheCubicProfileExactly) {
  EXPECT_LT(error_of_plates(16, "[0, -0.5]", 1, 340), 1e-10);
  EXPECT_LT(error_of_plates(9, "[-0.5, 0]", 0, 340), 1e-10);
  EXPECT_GT(error_of_plates(9, "[0, -0.5]", 1, 341), 0.1) << "another reference temperature lifts all of the fluid";
}

}  // namespace
}  // namespace vug
