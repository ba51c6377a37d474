// A run that is asked to stop does so within a step, wherever it is, with its state in a checkpoint and the truth in
// run.json.
#include "support/background_vug.hpp"

#include <gmock/gmock.h>

namespace vug {
namespace {

using test::BackgroundVug;
using test::run_command;
using test::run_vug;
using test::small_rock;
using test::TemporaryFolder;
using testing::HasSubstr;

constexpr double promised = 1;             // s
constexpr double patience = promised + 4;  // of a busy machine
const std::map<int, std::string> names{
    {SIGINT, "SIGINT"}, {SIGTERM, "SIGTERM"}, {SIGHUP, "SIGHUP"}, {SIGXCPU, "SIGXCPU"}, {SIGUSR1, "SIGUSR1"}};

/// Sends the signal, waits, and expects an exit in good order; returns what run.json says.
std::string expect_stopped(BackgroundVug& vug, int signal, const std::string& folder) {
  const auto start = test::Clock::now();
  vug.signal(signal);
  EXPECT_EQ(vug.wait(), 130) << vug.log();
  EXPECT_LT(test::seconds_since(start), patience);
  EXPECT_THAT(vug.log(), HasSubstr("interrupted by " + names.at(signal)));
  const std::string record = test::contents(folder + "/run.json");
  EXPECT_THAT(record, HasSubstr("\"status\": \"interrupted\""));
  EXPECT_THAT(record, HasSubstr("interrupted by " + names.at(signal)));
  EXPECT_THAT(record, HasSubstr("\"exit_code\": 130"));
  return record;
}

class Signal : public testing::TestWithParam<int> {};

/// Pores are looked at every million steps: a state can be kept in between.
TEST_P(Signal, StopsARunWithACheckpointFromWhichItGoesOnWithTheSameBits) {
  const TemporaryFolder folder;
  const std::string common = "run " + small_rock +
                             " --quiet --threads 1 --set accuracy.update_interval=1000000"
                             " --set mechanics.bond.normal_strength=15e6 --set mechanics.bond.cohesion=95e6 -o ";
  const std::string out = folder / "out";
  BackgroundVug vug(common + out, folder / "log");
  ASSERT_TRUE(vug.wait_for_file(out + "/fields/step_000000000000.h5")) << vug.log();
  const std::string record = expect_stopped(vug, GetParam(), out);
  EXPECT_THAT(record, HasSubstr("the last good state is the checkpoint of step"));
  ASSERT_EQ(run_vug(common + out + " --resume").exit_code, 0);
  ASSERT_EQ(run_vug(common + (folder / "whole")).exit_code, 0);
  EXPECT_EQ(test::difference(folder / "whole", out), "");
}

INSTANTIATE_TEST_SUITE_P(All, Signal, testing::Values(SIGINT, SIGTERM, SIGHUP, SIGXCPU, SIGUSR1));

TEST(Signals, StopAPreloadWhichIsBegunAgain) {
  const TemporaryFolder folder;
  const std::string out = folder / "out",
                    endless = " --set mechanics.preload=dynamic --set mechanics.preload_time=1000 -o " + out;
  BackgroundVug vug("run " + small_rock + " --quiet --threads 1" + endless, folder / "log");
  ASSERT_TRUE(vug.wait_for_file(out + "/fields.xdmf")) << vug.log();
  EXPECT_THAT(expect_stopped(vug, SIGTERM, out), HasSubstr("there is no checkpoint yet"));
  BackgroundVug again("run " + small_rock + " --threads 1 --resume" + endless, folder / "log");
  EXPECT_TRUE(
      again.wait_for([&] { return again.log().find("has no checkpoint to continue from") != std::string::npos; }));
  expect_stopped(again, SIGINT, out);
}

/// Whether a process has become vug and a signal is in one of its masks (proc(5): SigCgt, SigIgn).
bool has_in(const std::string& mask, pid_t pid, int signal) {
  const std::string process = "/proc/" + std::to_string(pid), status = test::contents(process + "/status");
  const auto at = status.find(mask + ":\t");
  return test::contents(process + "/comm") == "vug\n" && at != std::string::npos &&
         (std::stoull(status.substr(at + mask.size() + 2), nullptr, 16) >> (signal - 1) & 1) != 0;
}

/// Whether it listens to a signal; threads alone make it catch others.
bool catches(pid_t pid, int signal) {
  return has_in("SigCgt", pid, signal);
}

TEST(Signals, StopASetUpBeforeAnythingIsWritten) {
  const TemporaryFolder folder;
  const std::string out = folder / "out", large = VUG_SOURCE_DIR "/cases/quickstart.toml --threads 1";
  for (const std::string& command : {"run " + large + " -o " + out, "check " + large}) {
    BackgroundVug vug(command, folder / "log");
    ASSERT_TRUE(vug.wait_for([&] { return catches(vug.pid(), SIGTERM); }));
    std::this_thread::sleep_for(std::chrono::milliseconds(60));
    const auto start = test::Clock::now();
    vug.signal(SIGTERM);
    const int code = vug.wait();
    EXPECT_EQ(code, 130) << vug.log();
    EXPECT_LT(test::seconds_since(start), patience);
    EXPECT_EQ(vug.log(), "vug: interrupted before anything was written\n");
    EXPECT_FALSE(std::filesystem::exists(out));
  }
}

/// The set-up of a twin is as long as that of a run, and nothing that was written is lost.
TEST(Signals, BetweenARunAndItsErrorBarsSayThatTheRunIsDone) {
  const TemporaryFolder folder;
  const std::string out = folder / "out", command = "run " VUG_SOURCE_DIR
                                                    "/cases/tutorial/fracture.toml --quiet --threads 1 --steps 2 -o " +
                                                    out + " --error-bars";
  BackgroundVug vug(command, folder / "log");
  ASSERT_TRUE(vug.wait_for([&] {
    return test::contents(out + "/run.json").find("\"status\": \"done\"") != std::string::npos;
  })) << vug.log();
  std::this_thread::sleep_for(std::chrono::milliseconds(10));  // out of the run's last lines
  vug.signal(SIGTERM);
  EXPECT_EQ(vug.wait(), 130) << vug.log();
  EXPECT_THAT(vug.log(), testing::AnyOf(HasSubstr("vug: interrupted; the run itself is done, --resume goes on with"),
                                        HasSubstr("vug: interrupted by SIGTERM; ")));
  EXPECT_EQ(run_vug(command + " --resume").exit_code, 0);
  EXPECT_TRUE(std::filesystem::exists(out + "/error_bars.csv"));
}

TEST(Signals, StopALaboratoryTest) {
  const TemporaryFolder folder;
  const std::string out = folder / "out";
  BackgroundVug vug("lab " VUG_SOURCE_DIR
                    "/cases/laboratory/compression.toml --quiet --threads 1 --set laboratory.platen_speed=1e-3 -o " +
                        out,
                    folder / "log");
  ASSERT_TRUE(vug.wait_for_file(out + "/stress_strain.csv")) << vug.log();
  expect_stopped(vug, SIGTERM, out);
}

TEST(Signals, ThatWereIgnoredStayIgnoredAsUnderNohup) {
  const TemporaryFolder folder;
  const std::string out = folder / "out", history = out + "/history.csv";
  const auto handler = std::signal(SIGHUP, SIG_IGN);
  BackgroundVug vug("run " VUG_SOURCE_DIR "/cases/poiseuille.toml --quiet --threads 1 --steps 100000000 -o " + out,
                    folder / "log");
  std::signal(SIGHUP, handler);
  const auto grows = [&] {
    const auto before = test::contents(history).size();
    return vug.wait_for([&] { return test::contents(history).size() > before; });
  };
  ASSERT_TRUE(grows()) << vug.log();
  EXPECT_TRUE(has_in("SigIgn", vug.pid(), SIGHUP));
  vug.signal(SIGHUP);
  EXPECT_TRUE(grows() && grows()) << vug.log();
  expect_stopped(vug, SIGTERM, out);
}

TEST(Signals, OfBrokenPipesAndFileSizesAreErrorsOfWriting) {
  const TemporaryFolder folder;
  const std::string run = "OMP_PROC_BIND=false " VUG_EXECUTABLE " run " + small_rock + " --quiet --threads 1 -o ";
  const test::Outcome full = run_command("ulimit -f 8; " + run + (folder / "full"));
  EXPECT_EQ(full.exit_code, 4) << full.output;
  EXPECT_THAT(full.output, HasSubstr("File too large"));
  EXPECT_THAT(test::contents(folder / "full/run.json"), HasSubstr("\"status\": \"failed\""));
  BackgroundVug vug("run " VUG_SOURCE_DIR "/cases/poiseuille.toml --quiet --threads 1 -o " + (folder / "out"),
                    folder / "log");
  ASSERT_TRUE(vug.wait_for_file(folder / "out/fields.xdmf"));
  vug.signal(SIGPIPE);
  EXPECT_EQ(vug.wait(), 0) << "a stray one changes nothing";
}

}  // namespace
}  // namespace vug
