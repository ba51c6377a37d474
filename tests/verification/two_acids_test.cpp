// Two acids at the same walls: each takes what its own law allows, and the rock loses what both take.
#include "support/coupled_run.hpp"
#include "verification/mineral_channels.hpp"

#include <gtest/gtest.h>

#include <string>

namespace vug {
namespace {

using namespace test::mineral_channels;

/// Two acids at the same walls, with diffusivities, rates and moles of their own.
const std::string weak_acid = R"(
[[solute.species]]
name = "weak"
diffusivity = 1e-4
initial = 500
[[reaction.further]]
reactant = "weak"
rate_constant = 0.1
[boundary.top.solute.concentration]
acid = 1000
weak = 500
)";

std::string with_weak_acid() {
  std::string text = channels;
  const std::string top = "solute = { type = \"concentration\", concentration = { acid = 1000 } }\n";
  text.replace(text.find(top), top.size(), "[boundary.top.solute]\ntype = \"concentration\"\n");
  return text + weak_acid;
}

TEST(TwoAcids, EachTakesWhatItsOwnRateAllows) {
  test::CoupledRun run(with_weak_acid(),
                       {"mineral.0.further=[{reactant=\"weak\", rate_constant=0.04, stoichiometry=3}]",
                        "mineral.1.further=[{reactant=\"weak\", order=0.5}]", "reaction.reference_concentration=400",
                        "mineral.0.molar_volume=1e-9", "mineral.1.molar_volume=1e-9"});
  run.steps(16000);
  const double d = fluid_rows * dx;
  const auto exact = [&](double C, double diffusivity, double k) { return C / (d / diffusivity + 1 / k); };
  const double volume = -run.gain("calcite_volume", "dissolved");
  EXPECT_NEAR(flux_into(run, "calcite", "acid", 1) / exact(1000, D, 0.02), 1, 1e-7);
  expect_flux("second acid, rate constant, m/s", 0.04, flux_into(run, "calcite", "weak", 3), exact(500, 1e-4, 0.04),
              1e-6);
  expect_flux("second acid, order", 0.5, flux_into(run, "dolomite", "weak", 1), flux_of_order(0.1, 0.5, 400, 500, 1e-4),
              1e-6);
  const double dissolved = -run.gain("calcite_volume", "dissolved") - volume;
  const double speed = 1e-9 * (exact(1000, D, 0.02) + exact(500, 1e-4, 0.04) / 3);
  EXPECT_NEAR(dissolved / (speed * 600 * dt * channel * dx), 1, 1e-6);
  EXPECT_LT(run.worst_balance(), 1e-12);
}

TEST(TwoAcids, DissolveRockWithoutMineralsTogether) {
  std::string text = with_weak_acid();
  text = text.substr(0, text.find("[[mineral]]")) + text.substr(text.find("[boundary.top]"));
  test::CoupledRun run(text, {"reaction.molar_volume=2e-5"});
  run.steps(20000);
  const double by_acid = run.gain("dissolved_volume", "acid_times_molar_volume");
  const double by_weak = run.gain("dissolved_volume", "weak_times_molar_volume");
  EXPECT_GT(by_acid, 0);
  EXPECT_GT(by_weak, 0);
  EXPECT_NEAR((by_acid + by_weak) / run.now("dissolved_volume_m3_per_m"), 1, 1e-12);
  EXPECT_LT(run.worst_balance(), 1e-12);
}

}  // namespace
}  // namespace vug
