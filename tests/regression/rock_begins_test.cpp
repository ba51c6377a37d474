// How rock begins: what did not come to rest is told and recorded, what finds no rock is refused before anything is
// written.
#include "support/run_vug.hpp"

#include <gmock/gmock.h>

#include <filesystem>

namespace vug {
namespace {

using test::Outcome;
using test::run_vug;
using test::TemporaryFolder;
using testing::HasSubstr;
using testing::Not;

const std::string rock = R"([lattice]
size = [0.02, 0.01]
spacing = 1e-3
time_step = 1e-7
[time]
steps = 10
[geometry]
type = "rock"
[rock]
element_size = 2e-3
)";

TEST(RockBegins, AndSaysWhereItsPreloadDidNotComeToRest) {
  const TemporaryFolder folder;
  const std::string falls = folder / "falls.toml", stands = folder / "stands.toml";
  test::write_text(falls, rock + "[mechanics]\ngravity = [0.0, -9.81]\n");
  test::write_text(stands, rock +
                               "[mechanics]\ngravity = [0.0, -9.81]\npreload = \"dynamic\"\n[boundary.bottom]\n"
                               "traction = { support = \"fixed\" }\n");
  const std::string said = "step 0, 0 s: warning: the preload did not come to rest: after ";
  const Outcome run = run_vug("run --quiet " + falls + " --steps 5 -o " + (folder / "falls"));
  EXPECT_EQ(run.exit_code, 0) << run.output;
  EXPECT_THAT(run.output, HasSubstr(said));
  EXPECT_THAT(test::contents(folder / "falls/run.json"), HasSubstr(said));
  EXPECT_EQ(run_vug("run --quiet --resume " + falls + " -o " + (folder / "falls")).exit_code, 0);
  EXPECT_THAT(test::contents(folder / "falls/run.json"), HasSubstr(said)) << "still what happened to this run";
  const Outcome rests = run_vug("run --quiet " + stands + " -o " + (folder / "stands"));
  EXPECT_EQ(rests.exit_code, 0) << rests.output;
  EXPECT_THAT(rests.output, Not(HasSubstr("come to rest")));
}

/// A weak core in rock that is pulled: what breaks before the run is no event of the run.
TEST(RockBegins, AndSaysWhatItsPreloadHasBroken) {
  const TemporaryFolder folder;
  const std::string pulled = folder / "pulled.toml", out = folder / "out";
  test::write_text(pulled,
                   rock +
                       "[mechanics]\n[[mechanics.material]]\ntype = \"rectangle\"\nfrom = [0.008, 0.003]\nto = "
                       "[0.012, 0.007]\nbond = { normal_strength = 1e6, cohesion = 1e6, fracture_energy_I = 0.1, "
                       "fracture_energy_II = 0.1 }\n[boundary.left]\ntraction = { support = \"roller\" }\n"
                       "[boundary.bottom]\ntraction = { support = \"roller\" }\n[boundary.right]\ntraction = { "
                       "normal_stress = -5e6 }\n");
  const Outcome run = run_vug("run --quiet " + pulled + " -o " + out);
  EXPECT_EQ(run.exit_code, 0) << run.output;
  const std::string first = test::contents(out + "/history.csv");
  const auto said = testing::ContainsRegex(
      "step 0, 0 s: warning: [1-9][0-9]* bonds? failed and [0-9]+ (was|were) damaged in the preload, before the run");
  EXPECT_THAT(run.output, said);
  EXPECT_THAT(test::contents(out + "/run.json"), said);
  EXPECT_THAT(
      run_vug("run --quiet " + pulled + " --set boundary.right.traction.normal_stress=-1e5 -o " + (folder / "whole"))
          .output,
      Not(HasSubstr("in the preload")));
}

TEST(RockBegins, NotWithLoadsThatFindNoRock) {
  const TemporaryFolder folder;
  const std::string path = folder / "case.toml", out = folder / "out";
  test::write_text(path,
                   rock +
                       "holes = [{type = \"rectangle\", from = [0.005, 0.008], to = [0.015, 0.011]}]\n[mechanics]\n"
                       "[[boundary.top.traction.parts]]\nfrom = 0.006\nto = 0.014\nnormal_stress = 5e6\n");
  const Outcome run = run_vug("run --quiet " + path + " -o " + out);
  EXPECT_EQ(run.exit_code, 2) << run.output;
  EXPECT_THAT(run.output,
              HasSubstr("case.toml: boundary.top.traction.parts.0: the rock has no edge between its ends to "
                        "push; an edge is of a side when"));
  EXPECT_FALSE(std::filesystem::exists(out));
  EXPECT_EQ(run_vug("check " + path).exit_code, 2);
}

}  // namespace
}  // namespace vug
