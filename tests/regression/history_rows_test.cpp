// How often history.csv gets a row.
#include "support/run_vug.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace vug {
namespace {

const std::string channel = " run " VUG_SOURCE_DIR "/cases/poiseuille.toml --quiet -o ";

std::string history_of(const test::TemporaryFolder& folder, const std::string& options) {
  const test::Outcome outcome = test::run_vug(channel + (folder / "run") + options);
  EXPECT_EQ(outcome.exit_code, 0) << outcome.output;
  return test::contents(folder / "run/history.csv");
}

TEST(HistoryRows, AreAboutFourHundredUnlessStepsAreFew) {
  const test::TemporaryFolder folder;
  EXPECT_EQ(test::rows_in(history_of(folder, " --set time.steps=60000 --set output.interval_steps=60000")), 401);
  EXPECT_EQ(test::rows_in(history_of(folder, " --overwrite --set time.steps=2000 --set output.interval_steps=1000")),
            21);
  EXPECT_EQ(test::rows_in(history_of(folder, " --overwrite --set time.steps=50 --set output.interval_steps=25")), 3);
  EXPECT_EQ(test::rows_in(history_of(
                folder,
                " --overwrite --set time.steps=50 --set output.interval_steps=50 --set output.history_interval=0.01")),
            6);
}

TEST(HistoryRows, AreTheSameAfterAStop) {
  const test::TemporaryFolder folder;
  const std::string whole = history_of(folder, " --set time.steps=2000");
  history_of(folder, " --overwrite --set time.steps=2000 --steps 900");
  EXPECT_EQ(history_of(folder, " --resume --set time.steps=2000"), whole);
}

}  // namespace
}  // namespace vug
