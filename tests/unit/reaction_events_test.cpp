// What a run tells of its reaction: rock that grows, acid that breaks through.
#include "coupling/events.hpp"
#include "support/acid_column.hpp"
#include "support/coupled_run.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <string>
#include <vector>

namespace vug {
namespace {

using test::acid_column;

/// Product in excess makes the reaction run backwards: rock grows where it is, which is told once, also after a
/// restart.
TEST(ReactionInSI, RockThatGrowsInPlaceIsToldOnce) {
  for (const double salt : {6000.0, 1000.0}) {
    Simulation simulation(
        parse_scene(acid_column, "case.toml",
                    {"reaction.product=salt", "reaction.equilibrium_constant=1", "reaction.molar_volume=1e-5",
                     fmt::format("solute.species.1={{ name = \"salt\", diffusivity = 5e-4, initial = {} }}", salt)}));
    simulation.begin();
    Events events(simulation);
    for (int step = 0; step < 100; ++step) simulation.step();
    const std::vector<std::string> news = events.look_at_row(simulation, simulation.history());
    if (salt < 2000) {
      EXPECT_TRUE(news.empty());
      continue;
    }
    ASSERT_EQ(news.size(), 1u);
    EXPECT_THAT(news[0], testing::HasSubstr("warning: rock has grown on the whole"));
    EXPECT_TRUE(events.look_at_row(simulation, simulation.history()).empty());
    EXPECT_TRUE(Events(simulation, news).look_at_row(simulation, simulation.history()).empty());
  }
}

/// What came in and what has left, through sides or openings, in any of the two ways; told once.
TEST(ReactionInSI, BreakthroughIsToldOfSidesAndOpenings) {
  Simulation simulation(parse_scene(acid_column, "case.toml", {}));
  simulation.begin();
  for (const std::string in : {"injected", "shape_well"})
    for (const std::string out : {"outflow", "shape_drain"}) {
      Events events(simulation);
      const auto row = [&](double left) {
        return std::vector<HistoryValue>{{"acid_gain_" + in + "_mol_per_m", 2},
                                         {"acid_gain_" + out + "_mol_per_m", -left},
                                         {"acid_gain_reaction_mol_per_m", -1},
                                         {"salt_gain_" + out + "_mol_per_m", -1}};
      };
      EXPECT_TRUE(events.look_at_row(simulation, row(0.019)).empty());
      EXPECT_THAT(
          events.look_at_row(simulation, row(0.021)),
          testing::ElementsAre(testing::HasSubstr("breakthrough of acid: 1.1 % of what was injected has left")));
      EXPECT_TRUE(events.look_at_row(simulation, row(0.1)).empty());
    }
}

/// A trace of the product enters where its concentration is given as 0: it is not what has left.
TEST(ReactionInSI, AProductOfWhichATraceEntersHasNoBreakthrough) {
  Simulation simulation(parse_scene(acid_column, "case.toml", {}));
  simulation.begin();
  Events events(simulation);
  EXPECT_TRUE(events
                  .look_at_row(simulation, {{"salt_gain_reaction_mol_per_m", 1},
                                            {"salt_gain_injected_mol_per_m", 1e-6},
                                            {"salt_gain_outflow_mol_per_m", -1e-7}})
                  .empty());
}

/// What was there from the start leaves first; a trace of it does not matter.
TEST(ReactionInSI, ASpeciesThatWasThereHasNoBreakthrough) {
  Simulation simulation(parse_scene(acid_column, "case.toml", {}));
  simulation.begin();
  for (const double at_start : {5.0, 1e-3}) {
    const std::vector<std::string> news = Events(simulation)
                                              .look_at_row(simulation, {{"acid_stored_mol_per_m", at_start + 1},
                                                                        {"acid_gain_injected_mol_per_m", 2},
                                                                        {"acid_gain_outflow_mol_per_m", -1}});
    EXPECT_EQ(news.empty(), at_start > 1) << at_start;
  }
}

}  // namespace
}  // namespace vug
