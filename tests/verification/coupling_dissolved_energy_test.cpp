// Where the energy of rock that moves and dissolves is, by the columns of the history.
#include "dem_support.hpp"
#include "support/coupled_run.hpp"
#include "support/pickled_rock.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace vug {
namespace {

/// Two halves of the block that move towards each other and ring: the history tells where their energy is, in what is
/// left and in what the acid has taken.
TEST(DissolvedEnergy, AndWhatIsLeftAddUpInTheHistory) {
  const auto half = [](double from, double to, double speed) {
    return fmt::format("{{ type = \"rectangle\", from = [{}, 0], to = [{}, 0.014], velocity = [{}, 0] }}", from, to,
                       speed);
  };
  test::CoupledRun run(
      test::replaced(test::pickled_rock, "molar_volume = 4e-4", "molar_volume = 2e-3"),
      {"mechanics.initial_velocity=[" + half(0, 0.010, 0.1) + ", " + half(0.010, 0.02, -0.1) + "]",
       "mechanics.bond.damping=0", "mechanics.contact.normal_damping=0", "mechanics.contact.friction=0"});
  const double start = run.now("kinetic_energy_J_per_m");
  double mass = 0;
  const auto masses = test::host_copy(run.rock().particles().mass);
  for (int i = 0; i < run.rock().particles().count; ++i) mass += masses(i);
  EXPECT_NEAR(start, 0.5 * mass * 0.01, 1e-12 * start);
  run.steps(100);
  ASSERT_EQ(run.now("bonds_dissolved_1"), 0) << "what a failing bond still stores is lost";
  double sum = 0;
  for (const char* name : {"kinetic_energy_J_per_m", "elastic_energy_J_per_m", "dissolved_rock_kinetic_energy_J_per_m",
                           "dissolved_rock_elastic_energy_J_per_m"}) {
    EXPECT_GT(run.now(name), 0.05 * start) << name;
    sum += run.now(name);
  }
  EXPECT_NEAR(sum, start, 1e-6 * start);
}

}  // namespace
}  // namespace vug
