// What a run reports about a state that cannot be, although it goes on; and that what can be is not called divergence.
#include "coupling/concerns.hpp"

#include "base/require.hpp"
#include "support/watched.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>
#include <string>
#include <vector>

namespace vug {
namespace {

using test::Watched;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

using Overrides = std::vector<std::string>;

const std::string& slab = test::slab_in_acid;

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

/// A bar of rock that a flux heats from above: alpha dT is the strain. The case names no temperature but that at the
/// start.
TEST(Concerns, ThermalStrainThatNoTemperatureOfTheCaseHas) {
  const std::string bar = R"(
[lattice]
size = [20e-3, 10e-3]
spacing = 1e-3
time_step = 1e-4
[time]
steps = 2000
[geometry]
type = "rock"
[rock]
element_size = 4e-3
[heat]
fluid_diffusivity = 1e-5
solid_diffusivity = 1e-3
initial_temperature = 300
[mechanics]
thermal_expansion = 1e-4
mass_scaling = 1e6
bond = { normal_strength = 1e13, cohesion = 1e13 }
[boundary.bottom.traction]
support = "roller"
[boundary.top]
heat = { type = "flux", flux = 1e8 }
)";
  Watched heated(bar);
  std::vector<std::string> news;
  double warmest = 0;
  for (int looks = 0; looks < 20; ++looks) {
    news = heated.steps(100);
    warmest = heated.now("largest_temperature_change_K");
    if (!news.empty()) break;
    EXPECT_LT(1e-4 * warmest, 0.03) << looks;
  }
  EXPECT_THAT(news,
              ElementsAre(AllOf(HasSubstr("warning: thermal strain above 0.02 (0.02"), HasSubstr("heat fluxes"))));
  EXPECT_GT(1e-4 * warmest, 0.02);
  EXPECT_THAT(heated.steps(200), IsEmpty()) << "once";
  EXPECT_THAT(Watched(bar, {"mechanics.thermal_expansion=1e-6"}).steps(2000), IsEmpty());
  // where the case names temperatures as far apart, `vug check` has said so
  EXPECT_THAT(Watched(bar, {"boundary.bottom.heat={ type = \"temperature\", temperature = 550 }"}).steps(2000),
              IsEmpty());
}

/// A flux heats a wall beyond the range of Arrhenius' law.
TEST(Concerns, RatesThatAreThoseOfTheEndOfTheirRange) {
  const std::string heated = slab + R"(
[heat]
fluid_diffusivity = 1e-9
solid_diffusivity = 1e-9
initial_temperature = 590
[boundary.bottom]
heat = { type = "flux", flux = 1e4 }
)";
  const Overrides activated{"reaction.activation_energy=6e4", "reaction.reference_temperature=590"};
  Watched hot(heated, activated);
  std::vector<std::string> news;
  double hottest = 0;  // of all rock, before: the flux is on the far side
  while (news.empty() && hot.now("time_s") < 1) {
    hottest = 590 + hot.now("largest_temperature_change_K");
    news = hot.steps(100);
  }
  EXPECT_GT(hottest, 604);
  EXPECT_THAT(news, ElementsAre(HasSubstr("warning: a wall reacts that is hotter than 600 K (6")));
  EXPECT_THAT(Watched(heated).steps(2000), IsEmpty()) << "a rate that does not depend on the temperature";
}

/// The key of an injection is not its name in the columns of the history.
TEST(Concerns, NameTheKeysOfTheCase) {
  const std::string injection =
      "[[boundary.injection]]\nname = \"gate\"\nside = \"left\"\ncentre = 7e-6\nwidth = 4e-6\n"
      "solute = { type = \"flux\", flux = { H = 0 } }\n"
      "[[boundary.injection]]\nname = \"acid\"\nside = \"right\"\ncentre = 7e-6\nwidth = 4e-6\n"
      "solute = { type = \"flux\", flux = { H = -1e-2 } }\n";
  Watched drawn(slab + injection, {"solute.species.0.initial=10", "boundary.top.solute={ type = \"no_flux\" }",
                                   "reaction.molar_volume=0"});
  EXPECT_THAT(drawn.steps(2000), ElementsAre(HasSubstr(": boundary.injection.1.solute.flux.H draws more")));
}

/// What is said of H2 says nothing of H.
TEST(Concerns, AreToldOfEachSpeciesAlsoAfterTheOther) {
  const std::string told = "step 100, 1 s: warning: negative concentrations of H2 (down to -5 mol/m3): x draws more";
  Watched drawn(slab, {"solute.species.0.initial=10", "reaction.molar_volume=0",
                       "boundary.top.solute={ type = \"flux\", flux = { H = -1e-2 } }"});
  drawn.pass(2000);
  EXPECT_THAT(Events(drawn.simulation(), {told}).look(drawn.simulation()),
              ElementsAre(HasSubstr("concentrations of H (")));
  std::string same = told;
  same.erase(same.find("H2") + 1, 1);
  EXPECT_THAT(Events(drawn.simulation(), {same}).look(drawn.simulation()), IsEmpty());
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
