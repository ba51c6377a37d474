// Rock that ages faster than the fluid as far as a tolerance allows (accuracy.dissolution_tolerance), held against
// solutions on paper and against the same case with every step taken.
#include "coupling/events.hpp"
#include "coupling/output_schedule.hpp"
#include "coupling/simulation.hpp"
#include "support/states.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>

namespace vug {
namespace {

using testing::Contains;
using testing::HasSubstr;

/// Still acid between a reservoir and a wall that it dissolves as fast as it gets there.
const std::string wall = R"(
[lattice]
size = [4e-5, 3e-6]
spacing = 1e-6
time_step = 2e-4
[time]
end = 30
[geometry]
type = "shapes"
[[geometry.shapes]]
type = "rectangle"
from = [2e-5, 0]
to = [4e-5, 3e-6]
[solute]
[[solute.species]]
name = "acid"
diffusivity = 1e-9
initial = 0
[reaction]
reactant = "acid"
rate_constant = 1
molar_volume = 4e-5
[boundary.bottom]
solute = { type = "periodic" }
[boundary.top]
solute = { type = "periodic" }
[boundary.left]
solute = { type = "concentration", concentration = { acid = 50 } }
)";

/// A disc in acid that is there from the start and hardly used up: its radius falls at a constant rate.
const std::string disc = R"(
[lattice]
size = [4.8e-5, 4.8e-5]
spacing = 1e-6
time_step = 2e-4
[time]
end = "1 h"
[geometry]
type = "shapes"
[[geometry.shapes]]
type = "disc"
centre = [2.4e-5, 2.4e-5]
radius = 1.6e-5
[solute]
[[solute.species]]
name = "acid"
diffusivity = 1e-9
initial = 1000
[reaction]
reactant = "acid"
rate_constant = 1e-7
molar_volume = 4e-5
[boundary.left]
solute = { type = "concentration", concentration = { acid = 1000 } }
[boundary.right]
solute = { type = "concentration", concentration = { acid = 1000 } }
[boundary.bottom]
solute = { type = "concentration", concentration = { acid = 1000 } }
[boundary.top]
solute = { type = "concentration", concentration = { acid = 1000 } }
)";

double now(const Simulation& simulation, const std::string& column) {
  for (const HistoryValue& value : simulation.history())
    if (value.name == column) return value.value;
  throw std::invalid_argument("no column " + column);
}

double dissolved(const Simulation& simulation) {
  return now(simulation, "dissolved_volume_m3_per_m");
}

/// Steps until the rock is `end` old, and calls at(time, volume) after every `every` seconds of it.
void age(Simulation& simulation, double end, double every, const std::function<void(double, double)>& at) {
  const Schedule rows(1, every);
  while (simulation.clock().time() < end * (1 - 1e-12)) {
    const Clock before = simulation.clock();
    simulation.step();
    if (rows.due(before, simulation.clock())) at(simulation.clock().time(), dissolved(simulation));
  }
  simulation.guard();
}

Scene scene_of(const std::string& text, const std::vector<std::string>& overrides = {}) {
  return parse_scene(text, "case.toml", overrides);
}

/// The volume over time of a case, every step taken.
std::map<double, double> resolved(const std::string& text, double end, double every,
                                  const std::vector<std::string>& overrides = {}) {
  Simulation simulation(scene_of(text, overrides));
  simulation.begin();
  std::map<double, double> volume{{0, 0}};
  age(simulation, end, every, [&](double time, double value) { volume[time] = value; });
  return volume;
}

double at(const std::map<double, double>& volume, double time) {
  auto next = volume.lower_bound(time);
  if (next == volume.end()) --next;
  const auto before = std::prev(next);
  return before->second + (time - before->first) / (next->first - before->first) * (next->second - before->second);
}

struct Followed {
  double worst = 0;     ///< error of the dissolved volume at any row
  double steps = 0;     ///< lattice steps
  double estimate = 0;  ///< of the error, at the end
};

