// Error bars: the law, what they say beside a run, and what is left out.
#include "coupling/error_bars.hpp"

#include "base/require.hpp"
#include "support/heated_slab.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace vug {
namespace {

using namespace test;

TEST(ErrorBar, OfAPureOrderIsAQuarterLongerThanTheError) {
  for (const double order : {0.5, 1.0, 1.5, 2.0})
    for (const double ratio : {4.0 / 3, 1.5, 2.0}) {
      const auto value = [&](double h) { return 7 - 0.3 * std::pow(h, order); };
      const ErrorBar found = error_bar(value(1), value(ratio), value(ratio * ratio), ratio);
      EXPECT_EQ(found.convergence, Convergence::monotone);
      EXPECT_NEAR(*found.order, order, 1e-9);
      EXPECT_NEAR(found.bar, 1.25 * 0.3, 1e-9);
    }
}

TEST(ErrorBar, TrustsNoOrderAboveThatOfTheSchemes) {
  const ErrorBar found = error_bar(1, 1 + 0.1, 1 + 0.1 + 6.4, 2);  // sixth order, by chance
  EXPECT_NEAR(*found.order, 6, 1e-9);
  EXPECT_NEAR(found.bar, 1.25 * 0.1 / 3, 1e-12);
}

TEST(ErrorBar, GrowsWhereTheLatticesAgreeOnNoOrder) {
  EXPECT_EQ(error_bar(1, 1.1, 0.9, 2).convergence, Convergence::oscillating);
  EXPECT_NEAR(error_bar(1, 1.1, 0.9, 2).bar, 0.3, 1e-12);
  EXPECT_NEAR(error_bar(1, 1.1, 0.1, 2).bar, 1.0, 1e-12);
  EXPECT_EQ(error_bar(1, 1.3, 1.4, 2).convergence, Convergence::none);
  EXPECT_NEAR(error_bar(1, 1.3, 1.4, 2).bar, 0.9, 1e-12);
  EXPECT_EQ(error_bar(1, 1.1, std::nullopt, 2).convergence, Convergence::unknown);
  EXPECT_NEAR(error_bar(1, 1.1, std::nullopt, 2).bar, 0.3, 1e-12);
  EXPECT_EQ(error_bar(1, 1, 1, 2).bar, 0);
}

/// What a balance fixes is the same on every lattice but for the last digits.
TEST(ErrorBar, OfRoundingIsNoLackOfConvergence) {
  const ErrorBar found = error_bar(2e-3, 2e-3 + 2e-18, 2e-3 + 1e-18, 2);
  EXPECT_EQ(found.convergence, Convergence::monotone);
  EXPECT_FALSE(found.order);
  EXPECT_LE(found.bar, 1e-17);
}

/// Two lattices that agree by chance do not make a number exact: the third says how far it may be off.
TEST(ErrorBar, IsNotZeroWhereTwoOfThreeLatticesAgree) {
  for (const double coarser : {1.4, 0.6}) {
    EXPECT_NEAR(error_bar(1, 1, coarser, 2).bar, 0.4, 1e-12);
    EXPECT_FALSE(error_bar(1, 1, coarser, 2).order);
  }
}

/// Of first order in the interval: half of the error is left, and the bar is a quarter longer than all of it.
TEST(ErrorBarsOfRock, AreAQuarterLongerThanTheErrorOfTheirIntervals) {
  const double exact = 7, error = -0.4;
  const ErrorBars bars = find_error_bars({{"time_s", "a_m"}, {{0, 1}, {exact, exact + error}}},
                                         {{{"time_s", "a_m"}, {{0, 1}, {exact, exact + error / 2}}}}, 0);
  ASSERT_EQ(bars.names, std::vector<std::string>{"a_m"});
  EXPECT_EQ(bars.bar[0][0], 0);
  EXPECT_NEAR(bars.bar[0][1], 1.25 * std::abs(error), 1e-12);
}

/// What no twin has varied is not known to be exact.
TEST(ErrorBarsOfRock, AreNoneWhereTheOnlyTwinAgrees) {
  const History run{{"time_s", "a_m", "b_m"}, {{0, 1, 2}, {1, 2, 3}, {1, 2, 3}}};
  const History twin{{"time_s", "a_m", "b_m"}, {{0, 1, 2}, {1, 2, 3}, {1, 2.5, 3}}};
  for (const double ratio : {0.0, 2.0}) {
    const ErrorBars bars = find_error_bars(run, {twin}, ratio);
    for (const double bar : bars.bar[0]) EXPECT_TRUE(std::isnan(bar));
    EXPECT_TRUE(std::isnan(bars.last[0].error.bar));
    EXPECT_EQ(bars.bar[1][0], 0);  // the start is that of the case
    EXPECT_GT(bars.bar[1][1], 0);
    EXPECT_TRUE(std::isnan(bars.bar[1][2])) << "the two crossed";
  }
  EXPECT_EQ(find_error_bars(run, {run, run}, 2).bar[0][2], 0) << "three lattices that agree say more";
}

/// All lattices have the walls of the start, so that nothing differs by how far these are behind.
TEST(ErrorBarsOfARun, AreNoneWhereWallsDissolveThatHaveNotMoved) {
  const std::vector<std::string> names{"time_s", "dissolved_volume_m3_per_m", "reactive_area_m2_per_m",
                                       "nodes_dissolved_1"};
  const std::vector<double> area(5, 2), volume{0, 1e-7, 1e-3, 3e-3, 5e-3};
  const History run{names, {{0, 1, 2, 3, 4}, volume, area, {0, 0, 0, 1, 3}}},
      coarse{names, {{0, 1, 2, 3, 4}, {0, 1.1e-7, 1.1e-3, 3.1e-3, 5.2e-3}, area, {0, 0, 0, 0, 1}}},
      coarser{names, {{0, 1, 2, 3, 4}, {0, 1.4e-7, 1.4e-3, 3.4e-3, 5.9e-3}, area, {0, 0, 0, 0, 0}}};
  const ErrorBars bars = find_error_bars(run, {coarse, coarser}, 2, 1e-12, 0, 1e-3);
  ASSERT_EQ(bars.names[0], names[1]);
  const auto known = [&](int row) { return !std::isnan(bars.bar[0][row]); };
  EXPECT_TRUE(known(1));  // 5e-5 of a cell
  EXPECT_FALSE(known(2));
  EXPECT_FALSE(known(3));
  EXPECT_TRUE(known(4));
  EXPECT_EQ(bars.last[0].error.convergence, Convergence::monotone);
  const ErrorBars finer = find_error_bars(run, {coarse, coarser}, 2);
  EXPECT_FALSE(std::isnan(finer.bar[0][3])) << "the same walls on all lattices";
}

/// A slab behind 8 cells of acid: ds/dt = N C D/s, of which 0.37 cells dissolve in 300 s and no node is used up.
TEST(ErrorBarsOfARun, SayThatWallsHaveNotMoved) {
  const CaseFile file(R"(
[lattice]
size = [16e-5, 16e-5]
spacing = 1e-5
time_step = 0.02
[time]
end = 300
[geometry]
type = "shapes"
[[geometry.shapes]]
type = "rectangle"
from = [8e-5, 0]
to = [16e-5, 1]
[solute]
[[solute.species]]
name = "A"
diffusivity = 1e-9
[reaction]
reactant = "A"
rate_constant = 1e-2
molar_volume = 1e-6
[boundary.left]
solute = { type = "concentration", concentration = { A = 1000 } }
)");
  RunOptions options;
  options.directory = file.folder() / "run";
  const std::string report = run_with_error_bars(file.scene(), options);
  EXPECT_NE(report.find("no bar: rock dissolves, but no wall of the coarser lattices has moved yet"), std::string::npos)
      << report;
  const History bars = read_history(options.directory + "/error_bars.csv");
  const auto& bar = bars.values[static_cast<std::size_t>(bars.find("bar_of_dissolved_volume_m3_per_m"))];
  EXPECT_EQ(bar.front(), 0);
  EXPECT_TRUE(std::isnan(bar.back()));
}

TEST(ErrorBarsOfRock, StandBesideItsHistory) {
  const test::TemporaryFolder folder;
  RunOptions options;
  options.directory = folder / "run";
  std::vector<std::string> overrides = rock_intervals;
  overrides.insert(overrides.end(), {"time.steps=30", "output.interval=2.5e-5"});
  const std::string report = run_with_error_bars(read_scene(test::small_rock, overrides), options);
  EXPECT_NE(report.find("one comparison only"), std::string::npos) << report;
  EXPECT_NE(report.find("-                  no bar: the one comparison agrees"), std::string::npos) << report;
  const History run = read_history(options.directory + "/history.csv");
  const History finer = read_history(options.directory + "/error_bars/finer/history.csv");
  const History bars = read_history(options.directory + "/error_bars.csv");
  const auto last = [](const History& history, const std::string& name) {
    return history.values.at(static_cast<std::size_t>(history.find(name))).back();
  };
  const char* stored = "heat_stored_J_per_m";
  EXPECT_NE(last(run, stored), last(finer, stored));
  EXPECT_NEAR(last(bars, std::string("bar_of_") + stored), 2.5 * std::abs(last(run, stored) - last(finer, stored)),
              1e-9 * std::abs(last(run, stored)));
}

TEST(ErrorBarsOfARun, StandBesideEveryAmountOfItsHistory) {
  const CaseFile file(slab);
  RunOptions options;
  options.directory = file.folder() / "run";
  const std::string report = run_with_error_bars(file.scene(), options);
  EXPECT_NE(report.find("heat_stored_J_per_m"), std::string::npos) << report;
  const History run = read_history(options.directory + "/history.csv");
  const History bars = read_history(options.directory + "/error_bars.csv");
  EXPECT_EQ(bars.time(), run.time());
  EXPECT_EQ(bars.find("step_1"), -1);
  EXPECT_EQ(bars.find("heat_balance_error_1"), -1);
  const int stored = bars.find("heat_stored_J_per_m");
  ASSERT_GE(stored, 0);
  EXPECT_EQ(bars.values[static_cast<std::size_t>(stored)],
            run.values[static_cast<std::size_t>(run.find("heat_stored_J_per_m"))]);
  const auto& bar = bars.values[static_cast<std::size_t>(stored) + 1];
  EXPECT_EQ(bar.front(), 0);
  for (std::size_t k = 1; k < bar.size(); ++k) EXPECT_GT(bar[k], 0);
  EXPECT_THROW(run_with_error_bars(file.scene(), options), InputError);  // what is there is not replaced unasked
  options.resume = true;
  EXPECT_EQ(run_with_error_bars(file.scene(), options), report);
}

TEST(ErrorBarsOfARun, AreKnownForAPicture) {
  const CaseFile file(slab);
  RunOptions options;
  options.directory = file.folder() / "run";
  const std::string report = run_with_error_bars(pictured(file, 24, 12), options);
  EXPECT_EQ(report.find("left out"), std::string::npos) << report;
  const History bars = read_history(options.directory + "/error_bars.csv");
  const int bar = bars.find("bar_of_heat_stored_J_per_m");
  ASSERT_GE(bar, 0);
  EXPECT_GT(bars.values[static_cast<std::size_t>(bar)].back(), 0);
}

/// A gain that is 0 but for rounding of the amount that is stored: no lattice can converge to it.
TEST(ErrorBars, OfRoundingSayThatTheyAreNone) {
  const std::vector<std::string> names{"time_s", "a_stored_mol_per_m", "a_gain_injected_mol_per_m"};
  const auto history = [&](double stored, double gain) { return History{names, {{0, 1}, {1e-7, stored}, {0, gain}}}; };
  const History run = history(1e-7, 9e-23);
  const auto of_gain = [&](double coarse, double coarser) {
    return find_error_bars(run, {history(1.1e-7, coarse), history(1.4e-7, coarser)}, 2).last.at(1).error.convergence;
  };
  EXPECT_EQ(of_gain(4e-22, 1e-22), Convergence::rounding);
  EXPECT_EQ(of_gain(4e-9, 1e-9), Convergence::none);
}

/// Nothing flows across a symmetric channel, and in a closed cavity nothing on the whole.
TEST(ErrorBars, OfAMeanVelocityThatIsRoundingSayThatTheyAreNone) {
  const auto history = [](double x, double y) {
    return History{{"time_s", "largest_mach_1", "mean_velocity_x_m/s", "mean_velocity_y_m/s"},
                   {{0, 1}, {0, 0.1}, {0, x}, {0, y}}};
  };
  const auto bars = [&](double x, double y, double sound) {
    return find_error_bars(history(x, y), {history(1.1 * x, 3 * y), history(1.4 * x, 2 * y)}, 2, 1e-12, sound).last;
  };
  EXPECT_EQ(bars(2, 3e-19, 0).at(0).error.convergence, Convergence::monotone);
  EXPECT_EQ(bars(2, 3e-19, 0).at(1).error.convergence, Convergence::rounding);
  EXPECT_EQ(bars(2, 3e-3, 0).at(1).error.convergence, Convergence::none);
  for (const int axis : {0, 1}) EXPECT_EQ(bars(2e-18, 3e-19, 4).at(axis).error.convergence, Convergence::rounding);
}

TEST(ErrorBarsOfARun, LeaveOutALatticeOnWhichNoRunHolds) {
  // stirred by 0.15 cells per step, and by 0.3 and 0.6 on the coarser lattices: above 0.5 none is begun
  const CaseFile file(R"(
[lattice]
size = [0.016, 0.016]
spacing = 1e-3
time_step = 5e-3
[time]
steps = 512
[geometry]
type = "open"
[flow]
viscosity = 1e-6
speed_limit = 0
[boundary.top]
flow = { type = "wall", velocity = [0.03, 0] }
[accuracy]
guard_interval = 1
[output]
interval_steps = 64
)");
  RunOptions options;
  options.directory = file.folder() / "run";
  const std::string report = run_with_error_bars(file.scene(), options);
  EXPECT_NE(report.find("left out"), std::string::npos) << report;
}

TEST(ErrorBarsOfARun, AreNotBegunWhereThereIsNothingToCompare) {
  const CaseFile file(slab);
  RunOptions options;
  options.directory = file.folder() / "run";
  EXPECT_THROW(run_with_error_bars(file.scene({"lattice.size=[0.029, 0.013]"}), options), InputError);
  EXPECT_THROW(read_history(options.directory + "/history.csv"), FileError);  // nothing written
}

}  // namespace
}  // namespace vug
