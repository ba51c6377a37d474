// How long an interval may be, and what a case says of it.
#include "base/require.hpp"
#include "coupling/amount_share.hpp"
#include "coupling/force_change.hpp"
#include "coupling/given_changes.hpp"
#include "coupling/interval_chooser.hpp"
#include "coupling/simulation.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <map>
#include <string>
#include <vector>

namespace vug {
namespace {

TEST(NextInterval, DoublesWhereThereIsRoomAndShrinksAtOnce) {
  EXPECT_EQ(next_interval(1, 16, 1e-4, 1e-3), 2);
  EXPECT_EQ(next_interval(4, 16, 1e-4, 1e-3), 4) << "8 steps would change it by 0.8 of what is allowed";
  EXPECT_EQ(next_interval(8, 16, 1e-4, 1e-3), 8) << "no back and forth";
  EXPECT_EQ(next_interval(16, 16, 1e-4, 1e-3), 8);
  EXPECT_EQ(next_interval(16, 16, 1e-3, 1e-3), 1);
  EXPECT_EQ(next_interval(16, 16, 1, 1e-3), 1) << "never less than a step";
  EXPECT_EQ(next_interval(16, 16, 0, 1e-3), 16);
  EXPECT_EQ(next_interval(8, 16, 0, 1e-3), 16);
  EXPECT_EQ(next_interval(16, 4, 0, 1e-3), 4) << "no longer than is stable";
  EXPECT_EQ(next_interval(16, 16, NAN, 1e-3), 1) << "what is not known is not held";
}

TEST(ShareOf, IsAllWhereThereIsNothingYet) {
  EXPECT_EQ(share_of(0, 0), 1);
  EXPECT_EQ(share_of(1, 4), 0.25);
}

TEST(AmountShare, IsNothingWhereThereIsExactlyNone) {
  EXPECT_EQ(amount_share(0, 0), 0);
  EXPECT_EQ(amount_share(1, 0), 1) << "all of it is gone";
  EXPECT_EQ(amount_share(1, 4), 0.25);
  EXPECT_EQ(amount_share(0, -1), 1) << "less than none";
  EXPECT_EQ(amount_share(NAN, NAN), 1);
}

TEST(Steepest, IsTheLargestSlopeInAStretch) {
  const TimeTable table({1, 2, 4, 5}, {0, 6, 4, 4});
  EXPECT_EQ(steepest(table, 0, 10), 6);
  EXPECT_EQ(steepest(table, 0, 1), 0) << "it begins at the end";
  EXPECT_EQ(steepest(table, 0, 1.1), 6);
  EXPECT_EQ(steepest(table, 2, 10), 1) << "it falls as well";
  EXPECT_EQ(steepest(table, 1.9, 2.1), 6);
  EXPECT_EQ(steepest(table, 4, 9), 0);
  EXPECT_EQ(steepest(TimeTable(3), 0, 10), 0);
}

/// Share by which given values change in ten steps of 0.1 s, of heat, solutes and forces.
std::vector<double> raised(const Scene& scene, std::int64_t step) {
  Changes changes;
  GivenChanges(scene).raise(changes, Clock{step, 0.1}, 10);
  EXPECT_EQ(changes.solid, 0);
  return {changes.heat, changes.solute, changes.force};
}

TEST(GivenChanges, AreThoseOfTheStepsToComeOverTheLargestDistanceFromRest) {
  const auto values = [](double heat, double solute, double force) { return std::vector<double>{heat, solute, force}; };
  Scene scene;
  scene.heat.emplace().initial_temperature = 300;
  scene.flow.emplace().initial_pressure = 100;
  scene.solute.emplace();
  scene.mechanics.emplace();
  EXPECT_EQ(raised(scene, 0), values(0, 0, 0));

  scene.left.heat.temperature = TimeTable({0, 4, 5}, {300, 300, 280});
  EXPECT_EQ(raised(scene, 0), values(0, 0, 0)) << "the steps end before";
  EXPECT_EQ(raised(scene, 40), values(1, 0, 0)) << "20 K in 1 s, of 20";
  EXPECT_EQ(raised(scene, 35), values(1, 0, 0)) << "at its steepest";
  EXPECT_EQ(raised(scene, 50), values(0, 0, 0)) << "it lies behind";
  scene.left.heat.temperature = {};

  scene.top.solute.concentration["A"] = TimeTable({0, 2}, {8, 2});
  EXPECT_EQ(raised(scene, 0), values(0, 0.375, 0)) << "3 per s, of 8";
  scene.top.solute.concentration.clear();
  scene.top.solute.flux["A"] = TimeTable({0, 2}, {0, -2});
  EXPECT_EQ(raised(scene, 0), values(0, 0.5, 0));
  scene.top.solute.flux.clear();
  scene.top.heat.flux = TimeTable({0, 4}, {0, 1});
  EXPECT_EQ(raised(scene, 0), values(0.25, 0, 0));
  scene.top.heat.flux = {};

  const TimeTable table({0, 4}, {100, 300});  // a half per s of 200 Pa, a sixth per s of 300
  scene.injections.resize(1);
  FlowBoundary& flow = scene.injections[0].conditions.flow;
  flow.pressure = table;
  EXPECT_EQ(raised(scene, 0), values(0.25, 0.25, 0.25)) << "the flow carries and pushes";
  flow.pressure = {};
  for (int kind = 0; kind < 5; ++kind) {
    FlowBoundary other;
    if (kind < 2) other.velocity[kind] = TimeTable({0, 4}, {1, 2});
    if (kind == 2) other.speed = TimeTable({0, 4}, {1, 2});
    if (kind == 3) other.flow_rate = TimeTable({0, 4}, {1, 2});
    if (kind == 4) other.mass_flow_rate = TimeTable({0, 4}, {1, 2});
    flow = other;
    EXPECT_EQ(raised(scene, 0), values(0.125, 0.125, 0.125)) << kind;
  }
  scene.mechanics.reset();
  scene.solute.reset();
  EXPECT_EQ(raised(scene, 0), values(0.125, 0, 0)) << "nothing else is held";
}

TEST(LongestIntervals, ArePowersOfTwoThatEndWithALook) {
  AccuracySection accuracy;
  accuracy.heat_interval = 7;
  accuracy.solute_interval = 200;
  accuracy.wall_interval = 1000;
  accuracy.exchange_interval = 3;
  accuracy.update_interval = 1;
  EXPECT_EQ(longest_intervals(accuracy), (Intervals{4, 128, 512, 2, 1}));
}

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

TEST(LargestForceChange, IsThatOfOneTriangleSinceTheLastCall) {
  const VectorField<double> force("force", 3), before("before", 3);
  const auto set = [&](std::initializer_list<double> xy) {
    const auto host = Kokkos::create_mirror_view(force);
    for (int k = 0; k < 6; ++k) host(k / 2, k % 2) = xy.begin()[k];
    Kokkos::deep_copy(force, host);
  };
  set({3, -4, 0, 1, -2, 0});
  const ForceChange first = largest_force_change(Exec{}, force, before),
                    again = largest_force_change(Exec{}, force, before);
  EXPECT_DOUBLE_EQ(first.change, 5);
  EXPECT_DOUBLE_EQ(first.force, 5);
  EXPECT_EQ(again.change, 0);
  EXPECT_DOUBLE_EQ(again.force, 5);
  set({3, -4, 6, 9, -2, 0});
  const ForceChange moved = largest_force_change(Exec{}, force, before);
  EXPECT_DOUBLE_EQ(moved.change, 10);
  EXPECT_DOUBLE_EQ(moved.force, std::hypot(6, 9));
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
