// What a run reports about a state that cannot be, although it goes on; and that what can be is not called divergence.
#include "coupling/concerns.hpp"

#include "coupling/events.hpp"
#include "coupling/simulation.hpp"
#include "kernels/base/require.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <random>
#include <string>
#include <vector>

namespace vug {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

using Overrides = std::vector<std::string>;

/// Seven cells of fluid on three of rock, which acid dissolves.
const std::string slab = R"(
[lattice]
size = [20e-6, 10e-6]
spacing = 1e-6
time_step = 1e-4
[time]
steps = 5000
[geometry]
type = "shapes"
[[geometry.shapes]]
type = "rectangle"
from = [0, 0]
to = [20e-6, 3e-6]
[solute]
[[solute.species]]
name = "H"
diffusivity = 1e-9
initial = 3000
[reaction]
reactant = "H"
rate_constant = 1e-4
molar_volume = 4e-5
[boundary.top]
solute = { type = "concentration", concentration = { H = 3000 } }
)";

/// A run with the events that it reports at its guards.
class Watched {
 public:
  explicit Watched(const std::string& text, const Overrides& overrides = {})
      : scene_(parse_scene(text, "case.toml", overrides)), simulation_(scene_) {
    simulation_.begin();
    events_.emplace(simulation_, Overrides{}, Events::runs_backwards(scene_));
  }
  /// New events after so many steps, with a guard every hundred.
  std::vector<std::string> steps(int count) {
    std::vector<std::string> news;
    for (int step = 1; step <= count; ++step) {
      simulation_.step();
      if (step % 100 != 0 && step != count) continue;
      simulation_.guard();
      for (const std::string& line : events_->look(simulation_))
        if (line.find("warning: ") != std::string::npos) news.push_back(line);
    }
    return news;
  }
  /// So many steps without a look at events.
  void pass(int count) {
    for (int step = 0; step < count; ++step) simulation_.step();
  }
  std::vector<std::string> row() { return events_->look_at_row(simulation_, simulation_.history()); }
  const Simulation& simulation() const { return simulation_; }
  double most(const std::string& field, std::size_t nodes) const {
    for (const Field& given : simulation_.fields().lattice) {
      if (given.name != field) continue;
      std::vector<double> values(nodes);
      given.read(values);
      return *std::max_element(values.begin(), values.end());
    }
    return 0;
  }

 private:
  Scene scene_;
  Simulation simulation_;
  std::optional<Events> events_;
};

TEST(Concerns, RockThatIsNotThereIsReportedOnce) {
  for (const char* interval : {"10", "2000", "1000000"}) {  // the last: no look in the whole run
    Watched run(slab, {std::string("accuracy.update_interval=") + interval});
    const std::vector<std::string> news = run.steps(5000);
    if (std::string(interval) == "10") {
      EXPECT_THAT(news, IsEmpty());
      continue;
    }
    ASSERT_THAT(news, ElementsAre(AllOf(HasSubstr("warning: a wall node has lost more rock between two looks"),
                                        HasSubstr("lower accuracy.update_interval"))))
        << interval;
    Events resumed(run.simulation(), news);
    EXPECT_THAT(resumed.look(run.simulation()), IsEmpty());
  }
}

/// What was lost before the last look is remembered.
TEST(Concerns, RockThatWasNotThereIsReportedAfterTheLook) {
  Watched run(slab, {"accuracy.update_interval=3000"});
  run.pass(3000);
  EXPECT_THAT(run.steps(1), ElementsAre(HasSubstr("a wall node has lost more rock")));
}

TEST(Concerns, FluxesThatDrawMoreThanThereIs) {
  Watched heat(R"(
[lattice]
size = [20e-3, 10e-3]
spacing = 1e-3
time_step = 1
[time]
steps = 2000
[heat]
fluid_diffusivity = 1.4e-7
solid_diffusivity = 1e-6
[boundary.top]
heat = { type = "flux", flux = -1e4 }
)");
  EXPECT_THAT(heat.steps(300), IsEmpty());
  EXPECT_THAT(heat.steps(1700), ElementsAre(AllOf(HasSubstr("warning: temperatures below 0 K (down to -"),
                                                  HasSubstr("boundary.top.heat.flux draws more heat than there is"))));

  Watched acid(slab, {"solute.species.0.initial=10", "reaction.rate_constant=1e-5",
                      "boundary.top.solute={ type = \"flux\", flux = { H = -1e-2 } }"});
  EXPECT_THAT(acid.steps(2000), ElementsAre(AllOf(HasSubstr("warning: negative concentrations of H (down to -"),
                                                  HasSubstr("boundary.top.solute.flux.H draws more than there is"))));
  EXPECT_THAT(acid.row(), ElementsAre(AllOf(HasSubstr("rock has grown on the whole, by negative concentrations"),
                                            Not(HasSubstr("backwards")))));
}

