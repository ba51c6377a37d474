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
