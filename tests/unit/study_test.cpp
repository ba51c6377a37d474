// What a study asks for: combinations, samples, and one line where it is none.
#include "study/study.hpp"

#include "base/require.hpp"
#include "host/interruption.hpp"
#include "study/members.hpp"
#include "study/pool.hpp"
#include "support/temporary_folder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <csignal>
#include <set>

namespace vug {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

const std::string channel =
    std::filesystem::absolute(VUG_SOURCE_DIR "/cases/poiseuille.toml").lexically_normal().string();

Study study_of(const std::string& rest) {
  const test::TemporaryFolder folder;
  test::write_text(folder / "study.toml", "[study]\ncase = \"" + channel + "\"\n" + rest);
  return read_study(folder / "study.toml");
}

std::string refusal(const std::string& rest) {
  try {
    members_of(study_of(rest), "out");
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(Study, GridHasAllCombinationsTheLastKeyFastest) {
  const Study study = study_of(
      "[[study.keys]]\nkey = \"flow.viscosity\"\nvalues = [1e-6, \"2e-6\"]\n"
      "[[study.keys]]\nkey = \"time.steps\"\nfrom = 10\nto = 1000\ncount = 3\nscale = \"log\"\n");
  EXPECT_THAT(sample(study),
              ElementsAre(ElementsAre("1e-06", "10"), ElementsAre("1e-06", "100"), ElementsAre("1e-06", "1000"),
                          ElementsAre("'2e-6'", "10"), ElementsAre("'2e-6'", "100"), ElementsAre("'2e-6'", "1000")));
}

TEST(Study, ValuesMayBeTables) {
  const std::string sides =
      "sampling = \"list\"\n[[study.keys]]\nkey = \"boundary.top.flow\"\n"
      "values = [{ type = \"wall\" }, { type = \"wall\", velocity = [1e-3, 0] }]\n";
  EXPECT_THAT(sample(study_of(sides)),
              ElementsAre(ElementsAre("{ type = 'wall' }"), ElementsAre("{ type = 'wall', velocity = [ 0.001, 0 ] }")));
  EXPECT_EQ(refusal(sides), "accepted");
}

TEST(Study, ValuesMayBeTextOfSeveralLines) {
  const std::string name = "[[study.keys]]\nkey = \"case.description\"\nvalues = [\"one\\ntwo\"]\n";
  EXPECT_THAT(sample(study_of(name)), ElementsAre(ElementsAre("\"one\\ntwo\"")));
  EXPECT_EQ(refusal(name), "accepted");
}

TEST(Study, ListTakesTheValuesTogether) {
  const std::string keys =
      "[[study.keys]]\nkey = \"flow.viscosity\"\nvalues = [1e-6, 2e-6]\n[[study.keys]]\nkey = \"time.steps\"\nseeds = "
      "2\n";
  EXPECT_THAT(sample(study_of("sampling = \"list\"\n" + keys)),
              ElementsAre(ElementsAre("1e-06", "1"), ElementsAre("2e-06", "2")));
  EXPECT_THAT(refusal("sampling = \"list\"\n" + keys + "[[study.keys]]\nkey = \"case.name\"\nvalues = [\"a\"]\n"),
              HasSubstr("equally many values"));
}

// Of a Latin hypercube every one of n equal parts of every key's range holds one value.
TEST(Study, LatinHypercubeHasOneValueInEveryPart) {
  const Study study = study_of(
      "sampling = \"latin_hypercube\"\nsamples = 50\nseed = 3\n"
      "[[study.keys]]\nkey = \"flow.viscosity\"\nfrom = 1e-7\nto = 1e-5\nscale = \"log\"\n"
      "[[study.keys]]\nkey = \"flow.density\"\nfrom = 900\nto = 1100\n");
  const auto runs = sample(study);
  ASSERT_EQ(runs.size(), 50u);
  std::set<int> viscosities, densities;
  for (const auto& run : runs) {
    viscosities.insert(static_cast<int>(50 * std::log(std::stod(run[0]) / 1e-7) / std::log(100)));
    densities.insert(static_cast<int>(50 * (std::stod(run[1]) - 900) / 200));
  }
  EXPECT_EQ(viscosities.size(), 50u);
  EXPECT_EQ(densities.size(), 50u);
  EXPECT_EQ(*densities.begin(), 0);
  EXPECT_EQ(*densities.rbegin(), 49);
  EXPECT_EQ(sample(study), runs);
}

TEST(Study, LatinHypercubeTellsTheValuesOfANarrowRangeApart) {
  const auto runs =
      sample(study_of("sampling = \"latin_hypercube\"\nsamples = 5\n[[study.keys]]\nkey = "
                      "\"boundary.left.flow.pressure\"\nfrom = 100000.0002\nto = 100000.0010\n"));
  std::set<int> parts;
  for (const auto& run : runs) parts.insert(static_cast<int>(5 * (std::stod(run[0]) - 100000.0002) / 0.0008));
  EXPECT_THAT(parts, ElementsAre(0, 1, 2, 3, 4));
}

TEST(Study, ACaseIsSentToTheCommandThatRunsIt) {
  try {
    read_study(channel);
    ADD_FAILURE() << "accepted";
  } catch (const InputError& error) {
    EXPECT_EQ(error.what(),
              channel + ": is a case, which `vug run` runs; a study has a table [study] that names its case");
  }
}

TEST(Study, SaysInOneLineWhatIsWrong) {
  const std::string key = "[[study.keys]]\nkey = \"flow.viscosity\"\n";
  EXPECT_THAT(refusal(""), HasSubstr("study.keys is missing"));
  EXPECT_THAT(refusal(key), HasSubstr("give one of values, seeds, and from with to"));
  EXPECT_THAT(refusal(key + "from = 1\n"), HasSubstr("study.keys.0.to is missing"));
  EXPECT_THAT(refusal(key + "from = 1\nto = 2\n"), HasSubstr("study.keys.0.count is missing"));
  EXPECT_THAT(refusal(key + "valves = [1]\n"), HasSubstr("valves is not a key of a study; did you mean \"values\"?"));
  EXPECT_THAT(refusal("sampling = \"latin_hypercube\"\n" + key + "from = 1\nto = 2\n"),
              HasSubstr("study.samples is missing"));
  EXPECT_THAT(refusal(key + "values = [1e-6, -1]\n"),
              ::testing::AllOf(HasSubstr("run 0002"), HasSubstr("flow.viscosity")));
  EXPECT_THAT(refusal("[[study.keys]]\nkey = \"case.name\"\nvalues = [\"a\", 2026-11-30]\n"),
              HasSubstr("holds a date, which no key of a case is"));
  EXPECT_THAT(refusal("[[study.keys]]\nkey = \"flow.viscositty\"\nvalues = [1]\n"), HasSubstr("did you mean"));
  EXPECT_EQ(refusal(key + "values = [1e-6]\n"), "accepted");
  EXPECT_THAT(
      refusal(key + "values = [1e-6]\n" + key + "values = [2e-6]\n"),
      HasSubstr("study.keys.1.key = \"flow.viscosity\" sets what study.keys.0.key = \"flow.viscosity\" has set"));
  const std::string side = "[[study.keys]]\nkey = \"boundary.left.flow\"\nvalues = [1]\n";
  EXPECT_THAT(refusal("[[study.keys]]\nkey = \"boundary.left.flow.pressure\"\nvalues = [1]\n" + side),
              HasSubstr("study.keys.1.key = \"boundary.left.flow\" sets what"));
  EXPECT_THAT(refusal("[[study.keys]]\nkey = \"heat\"\nvalues = [1]\n"), HasSubstr("must be a key of the case"));
}

TEST(Pool, SaysInTheLogWhyAProgramCannotBeRun) {
  const test::TemporaryFolder folder;
  const std::string nothing = folder / "nothing", log = folder / "a.log";
  int code = 0;
  run_jobs({{{nothing}, log}, {{"/bin/true", std::string(1 << 18, 'x')}, folder / "b.log"}}, 1,
           [&](const Ended& ended) { code += ended.code; });
  EXPECT_EQ(code, 2 * 127);
  EXPECT_EQ(test::contents(log), nothing + ": cannot be run: No such file or directory\n");
  EXPECT_EQ(test::contents(folder / "b.log"), "/bin/true: cannot be run: Argument list too long\n");
}

/// A stop may come while a process is no program yet and has the handlers of this one.
TEST(Pool, StopsJobsThatHaveJustBegun) {
  const test::TemporaryFolder folder;
  std::signal(SIGTERM, [](int) {});  // notes it and goes on, like that of vug
  for (int attempt = 0; attempt < 5; ++attempt) {
    int code = 0;
    run_jobs(
        {{{"/bin/sleep", "10"}, folder / "a.log"}}, 1, [&](const Ended& ended) { code = ended.code; },
        [](std::size_t) {
          request_stop(SIGTERM);
          return true;
        });
    EXPECT_EQ(code, 128 + SIGTERM);
    request_stop(0);
  }
  std::signal(SIGTERM, SIG_DFL);
}

}  // namespace
}  // namespace vug