/// Ages a case by a tolerance and holds it against resolved(time).
Followed follow(const std::string& text, double end, int rows, const std::vector<std::string>& overrides,
                const std::function<double(double)>& exact) {
  const Scene scene = scene_of(text, overrides);
  Simulation simulation(scene);
  simulation.begin();
  Followed followed;
  age(simulation, end, end / rows, [&](double time, double volume) {
    followed.worst = std::max(followed.worst, std::abs(volume / exact(time) - 1));
  });
  followed.steps = static_cast<double>(simulation.clock().step);
  followed.estimate = now(simulation, "dissolution_error_1");
  if (scene.accuracy.precision == Precision::double_precision) {
    for (const Balance& balance : simulation.ledger().balances)
      EXPECT_LE(std::abs(balance.relative_error()), 1e-12) << balance.quantity;
  }
  fmt::print("    error {:.2e}, estimated {:.2e}, {} steps\n", followed.worst, followed.estimate, followed.steps);
  return followed;
}

/// From fluid without acid to a wall that has receded by three cells: the start, and pixel after pixel.
TEST(SlowScenes, AWallBehindADiffusionLayerIsWithinTheToleranceAtEveryMoment) {
  const auto volume = resolved(wall, 30, 0.05);
  for (const double tolerance : {3e-2, 1e-2}) {
    const Followed followed = follow(wall, 30, 150, {fmt::format("accuracy.dissolution_tolerance={}", tolerance)},
                                     [&](double time) { return at(volume, time); });
    EXPECT_LE(followed.worst, tolerance);
    EXPECT_LE(followed.estimate, tolerance);
    EXPECT_LE(followed.steps, 150000 * 4e-4 / tolerance + 10000);
  }
}

/// The same with a reservoir that changes in time, of the rock.
TEST(SlowScenes, AReservoirThatChangesIsFollowed) {
  const std::string change = "boundary.left.solute.concentration.acid=[[0,50],[12,50],[12.1,10],[20,10],[22,50]]";
  const auto volume = resolved(wall, 30, 0.05, {change});
  const Followed followed = follow(wall, 30, 150, {"accuracy.dissolution_tolerance=2e-2", change},
                                   [&](double time) { return at(volume, time); });
  EXPECT_LE(followed.worst, 2e-2);
  EXPECT_LE(followed.steps, 60000);
}

/// A reservoir that comes and goes at once: each change is gone through at the pace of the fluid.
TEST(SlowScenes, AReservoirThatComesAndGoesIsFollowed) {
  std::string change = "boundary.left.solute.concentration.acid=[[0,50]";
  for (int second = 3; second < 30; second += 3)
    change += fmt::format(",[{},{}],[{}.01,{}]", second, second % 2 ? 50 : 0, second, second % 2 ? 0 : 50);
  change += "]";
  const auto volume = resolved(wall, 30, 0.05, {change});
  const Followed followed = follow(wall, 30, 150, {"accuracy.dissolution_tolerance=2e-2", change},
                                   [&](double time) { return at(volume, time); });
  EXPECT_LE(followed.worst, 2e-2);
  EXPECT_LE(followed.estimate, 2e-2);
  EXPECT_LE(followed.steps, 100000);  // of 150000
}

TEST(SlowScenes, AGrainShrinksByTheLawOfItsReactionForAnHour) {
  Simulation start(scene_of(disc));
  const double solid = now(start, "solid_volume_initial_m3_per_m"), radius = std::sqrt(solid / std::numbers::pi);
  const double speed = 1e-7 * 1000 * 4e-5;  // 4e-9 m/s: gone after 4000 s
  const auto exact = [&](double time) { return solid - std::numbers::pi * std::pow(radius - speed * time, 2); };
  for (const std::string precision : {"double", "single"}) {
    const Followed followed =
        follow(disc, 3600, 100, {"accuracy.dissolution_tolerance=1e-2", "accuracy.precision=" + precision}, exact);
    EXPECT_LE(followed.worst, 1e-2) << precision;
    EXPECT_LE(followed.steps, 18e6 / 100) << precision;  // of those that the hour has
  }
}

