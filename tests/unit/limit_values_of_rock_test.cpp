// The numbers of the rock that `vug check` prints, against their definitions in SI.
#include "support/limits.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace vug {
namespace {

using test::limits_of;
using Overrides = std::vector<std::string>;
constexpr auto of = test::limit_of;

/// As a resumed run asks for them: the factor is then that of the checkpoint.
TEST(LimitValues, OfAReactionHoldNoFactorThatTheRunChooses) {
  Simulation simulation(
      parse_scene("[lattice]\nsize = [8, 3]\nspacing = 1\ntime_step = 1\n[time]\nend = 1e6\n[geometry]\n"
                  "type = \"shapes\"\n[[geometry.shapes]]\ntype = \"rectangle\"\nfrom = [4, 0]\nto = [8, 3]\n"
                  "[[solute.species]]\nname = \"A\"\ndiffusivity = 0.1\n[reaction]\nreactant = \"A\"\n"
                  "rate_constant = 0.05\nmolar_volume = 1e-5\n[boundary.left]\n"
                  "solute = { type = \"concentration\", concentration = { A = 1 } }\n"
                  "[accuracy]\ndissolution_tolerance = 0.05\n",
                  "a.toml"));
  simulation.begin();
  while (simulation.parts().ageing->factor() == 1 && simulation.clock().step < 10000) simulation.step();
  EXPECT_GT(simulation.parts().ageing->factor(), 1);
  EXPECT_DOUBLE_EQ(of(simulation.limits(), "reaction", "volume dissolved per volume").value, 1e-5);
}

/// alpha times the largest change from the start, 40 K.
TEST(LimitValues, OfThermalStrainAreThoseOfTheNamedTemperatures) {
  const std::string warmed =
      "[lattice]\nsize = [0.02, 0.02]\nspacing = 1e-3\ntime_step = 1e-5\n[time]\nsteps = 1\n[geometry]\ntype = "
      "\"rock\"\n[rock]\nelement_size = 2e-3\n[heat]\nfluid_diffusivity = 1e-3\nsolid_diffusivity = 1e-3\n"
      "initial_temperature = 300\n[mechanics]\nthermal_expansion = 5e-6\n[boundary.left]\nheat = { type = "
      "\"temperature\", temperature = [[0, 320], [1, 260]] }\n";
  const char* const name = "thermal strain of the named temperatures";
  EXPECT_NEAR(of(limits_of(warmed), "mechanics", name).value, 2e-4, 1e-16);
  EXPECT_TRUE(of(limits_of(warmed), "mechanics", name).inside());
  EXPECT_FALSE(of(limits_of(warmed, {"mechanics.thermal_expansion=6e-4"}), "mechanics", name).inside());
  EXPECT_NEAR(of(limits_of(warmed, {"mechanics.material=[{ type = \"rectangle\", from = [0, 0], to = [0.01, 0.02], "
                                    "thermal_expansion = 1e-5 }]"}),
                 "mechanics", name)
                  .value,
              4e-4, 1e-16);
}

/// The fastest of all, times the root of the mass; none without an initial velocity.
TEST(LimitValues, OfInitialVelocitiesAreThoseOfPlatens) {
  const std::string rock =
      "[lattice]\nsize = [0.02, 0.02]\nspacing = 1e-3\ntime_step = 1e-5\n[time]\nsteps = 1\n[geometry]\ntype = "
      "\"rock\"\n[rock]\nelement_size = 2e-3\n[mechanics]\n";
  const auto thrown = [](const std::string& vx, const std::string& vy) {
    return "{ type = \"rectangle\", from = [0, 0], to = [0.01, 0.02], velocity = [" + vx + ", " + vy + "] }";
  };
  const char* const name = "initial velocity times sqrt(mass_scaling)";
  EXPECT_THROW(of(limits_of(rock), "mechanics", name), std::exception);
  const std::string both = "mechanics.initial_velocity=[" + thrown("0.3", "0.4") + ", " + thrown("0", "0.1") + "]";
  const Limit light = of(limits_of(rock, {both}), "mechanics", name);
  EXPECT_NEAR(light.value, 0.5, 1e-15);
  EXPECT_TRUE(light.inside());
  const Limit heavy = of(limits_of(rock, {both, "mechanics.mass_scaling=9"}), "mechanics", name);
  EXPECT_NEAR(heavy.value, 1.5, 1e-15);
  EXPECT_FALSE(heavy.inside());
}

TEST(LimitValues, OfRockAreThoseOfItsMostBrittleMaterial) {
  const auto longest = [](const Overrides& overrides) {
    return of(limits_of("[lattice]\nsize = [0.02, 0.02]\nspacing = 1e-3\ntime_step = 1e-5\n[time]\nsteps = 1\n"
                        "[geometry]\ntype = \"rock\"\n[rock]\nelement_size = 2e-3\n[mechanics]\n"
                        "[mechanics.bond]\nnormal_strength = 10e6\n",
                        overrides),
              "mechanics", "mean edge of the bonds")
        .high;
  };
  const auto half_of = [](const std::string& strength) {
    return "mechanics.material=[{ type = \"rectangle\", from = [0, 0], to = [0.01, 0.02], bond = { normal_strength = " +
           strength + " } }]";
  };
  const double plain = longest({});
  EXPECT_NEAR(longest({half_of("20e6")}), plain / 4, 1e-9 * plain);  // E G / sigma^2
  EXPECT_NEAR(longest({half_of("5e6")}), plain, 1e-9 * plain);
}

}  // namespace
}  // namespace vug