TEST(Concerns, VelocitiesThatDrawFasterThanThePressureDrives) {
  const std::string channel = R"(
[lattice]
size = [20e-6, 10e-6]
spacing = 1e-6
time_step = 1e-7
[time]
steps = 400
[flow]
initial_pressure = 0
viscosity = 1e-6
[boundary.left]
flow = { type = "velocity", velocity = [-0.1, 0] }
[boundary.right]
flow = { type = "pressure", pressure = 0 }
)";
  EXPECT_THAT(Watched(channel).steps(400), ElementsAre(AllOf(HasSubstr("warning: absolute pressures below 0"),
                                                             HasSubstr("boundary.left draws faster"))));
  EXPECT_THAT(Watched(channel, {"flow.initial_pressure=1e5", "boundary.right.flow.pressure=1e5"}).steps(400),
              IsEmpty());
  EXPECT_THAT(Watched(channel, {"boundary.left.flow.velocity=[0.1, 0]"}).steps(400), IsEmpty());
}

/// J = D C/(L + D/k) of acid comes, and the product leaves as slowly as it diffuses: C_P = J y L/D_P at the wall.
TEST(Guard, LetsAProductBecomeAsDenseAsItIsSlow) {
  const std::string product = "solute.species.1={ name = \"P\", diffusivity = 2e-12 }";
  const Overrides common = {"solute.species.0.initial=0", "boundary.top.solute.concentration.H=1",
                            "reaction.rate_constant=1e-3", "reaction.product=P", "reaction.molar_volume=0"};
  const auto with = [&](Overrides more) {
    more.insert(more.begin(), common.begin(), common.end());
    return more;
  };
  Watched slow(slab, with({product, "lattice.time_step=5e-4", "time.steps=4000"}));
  EXPECT_THAT(slow.steps(4000), IsEmpty());
  EXPECT_GT(slow.most("concentration_P", 200), 100);
  Watched many(slab, with({"solute.species.1={ name = \"P\", diffusivity = 1e-9 }", "reaction.stoichiometry=0.01",
                           "reaction.product_stoichiometry=10"}));
  EXPECT_THAT(many.steps(3000), IsEmpty());
  EXPECT_NEAR(many.most("concentration_P", 200) / 875, 1, 0.08);  // at the first node, half a cell from the wall
}

/// A closed box that is filled for ever: no divergence, but a warning.
TEST(Guard, LetsFluxesFillAClosedBox) {
  const std::string box = "[lattice]\nsize = [3, 3]\nspacing = 1\ntime_step = 1\n[time]\nsteps = 1000000\n";
  std::string solute = box + "[[solute.species]]\nname = \"A\"\ndiffusivity = 1\n",
              heat = box + "[heat]\nfluid_diffusivity = 0.2\nsolid_diffusivity = 0.2\n";
  for (const char* side : {"left", "right", "bottom", "top"}) {
    solute += std::string("[boundary.") + side + "]\nsolute = { type = \"flux\", flux = { A = 1 } }\n";
    heat += std::string("[boundary.") + side + "]\nheat = { type = \"flux\", flux = 4e7 }\n";  // 40/3 K per step
  }
  EXPECT_THAT(Watched(heat).steps(20000),
              ElementsAre(AllOf(HasSubstr("warning: temperatures more than 100000 K above"),
                                HasSubstr("boundary.left.heat.flux puts in more heat than leaves"))));
  EXPECT_THAT(Watched(solute).steps(250000),
              ElementsAre(AllOf(HasSubstr("warning: concentrations of A above 300000 mol/m3"),
                                HasSubstr("boundary.left.solute.flux.A puts in more than leaves"))));
}

/// The paper's wall at a small diffusivity on D2Q9 (docs/stability.md). Without flow there is no velocity to lower.
TEST(Guard, AdvisesOnWhatThereIs) {
  std::string pores = R"(
[lattice]
size = [40, 30]
spacing = 1
time_step = 1
[time]
steps = 100000
[solute]
velocity_set = "d2q9"
relaxation_time = 0.649
[[solute.species]]
name = "H"
diffusivity = 0.003
[reaction]
reactant = "H"
rate_constant = 3e-9
molar_volume = 0
wall = "paper"
surface_normal = false
[boundary.left]
solute = { type = "concentration", concentration = { H = 1 } }
[geometry]
type = "shapes"
)";
  std::mt19937 random(3);
  for (int n = 0; n < 40 * 30; ++n)
    if (random() % 3 == 0)
      pores += fmt::format("[[geometry.shapes]]\ntype = \"rectangle\"\nfrom = [{}, {}]\nto = [{}, {}]\n", n % 40,
                           n / 40, n % 40 + 1, n / 40 + 1);
  Watched run(pores);
  try {
    run.steps(20000);
    FAIL();
  } catch (const StabilityError& error) {
    EXPECT_THAT(error.what(), AllOf(HasSubstr("solute H diverged"), HasSubstr("; lower lattice.time_step"),
                                    Not(HasSubstr("velocity")), Not(HasSubstr("raise"))));
  }
}

TEST(SubSteps, MoreThanAMillionAreRefused) {
  const std::string rock = R"(
[lattice]
size = [0.02, 0.02]
spacing = 0.5e-3
time_step = 100
[time]
steps = 20
[geometry]
type = "rock"
[rock]
element_size = 4e-3
[mechanics]
mass_scaling = 1
)";
  try {
    const Simulation simulation(parse_scene(rock, "case.toml", {}));
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), AllOf(HasSubstr("case.toml: lattice.time_step = 100 s needs 1.5"),
                                    HasSubstr("mechanical steps of"), HasSubstr("at most 1e+06")));
  }
  EXPECT_NO_THROW(Simulation(parse_scene(rock, "case.toml", {"lattice.time_step=0.05"})));
}

}  // namespace
}  // namespace vug
