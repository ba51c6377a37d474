// Rock that sleeps and rock that is made heavier by accuracy.tolerance and presets, against rock that does neither.
#include "coupling/rock_loads.hpp"
#include "support/rows.hpp"
#include "support/tolerance_cases.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>
#include <vector>

namespace vug {
namespace {

using test::column;
using test::finest;
using test::with_tolerance;

/// A bar that is pressed more and more, and then no more. At rest its end has moved in proportion to what presses on
/// it.
const std::string bar =
    "[lattice]\nsize = [0.1, 0.02]\nspacing = 2.5e-3\ntime_step = 1e-5\n[time]\nsteps = 1000\n"
    "[geometry]\ntype = \"rock\"\n[rock]\nelement_size = 8e-3\n"
    "[mechanics]\nyoung_modulus = 30e9\npoisson_ratio = 0.2\nlocal_damping = 0.7\nrest_tolerance = 0\n"
    "bond = { weibull_shape = 0 }\n"
    "[boundary.left]\ntraction = { support = \"roller\" }\n"
    "[boundary.right]\ntraction = { normal_stress = [[0, 0], [5e-3, 1e6]] }\n"
    "[[output.gauges]]\nname = \"end\"\ntype = \"displacement\"\nat = [0.1, 0.01]\n";

/// By which share of its last place its end is off at the worst; of a bar half as wide as long, which does not bend.
double off_rest(const std::string& accuracy) {
  const History found = test::rows_of(
      parse_scene(bar + accuracy, "case.toml", {"lattice.size=[0.1, 0.05]", "output.gauges.0.at=[0.1, 0.025]"}), 1000,
      10);
  const std::vector<double>&time = column(found, "time_s"), &moved = column(found, "end_x_m");
  double off = 0;
  for (std::size_t row = 0; row < time.size(); ++row)
    off = std::max(off, std::abs(moved[row] / moved.back() - std::min(1.0, time[row] / 5e-3)));
  return off;
}

/// The load is a small share of the strength and the bar many triangles long: what each of them may lack while it
/// sleeps is a share of what it bears, and what all of a group lack together is looked at too.
TEST(Tolerance, LetsRockSleepUnderASmallLoad) {
  const auto end = [](const std::string& share) {
    return column(
        test::rows_of(parse_scene(bar + finest, "case.toml", {"mechanics.rest_tolerance=" + share}), 1000, 10),
        "end_x_m");
  };
  const std::vector<double> awake = end("0");
  for (const std::string share : {"2e-3", "5e-3", "2e-2"}) {
    const std::vector<double> moved = end(share);
    double off = 0;
    for (std::size_t row = 0; row < moved.size(); ++row)
      off = std::max(off, std::abs(moved[row] - awake[row]) / std::abs(awake.back()));
    std::printf("    rest_tolerance %s: off by %.1e of the load\n", share.c_str(), off);
    EXPECT_LT(off, std::stod(share));
    EXPECT_GT(off, 0) << "sleeps";
  }
}

/// A block that nothing breaks, and one far stronger than its load, bear all of what presses on them.
TEST(Tolerance, LetsNoRockSleepThroughItsLoad) {
  const std::string block =
      "[lattice]\nsize = [0.04, 0.04]\nspacing = 1e-3\ntime_step = 1e-6\n[time]\nsteps = 1500\n"
      "[geometry]\ntype = \"rock\"\n[rock]\nelement_size = 4e-3\n"
      "[mechanics]\nyoung_modulus = 30e9\npoisson_ratio = 0.2\nlocal_damping = 0.5\n"
      "[boundary.bottom]\ntraction = { support = \"roller\" }\n[boundary.left]\ntraction = { support = \"roller\" }\n"
      "[[output.gauges]]\nname = \"base\"\ntype = \"reaction\"\nside = \"bottom\"\n";
  const std::string unbreakable =
      "mechanics.bond={ weibull_shape = 0, normal_strength = 1e10, cohesion = 1e10, fracture_energy_I = 1e6, "
      "fracture_energy_II = 1e6 }";
  for (const auto& [load, bond] : {std::pair{1e6, unbreakable}, {3e4, std::string("mechanics.bond.weibull_shape=0")}})
    for (const std::string accuracy : {"preset=\"fast\"", "preset=\"balanced\"", "tolerance=1e-3"}) {
      const History found = test::rows_of(
          parse_scene(block, "case.toml",
                      {bond, "accuracy." + accuracy,
                       "boundary.top.traction.normal_stress=[[0, 0], [1e-3, " + std::to_string(load) + "]]"}),
          1500, 1500);
      const double borne = column(found, "base_y_N_per_m").back() / (load * 0.04);
      std::printf("    %s, %g Pa: bears %.4f of its load\n", accuracy.c_str(), load, borne);
      EXPECT_NEAR(borne, 1, 6e-3) << accuracy << load;
    }
}

/// A beam that is built in and pressed along it from the start bears a small load across it: statics asks for all of it
/// at the wall, and as much bending as without sleep.
TEST(Tolerance, LetsNoRockSleepThroughASmallLoadOnTop) {
  const std::string beam =
      "[lattice]\nsize = [0.06, 0.01]\nspacing = 1e-3\ntime_step = 2e-6\n[time]\nsteps = 2000\n"
      "[geometry]\ntype = \"rock\"\n[rock]\nelement_size = 2.5e-3\n"
      "[mechanics]\nyoung_modulus = 30e9\npoisson_ratio = 0.2\nlocal_damping = 0.5\nbond = { weibull_shape = 0 }\n"
      "[boundary.left]\ntraction = { support = \"fixed\" }\n"
      "[boundary.right]\ntraction = { normal_stress = 5e6, shear_stress = [[0, 0], [2e-3, -2e4]] }\n"
      "[[output.gauges]]\nname = \"tip\"\ntype = \"displacement\"\nat = [0.0595, 0.005]\n"
      "[[output.gauges]]\nname = \"wall\"\ntype = \"reaction\"\nside = \"left\"\n";
  const auto end = [&](const std::vector<std::string>& settings) {
    const History found = test::rows_of(parse_scene(beam, "case.toml", settings), 2000, 2000);
    return std::pair{column(found, "tip_y_m").back(), column(found, "wall_y_N_per_m").back()};
  };
  for (const std::string accuracy : {"preset=\"fast\"", "preset=\"balanced\"", "tolerance=1e-3"}) {
    const auto awake = end({"accuracy." + accuracy, "mechanics.rest_tolerance=0"}),
               found = end({"accuracy." + accuracy});
    std::printf("    %s: bends by %.4f of what it does awake, bears %.4f of its load (awake %.4f)\n", accuracy.c_str(),
                found.first / awake.first, found.second / (2e4 * 0.01), awake.second / (2e4 * 0.01));
    EXPECT_NEAR(found.first / awake.first, 1, 1e-2) << accuracy;
    EXPECT_NEAR(found.second / awake.second, 1, 2e-2) << accuracy;
    // four times the mass of `fast` overshoots, awake as well
    EXPECT_NEAR(found.second / (2e4 * 0.01), 1, accuracy.starts_with("preset=\"f") ? 0.08 : 0.02) << accuracy;
  }
}

/// Whatever changes beside it: otherwise rock sleeps through it.
TEST(Tolerance, KnowsTheLeastOfTheTractionsThatChange) {
  const std::string pressed =
      "[lattice]\nsize = [0.06, 0.01]\nspacing = 1e-3\ntime_step = 2e-6\n[time]\nsteps = 10\n"
      "[geometry]\ntype = \"rock\"\n[rock]\nelement_size = 2.5e-3\n[mechanics]\n"
      "[boundary.left]\ntraction = { support = \"fixed\" }\n[boundary.right]\n"
      "traction = { normal_stress = [[0, 0], [2e-3, 5e6]], shear_stress = ";
  EXPECT_EQ(largest_load(parse_scene(pressed + "[[0, 0], [2e-3, -2e4]] }\n", "a.toml")).change, 2e4);
  EXPECT_EQ(largest_load(parse_scene(pressed + "2e4 }\n", "a.toml")).change, 5e6);
}

/// A block that a crack parts from a roof falls by g t^2 / 2, although its weight is nothing beside the stress above.
TEST(Tolerance, LetsLooseRockFall) {
  const std::string pressed = "traction = { parts = [{ from = 0.012, to = 0.024, normal_stress = 5e6 }] }\n";
  const std::string roof =
      "[lattice]\nsize = [0.024, 0.024]\nspacing = 1e-3\ntime_step = 1e-6\n[time]\nsteps = 1000\n"
      "[geometry]\ntype = \"rock\"\n[rock]\nelement_size = 4e-3\n"
      "notches = [{ from = [0, 0.012], to = [0.024, 0.012], aperture = 0 }]\n"
      "[mechanics]\nyoung_modulus = 30e9\npoisson_ratio = 0.2\ngravity = [0, -9.81]\nrest_tolerance = 5e-3\n"
      "[boundary.top]\ntraction = { support = \"roller\" }\n"
      "[boundary.left]\n" +
      pressed + "[boundary.right]\n" + pressed +
      "[[output.gauges]]\nname = \"block\"\ntype = \"displacement\"\nat = [0.012, 0.006]\n";
  for (const auto& settings : {std::vector<std::string>{}, {"accuracy.tolerance=1e-3"}}) {
    const History found = test::rows_of(parse_scene(roof, "case.toml", settings), 1000, 1000);
    EXPECT_NEAR(column(found, "block_y_m").back() / (-0.5 * 9.81 * 1e-3 * 1e-3), 1, 0.01) << settings.size();
  }
}

/// 16 and 64 times as heavy it follows as closely as rock_inertia.hpp says, and not much more closely.
TEST(Tolerance, MakesRockNoHeavierThanItsLoadsBear) {
  for (const double tolerance : {5e-3, 1e-2}) {
    const double off = off_rest(with_tolerance(tolerance));
    std::printf("    tolerance %g: off by %.1e of the load, with every step %.1e\n", tolerance, off, off_rest(finest));
    EXPECT_LT(off, 6 * tolerance);
    EXPECT_GT(off, tolerance) << "could be heavier";
  }
}

}  // namespace
}  // namespace vug
