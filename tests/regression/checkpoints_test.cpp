// When a run has a checkpoint, and who is told of it.
#include "support/channel_runs.hpp"

#include <gmock/gmock.h>

namespace vug {
namespace {

using test::Outcome;
using test::run_channel;
using test::run_vug;
using test::TemporaryFolder;
using testing::HasSubstr;
namespace fs = std::filesystem;

TEST(Checkpoints, AreThereAtTheEndWhateverTheIntervals) {
  const TemporaryFolder folder;
  const std::string odd = " --set accuracy.update_interval=1000000 --set output.interval_steps=1000";
  ASSERT_EQ(run_channel(folder / "out", "--steps 7" + odd).exit_code, 0);
  EXPECT_TRUE(fs::exists(folder / "out/checkpoint/step_000000000007.checkpoint"));
}

TEST(Checkpoints, FromWhichARunWasResumedAreNamedWhenItDiverges) {
  const TemporaryFolder folder;
  // a viscosity far below what the pressure allows, and no limiter to save it
  const std::string out = folder / "out",
                    wild = "run " + test::small_rock +
                           " --quiet --set flow.viscosity=2e-6 --set flow.speed_limit=0 --set flow.pressure_scale=1"
                           " --set accuracy.guard_interval=10 -o " +
                           out;
  ASSERT_EQ(run_vug(wild + " --steps 1").exit_code, 0);
  const Outcome diverged = run_vug(wild + " --resume");
  EXPECT_EQ(diverged.exit_code, 3) << diverged.output;
  EXPECT_THAT(diverged.output, HasSubstr("the last good state is the checkpoint of step 1 in " + out));
}

}  // namespace
}  // namespace vug
