// What flows through sides, injections and named shapes, fluid and heat, in SI.
#include "support/case_shapes.hpp"
#include "support/coupled_run.hpp"
#include "support/record.hpp"
#include "verification/surface_scenes.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

namespace vug {
namespace {

using namespace test::surfaces;

/// Couette's flow between two open sides: the links out of the corners have the wall's rule, and what they carry, U/6
/// of a cell each, crosses the open side.
TEST(SurfaceFlows, BesideASlidingWallAreAllOfTheFlow) {
  constexpr int nx = 12, ny = 4;
  const double speed = 0.02 * dx / dt;
  for (const bool upright : {false, true})
    for (const char* kind : {"pressure", "outflow"}) {
      const std::string open = std::string("type = \"") + kind + "\"\n" + (kind[0] == 'p' ? "pressure = 3e5\n" : "");
      const std::string from = upright ? "bottom" : "left", to = upright ? "top" : "right";
      const std::string along = upright ? fmt::format("[0, {}]", speed) : fmt::format("[{}, 0]", speed);
      test::CoupledRun run(lattice(upright ? ny : nx, upright ? nx : ny) + flow + told + "[boundary." + from +
                           ".flow]\ntype = \"pressure\"\npressure = 3e5\n[boundary." + to + ".flow]\n" + open +
                           "[boundary." + (upright ? "right" : "top") + ".flow]\ntype = \"wall\"\nvelocity = " + along +
                           "\n");
      run.steps(4000);
      const double exact = density * speed * ny * dx / 2;
      EXPECT_NEAR(run.now(from + "_mass_flow_kg_per_m_s"), exact, 1e-3 * exact) << from << kind;
      EXPECT_NEAR(run.now(to + "_mass_flow_kg_per_m_s"), -exact, 1e-3 * exact) << to << kind;
    }
}

/// Each has the rate that is given to it, drawn or pressed, and the rest leaves.
TEST(SurfaceFlows, OfSeveralInjectionsAreEachItsOwn) {
  const std::string stretch =
      "[[boundary.injection]]\nname = \"{}\"\nside = \"{}\"\ncentre = {}\nwidth = {}\n"
      "[boundary.injection.flow]\ntype = \"velocity\"\nflow_rate = {}\n";
  const auto injection = [&](const char* name, const char* side, double centre, double width, double rate) {
    return fmt::format(fmt::runtime(stretch), name, side, centre * dx, width * dx, rate);
  };
  test::CoupledRun run(lattice(24, 20) + flow + told + injection("upper", "left", 14, 4, 3e-5) +
                       injection("lower", "left", 5, 2, -1e-5) + injection("floor", "bottom", 9.5, 3, 2e-5) +
                       "[boundary.right.flow]\ntype = \"pressure\"\npressure = 3e5\n");
  run.steps(6000);
  const auto rate = [&](const std::string& name) { return run.now(name + "_mass_flow_kg_per_m_s") / density; };
  EXPECT_NEAR(rate("injection_upper"), 3e-5, 1e-15);
  EXPECT_NEAR(rate("injection_lower"), -1e-5, 1e-15);
  EXPECT_NEAR(rate("injection_floor"), 2e-5, 1e-15);
  EXPECT_NEAR(rate("right"), -4e-5, 1e-9);
}

/// Newton's law of cooling: the resistances of slab and film add up.
TEST(HeatFlow, ThroughASlabWithAFilm) {
  constexpr int nx = 10, ny = 5;
  for (const std::string set : {"d2q5", "d2q9"})
    for (const bool rock : {false, true}) {
      const double conductivity = rock ? 2600 * 850 * 5e-4 : 900 * 3500 * 3e-4, coefficient = 3e4;
      const std::string all = rock ? "[geometry]\ntype = \"shapes\"\n" + test::rectangle(0, 0, nx * dx, ny * dx) : "";
      test::CoupledRun run(lattice(nx, ny) + all + heat + told +
                               "[boundary.left.heat]\ntype = \"temperature\"\ntemperature = 360\n"
                               "[boundary.right.heat]\ntype = \"convection\"\ntemperature = 340\ncoefficient = 3e4\n",
                           {"heat.velocity_set=" + set});
      run.steps(20000);
      const double flux = 20 / (nx * dx / conductivity + 1 / coefficient), through = flux * ny * dx;
      EXPECT_NEAR(run.now("left_heat_flow_W_per_m"), through, 1e-9 * through) << set << rock;
      EXPECT_NEAR(run.now("right_heat_flow_W_per_m"), -through, 1e-9 * through) << set << rock;
      test::record("heat_film", {{"what", "steady"}, {"error", run.now("right_heat_flow_W_per_m") / -through - 1}});
      const std::vector<double> temperature = run.nodes("temperature");
      for (int x = 0; x < nx; ++x)
        EXPECT_NEAR(temperature[x], 360 - flux * (x + 0.5) * dx / conductivity, 1e-8) << set << rock;
    }
}

/// Of a slab of so many cells that is warm throughout and cools by a film: the rate at which its first mode, a cosine,
/// decays, over its exact one, zeta^2 with zeta tan zeta = Bi (Carslaw and Jaeger 1959, section 3.11), less 1.
double error_of_decay(int cells) {
  constexpr double length = 0.08, diffusivity = 3e-4, conductivity = 900 * 3500 * diffusivity, biot = 1.5;
  double zeta = 1;
  for (int i = 0; i < 200; ++i) zeta = std::atan(biot / zeta);
  const double spacing = length / cells, step = 0.075 * spacing * spacing / diffusivity;
  test::CoupledRun run(
      heat + told + "[boundary.right.heat]\ntype = \"convection\"\ntemperature = 340\ncoefficient = 1\n",
      {fmt::format("boundary.right.heat.coefficient={:.17g}", biot * conductivity / length),
       fmt::format("lattice.size=[0.08, {:.17g}]", 3 * spacing), fmt::format("lattice.spacing={:.17g}", spacing),
       fmt::format("lattice.time_step={:.17g}", step), "time.steps=1000000"});
  const double unit = length * length / diffusivity;  // s
  const int steps = static_cast<int>(0.5 * unit / step);
  run.steps(2 * steps);  // of the second mode exp(-13) is left
  const double before = run.now("right_heat_flow_W_per_m");
  run.steps(steps);
  return std::log(before / run.now("right_heat_flow_W_per_m")) / (steps * step) * unit / (zeta * zeta) - 1;
}

TEST(HeatFlow, OfACoolingSlabDecaysAtTheRateOfItsBiotNumber) {
  const double coarse = error_of_decay(20), fine = error_of_decay(40);
  EXPECT_LT(std::abs(fine), 1e-4);
  EXPECT_NEAR(std::log2(coarse / fine), 2, 0.25) << coarse << " " << fine;
  test::record("heat_film", {{"what", "decay"}, {"error", fine}});
}

TEST(HeatFlow, OfAGivenFluxIsThatFlux) {
  test::CoupledRun run(lattice(10, 8) + heat + told + test::disc(5 * dx, 4 * dx, 2.2 * dx, "name = \"post\"") +
                       "[boundary.shape.post.heat]\ntype = \"flux\"\nflux = 2e4\n"
                       "[boundary.left.heat]\ntype = \"flux\"\nflux = -1e4\n");
  run.steps(10);
  EXPECT_NEAR(run.now("left_heat_flow_W_per_m"), -1e4 * 8 * dx, 1e-6);
  const double gained = run.gain("heat", "shape_post");
  run.steps(1);
  EXPECT_NEAR(run.now("shape_post_heat_flow_W_per_m"), (run.gain("heat", "shape_post") - gained) / dt, 1e-4);
}

}  // namespace
}  // namespace vug
