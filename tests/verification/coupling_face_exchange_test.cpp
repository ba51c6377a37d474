// Acid that flows between reacting discs: what the advective form creates, and that neighbours who exchange it keep it.
#include "support/coupled_run.hpp"
#include "support/record.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace vug {
namespace {

/// Three discs of four cells radius between walls.
const std::string discs = R"(
[lattice]
size = [9.6e-4, 4e-4]
spacing = 1e-5
time_step = 1e-5
[time]
steps = 100000
[geometry]
type = "shapes"
[[geometry.shapes]]
type = "disc"
centre = [2.5e-4, 1.3e-4]
radius = 4e-5
[[geometry.shapes]]
type = "disc"
centre = [4.2e-4, 2.8e-4]
radius = 4e-5
[[geometry.shapes]]
type = "disc"
centre = [6.1e-4, 1.55e-4]
radius = 4e-5
[flow]
density = 1000
viscosity = 1.6666666666666667e-6
[solute]
[[solute.species]]
name = "acid"
diffusivity = 1e-7
[reaction]
reactant = "acid"
rate_constant = 0.5
molar_volume = 1e-14
)";
const std::string through = R"(
[boundary.left]
flow = { type = "velocity", velocity = [0.012, 0] }
solute = { type = "concentration", concentration = { acid = 1000 } }
[boundary.right]
flow = { type = "pressure", pressure = 1e5 }
solute = { type = "outflow" }
)";
const std::string joined = R"(
[boundary.left]
flow = { type = "periodic" }
solute = { type = "periodic" }
[boundary.right]
flow = { type = "periodic" }
solute = { type = "periodic" }
)";

constexpr int settled = 16000, measured = 1000;  // steps: twice the way through

struct Share {
  double created, reacted;
  double peclet;  ///< u_max h/D
  double of_reaction() const { return created / reacted; }
};

/// What the advective form creates, over the reaction, once all is steady.
Share created(const std::vector<std::string>& choices) {
  test::CoupledRun run(discs + through, choices);
  run.steps(settled);
  const double before = run.gain("acid", "advective_form"), rate = run.gain("acid", "reaction");
  run.steps(measured);
  EXPECT_LT(run.worst_balance(), 1e-11);
  const double u = run.now("largest_mach_1") / std::sqrt(3.0);  // cells per step
  const auto& lattice = run.scene().lattice;
  const double D = run.scene().solute->species[0].diffusivity * lattice.time_step / (lattice.spacing * lattice.spacing);
  return {run.gain("acid", "advective_form") - before, rate - run.gain("acid", "reaction"), u / D};
}

TEST(FaceExchange, KeepsWhatTheAdvectiveFormCreates) {
  for (const double diffusivity : {2e-7, 2e-8}) {
    const std::string D = "solute.species.0.diffusivity=" + std::to_string(diffusivity * 1e6) + "e-6";
    const Share without = created({D}), with = created({D, "solute.face_exchange=true"});
    std::printf("    u h/D %.2g: %.2e of the reaction created, exchanged at faces %.2e; reaction %.2e more\n",
                with.peclet, without.of_reaction(), with.of_reaction(), with.reacted / without.reacted - 1);
    test::record("face_exchange", {{"peclet", with.peclet},
                                   {"without", without.of_reaction()},
                                   {"with", with.of_reaction()},
                                   {"reaction", with.reacted / without.reacted - 1}});
    EXPECT_GT(std::abs(without.of_reaction()), 1e-3);
    EXPECT_LT(std::abs(with.of_reaction()), 1e-4);
  }
}

/// How far acid that does not react is from uniform once the fluid has been set in motion and waves of pressure pass.
double spread(const std::vector<std::string>& choices) {
  std::vector<std::string> all = {"solute.species.0.initial=1000", "reaction.rate_constant=0",
                                  "flow.body_force=[5, 0]"};
  all.insert(all.end(), choices.begin(), choices.end());
  test::CoupledRun run(discs + joined, all);
  run.steps(3000);
  EXPECT_GT(run.now("largest_mach_1"), 0.02);
  double least = 1000, most = 1000;
  for (const double value : run.nodes("concentration_acid")) {
    if (!(value > 0)) continue;  // rock
    least = std::min(least, value);
    most = std::max(most, value);
  }
  return most - least;
}

TEST(FaceExchange, LeavesWhatIsUniform) {
  const double without = spread({}), with = spread({"solute.face_exchange=true"});
  std::printf("    spread of 1000 mol/m3: %.1e, with the exchange %.1e, conserving %.1e\n", without, with,
              spread({"solute.advective_form=false"}));
  EXPECT_LT(with, 1.01 * without);
  EXPECT_LT(with, 1e-2);
}

}  // namespace
}  // namespace vug