/// Two species, rock of two minerals, equilibrium, a chain of reactions: what has dissolved is what the acid has paid
/// for at every factor (follow), and what dissolves where every step is taken.
TEST(SlowScenes, MineralsAndAnEquilibriumKeepTheirLedgers) {
  const std::string dolomite = R"(
[[mineral]]
name = "dolomite"
rate_constant = 4e-7
molar_volume = 6.4e-5
[[mineral.shapes]]
type = "rectangle"
from = [0, 0]
to = [2.4e-5, 1e-5]
)";
  // a grain of which 2.4 of 8 um dissolve; salt in the fluid slows it by an eighth
  const std::vector<std::string> grain = {"lattice.size=[2.4e-5,2.4e-5]", "geometry.shapes.0.centre=[1.2e-5,1.2e-5]",
                                          "geometry.shapes.0.radius=8e-6", "reaction.rate_constant=2e-6"};
  auto reversible = grain;
  for (const char* more : {"reaction.product=salt", "reaction.equilibrium_constant=0.05",
                           "solute.species.1={ name = \"salt\", diffusivity = 1e-9, initial = 0 }"})
    reversible.emplace_back(more);
  // of a mole of acid a hundredth dissolves rock itself, the rest by way of the salt that it becomes
  auto chain = grain;
  for (const char* more : {"reaction.product=salt", "reaction.stoichiometry=100", "reaction.product_stoichiometry=100",
                           "reaction.further=[{ reactant = \"salt\", rate_constant = 2e-6 }]",
                           "solute.species.1={ name = \"salt\", diffusivity = 1e-9, initial = 0 }"})
    chain.emplace_back(more);
  for (const auto& [text, overrides] : {std::pair{disc + dolomite, grain}, {disc, reversible}, {disc, chain}}) {
    const auto volume = resolved(text, 30, 0.05, overrides);
    auto slow = overrides;
    slow.emplace_back("accuracy.dissolution_tolerance=2e-2");
    const Followed followed = follow(text, 30, 20, slow, [&](double time) { return at(volume, time); });
    EXPECT_LE(followed.worst, 2e-3);
    EXPECT_LE(followed.steps, 15000);  // of 150000
  }
}

/// What nobody can keep is said: acid that changes all the time.
TEST(SlowScenes, AToleranceThatCannotBeMetIsSaid) {
  const Scene scene = scene_of(wall, {"accuracy.dissolution_tolerance=1e-9", "accuracy.update_interval=100"});
  Simulation simulation(scene);
  simulation.begin();
  Events events(simulation);
  std::vector<std::string> news;
  for (int step = 0; step < 100000; ++step) simulation.step();
  for (const std::string& line : events.look(simulation)) news.push_back(line);
  EXPECT_THAT(news, Contains(HasSubstr("the rock aged no faster than the fluid")));
  EXPECT_EQ(now(simulation, "dissolution_factor_1"), 1);
  EXPECT_EQ(simulation.clock().ahead, 0);
}

/// When all rock is gone there is nothing to wait for.
TEST(SlowScenes, TimePassesWhenTheRockIsGone) {
  Simulation simulation(scene_of(disc, {"accuracy.dissolution_tolerance=5e-2", "time.end=86400"}));
  simulation.begin();
  age(simulation, 86400, 86400, [](double, double) {});
  EXPECT_LE(now(simulation, "solid_volume_stored_m3_per_m"), 1e-9 * now(simulation, "solid_volume_initial_m3_per_m"));
  EXPECT_LE(static_cast<double>(simulation.clock().step), 86400 / 2e-4 / 1000);
}

TEST(SlowScenes, GoOnWithTheSameBitsAfterARestartAtAnyStep) {
  const Scene scene = scene_of(wall, {"accuracy.dissolution_tolerance=5e-2"});
  Simulation whole(scene);
  whole.begin();
  const auto advance = [](Simulation& simulation, std::int64_t to) {
    while (simulation.clock().step < to) simulation.step();
  };
  for (const std::int64_t stop : {3333, 9090, 12345}) {
    advance(whole, stop);
    const test::State saved = test::state_of(whole);
    Simulation resumed(scene);
    test::restore(resumed, saved);
    EXPECT_EQ(now(resumed, "dissolved_volume_m3_per_m"), now(whole, "dissolved_volume_m3_per_m"));
    advance(resumed, stop + 2000);
    advance(whole, stop + 2000);
    EXPECT_GT(whole.clock().ahead, 0);
    EXPECT_TRUE(test::state_of(resumed) == test::state_of(whole)) << stop;
  }
  EXPECT_GT(now(whole, "nodes_dissolved_1"), 0);
}

}  // namespace
}  // namespace vug
