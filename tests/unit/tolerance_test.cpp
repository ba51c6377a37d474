// The intervals that a case with a tolerance takes.
#include "base/require.hpp"
#include "coupling/simulation.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <string>

namespace vug {
namespace {

const std::string warm_slab =
    "[lattice]\nsize = [24, 8]\nspacing = 1\ntime_step = 1\n[time]\nsteps = 1600\n"
    "[geometry]\ntype = \"shapes\"\n[[geometry.shapes]]\ntype = \"rectangle\"\nfrom = [16, 0]\nto = [24, 8]\n"
    "[heat]\nfluid_diffusivity = 0.1\nsolid_diffusivity = 0.2\ninitial_temperature = 300\n";

/// No longer than the relaxation times bear, each below 3.5: 3 n 0.2 <= 3.
TEST(LongestIntervals, AreStable) {
  Intervals most{16, 16, 16, 16, 16};
  const Simulation simulation(parse_scene(warm_slab + "[accuracy]\ntolerance = 1e-3\n", "slab.toml"));
  for (const auto& module : simulation.parts().modules) module->bound(0, most);
  EXPECT_EQ(most.heat, 4);
  most.heat = 16;
  const Simulation d2q9(
      parse_scene(warm_slab + "velocity_set = \"d2q9\"\n[accuracy]\ntolerance = 1e-3\n", "slab.toml"));
  for (const auto& module : d2q9.parts().modules) module->bound(0, most);
  EXPECT_EQ(most.heat, 1) << "steps of D2Q9 stay as long as they are";
}

const std::string dissolving =
    "[lattice]\nsize = [24, 8]\nspacing = 1\ntime_step = 1\n"
    "[geometry]\ntype = \"shapes\"\n[[geometry.shapes]]\ntype = \"rectangle\"\nfrom = [16, 0]\nto = [24, 8]\n"
    "[solute]\n[[solute.species]]\nname = \"A\"\ndiffusivity = 0.1\ninitial = 1\n"
    "[reaction]\nreactant = \"A\"\nrate_constant = 0.05\nmolar_volume = 0.02\n";

TEST(Tolerance, ChoosesTheIntervalsOrHowFastTheRockAges) {
  const auto accuracy = [](const std::string& text) { return parse_scene(text, "case.toml").accuracy; };
  const AccuracySection heat = accuracy(warm_slab + "[accuracy]\ntolerance = 1e-3\nheat_interval = 4\n");
  EXPECT_TRUE(heat.chooses_intervals());
  EXPECT_EQ(heat.heat_interval, 4) << "the longest";
  EXPECT_EQ(heat.exchange_interval, 16);
  EXPECT_EQ(heat.precision, Precision::double_precision);
  EXPECT_EQ(accuracy(warm_slab + "[accuracy]\ntolerance = 1e-2\n").precision, Precision::single_precision);
  EXPECT_EQ(accuracy(warm_slab + "[accuracy]\ntolerance = 1e-2\npreset = \"balanced\"\n").precision,
            Precision::double_precision);

  const AccuracySection ages = accuracy(dissolving + "[time]\nend = 1600\n[accuracy]\ntolerance = 1e-3\n");
  EXPECT_FALSE(ages.chooses_intervals());
  EXPECT_EQ(ages.dissolution_tolerance, 1e-3);
  EXPECT_EQ(ages.solute_interval, 2) << "of its preset";
  const std::string steps = dissolving + "[time]\nsteps = 1600\n[accuracy]\ntolerance = 1e-3\n";
  EXPECT_TRUE(accuracy(steps).chooses_intervals()) << "lattice steps are asked for";
  EXPECT_TRUE(accuracy(dissolving + "[time]\nend = 1600\n[accuracy]\ntolerance = 1e-3\ndissolution_factor = 10\n")
                  .chooses_intervals());
  EXPECT_THROW(accuracy(warm_slab + "[accuracy]\ntolerance = 0.5\n"), InputError);
}

/// A tracer and a product that does not turn back keep the time of the fluid: a plain tolerance does not let the rock
/// age faster beside them, and where the case asks for that it is said.
TEST(Tolerance, LetsRockAgeFasterWhereEverySpeciesTakesPart) {
  const std::string salt = "[[solute.species]]\nname = \"salt\"\ndiffusivity = 0.1\n[time]\nend = 1600\n";
  const auto scene = [&](const std::string& accuracy, const std::vector<std::string>& settings = {}) {
    return parse_scene(dissolving + salt + "[accuracy]\n" + accuracy, "case.toml", settings);
  };
  const std::vector<std::string> product{"reaction.product=\"salt\""};
  const std::vector<std::string> both_ways{"reaction.product=\"salt\"", "reaction.equilibrium_constant=2"};
  EXPECT_EQ(scene("tolerance = 1e-3\n").accuracy.dissolution_tolerance, 0);
  EXPECT_EQ(scene("tolerance = 1e-3\n", product).accuracy.dissolution_tolerance, 0);
  EXPECT_EQ(scene("tolerance = 1e-3\n", both_ways).accuracy.dissolution_tolerance, 1e-3);
  const auto told = testing::Contains(testing::HasSubstr("nothing that dissolves depends on salt"));
  EXPECT_THAT(scene("dissolution_tolerance = 1e-3\n").warnings, told);
  EXPECT_THAT(scene("dissolution_tolerance = 1e-3\n", product).warnings, told);
  EXPECT_THAT(scene("dissolution_tolerance = 1e-3\n", both_ways).warnings, testing::Not(told));
  EXPECT_THAT(scene("tolerance = 1e-3\n").warnings, testing::Not(told));
}

/// Beside a wall that acid dissolves, or where acid and product have exchanged their roles: as much rock grows then.
Scene wall_of_both_ways(const std::string& acid, const std::string& product) {
  const auto species = [](const char* name, const std::string& initial) {
    return fmt::format("[[solute.species]]\nname = \"{}\"\ndiffusivity = 0.1\ninitial = {}\n", name, initial);
  };
  return parse_scene(
      "[lattice]\nsize = [24, 4]\nspacing = 1\ntime_step = 1\n[time]\nsteps = 3000\n"
      "[geometry]\ntype = \"shapes\"\n[[geometry.shapes]]\ntype = \"rectangle\"\nfrom = [16, 0]\n"
      "to = [24, 4]\n[reaction]\nreactant = \"A\"\nproduct = \"B\"\nrate_constant = 0.05\n"
      "equilibrium_constant = 1\nmolar_volume = 1e-5\n[accuracy]\ntolerance = 0.01\n" +
          species("A", acid) + species("B", product) +
          "[boundary.left]\nsolute = { type = \"concentration\", concentration = { A = " + acid + ", B = " + product +
          " } }\n",
      "a.toml");
}

TEST(Tolerance, HoldsGrowingRockAsLongAsDissolvingRock) {
  const auto intervals = [](const Scene& scene) {
    Simulation simulation(scene);
    simulation.begin();
    for (int step = 0; step < 3000; ++step) simulation.step();
    std::map<std::string, double> found;
    for (const HistoryValue& value : simulation.history()) found[value.name] = value.value;
    return found;
  };
  const auto dissolving_rock = intervals(wall_of_both_ways("1", "0"));
  const auto growing_rock = intervals(wall_of_both_ways("0", "1"));
  const double dissolved = dissolving_rock.at("dissolved_volume_m3_per_m");
  EXPECT_NEAR(growing_rock.at("dissolved_volume_m3_per_m"), -dissolved, 1e-3 * dissolved);
  for (const char* name : {"solute_interval_1", "wall_interval_1", "update_interval_1"}) {
    EXPECT_GE(2 * growing_rock.at(name), dissolving_rock.at(name)) << name;
    EXPECT_LE(growing_rock.at(name), dissolving_rock.at(name)) << name << ": acid that is given back changes by more";
  }
  EXPECT_GT(dissolving_rock.at("update_interval_1"), 8);
}

/// A slit of 4 cells that has become a channel of 20: fluid is faster than any pressure could drive it in the slit.
TEST(Tolerance, FollowsTheFlowInPoresThatHaveOpened) {
  const double nu = 1 / 15.0, pressure = 0.15 * 8 * nu * 20 / (20 * 20);
  Simulation run(parse_scene(
      fmt::format("[lattice]\nsize = [20, 20]\nspacing = 1\ntime_step = 1\n[time]\nsteps = 8000\n[geometry]\n"
                  "type = \"shapes\"\nbackground = \"solid\"\n[[geometry.shapes]]\ntype = \"rectangle\"\nmaterial = "
                  "\"fluid\"\nfrom = [0, 8]\nto = [20, 12]\n[flow]\ndensity = 1\nviscosity = {}\n"
                  "initial_pressure = 0\nspeed_limit = 0.5\n[[solute.species]]\nname = \"A\"\ndiffusivity = 0.1\n"
                  "initial = 1\n[reaction]\nreactant = \"A\"\nrate_constant = 0.1\nmolar_volume = 0.3\n"
                  "[accuracy]\ntolerance = 0.05\npreset = \"careful\"\n[boundary.left]\n"
                  "flow = {{ type = \"pressure\", pressure = {}, ramp_time = 2000 }}\n"
                  "solute = {{ type = \"concentration\", concentration = {{ A = 1 }} }}\n[boundary.right]\n"
                  "flow = {{ type = \"pressure\", pressure = 0 }}\n",
                  nu, pressure),
      "a.toml"));
  run.begin();
  for (int step = 0; step < 6000; ++step) run.step();
  double mach = 0;
  for (const HistoryValue& value : run.history())
    if (value.name == "largest_mach_1") mach = value.value;
  const double speed = mach / std::sqrt(3.0);
  ASSERT_GT(speed, 1.2 * std::sqrt(2 * pressure)) << "Bernoulli's, the bound in the slit";
  for (const auto& module : run.parts().modules) {
    if (module->name() != "flow") continue;
    Changes changes;
    module->watch(Exec{}, run.clock(), changes);
    EXPECT_NEAR(*changes.speed, speed, 1e-6);
  }
}

/// A force that changes by more than 4 tolerances in two steps is passed on at every step. It grows linearly from step
/// 1024 to step 3072: by a 128th per step at the first look after that, by a 256th at the second.
TEST(Tolerance, PassesForcesOnAtEveryStepWhileARampPushes) {
  Simulation simulation(
      parse_scene("[lattice]\nsize = [0.012, 0.008]\nspacing = 5e-4\ntime_step = 2e-6\n[time]\nsteps = 5000\n"
                  "[geometry]\ntype = \"rock\"\n[rock]\nelement_size = 3e-3\nporosity = 0\n"
                  "[rock.hole]\nfrom = [0, 0.002]\nto = [0.004, 0.006]\n"
                  "[flow]\ndensity = 1000\nviscosity = 1.25e-2\ninitial_pressure = 0\n"
                  "[mechanics]\nlocal_damping = 0.7\n"
                  "[boundary.left]\ntraction = { support = \"fixed\" }\n"
                  "[boundary.injection]\nside = \"left\"\ncentre = 0.004\nwidth = 0.004\n"
                  "flow = { type = \"pressure\", pressure = [[0, 10], [2.048e-3, 10], [6.144e-3, 1e5]] }\n"
                  "[accuracy]\ntolerance = 1e-3\n",
                  "a.toml"));
  simulation.begin();
  const auto interval_at = [&](int step) {
    while (simulation.clock().step < step) simulation.step();
    for (const HistoryValue& value : simulation.history())
      if (value.name == "exchange_interval_1") return value.value;
    return 0.0;
  };
  EXPECT_EQ(interval_at(1024 + 130), 1);
  EXPECT_EQ(interval_at(1024 + 258), 1);
  EXPECT_GE(interval_at(3072 + 1024), 8);
}

/// A species that nobody injects, and heat that never comes, hold nothing back.
TEST(Tolerance, IsNotHeldByWhatThereIsNoneOf) {
  const std::string diffusing =
      "[lattice]\nsize = [24, 4]\nspacing = 1\ntime_step = 1\n[time]\nsteps = 2000\n"
      "[heat]\nfluid_diffusivity = 0.1\nsolid_diffusivity = 0.1\ninitial_temperature = 300\n"
      "[[solute.species]]\nname = \"A\"\ndiffusivity = 0.1\ninitial = 1\n"
      "[[solute.species]]\nname = \"B\"\ndiffusivity = 0.1\n"
      "[boundary.left]\nsolute = { type = \"concentration\", concentration = { A = 1.5 } }\n"
      "[accuracy]\ntolerance = 1e-2\n";
  Simulation simulation(parse_scene(diffusing, "a.toml"));
  simulation.begin();
  for (int step = 0; step < 2000; ++step) simulation.step();
  for (const HistoryValue& value : simulation.history())
    if (value.name == "heat_interval_1" || value.name == "solute_interval_1") {
      EXPECT_EQ(value.value, 8) << value.name << ", the longest that is stable";
    }
}

TEST(Tolerance, SeesAcidThatIsGivenBack) {
  Simulation simulation(wall_of_both_ways("0", "1"));
  simulation.begin();
  for (int step = 0; step < 10; ++step) simulation.step();
  for (const auto& module : simulation.parts().modules) {
    if (module->name() != "reaction") continue;
    Changes changes;
    module->watch(Exec{}, simulation.clock(), changes);
    EXPECT_GT(changes.solute, 0.5) << "of what there is of it";
    EXPECT_EQ(changes.solid, 1) << "all that there is has come since the start";
    return;
  }
  FAIL() << "no reaction";
}

}  // namespace
}  // namespace vug
