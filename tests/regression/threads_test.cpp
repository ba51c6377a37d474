// Numbers of threads that OpenMP and the environment give, refuse or change.
#include "support/run_vug.hpp"

#include <gmock/gmock.h>

namespace vug {
namespace {

using test::lines_in;
using test::Outcome;
using test::run_command;
using test::run_vug;
using test::small_rock;
using test::TemporaryFolder;
using testing::HasSubstr;

// Each of these once ended in an abort or in a wait without end.
TEST(Threads, ThatOpenMpDoesNotGiveAreSaidOrRefused) {
  const auto with = [](const std::string& environment, const std::string& arguments) {
    return run_command("OMP_PROC_BIND=false OMP_WAIT_POLICY=passive " + environment +
                       " timeout 60 " VUG_EXECUTABLE " " + arguments);
  };
  for (const char* environment :
       {"KOKKOS_NUM_THREADS=abc", "KOKKOS_NUM_THREADS=0", "KOKKOS_NUM_THREADS=4x", "KOKKOS_NUM_THREADS=99999999999",
        "KOKKOS_DISABLE_WARNINGS=perhaps", "KOKKOS_DEVICE_ID=-1", "KOKKOS_MAP_DEVICE_ID_BY=$(printf '\\033[31m')"}) {
    const Outcome outcome = with(environment, "info");
    EXPECT_EQ(outcome.exit_code, 2) << environment << outcome.output;
    EXPECT_EQ(lines_in(outcome.output), 1) << outcome.output;
    EXPECT_EQ(outcome.output.find('\x1b'), std::string::npos);
  }
  EXPECT_EQ(run_vug("info --threads 2").exit_code, 2);
  EXPECT_EQ(run_vug("check x.toml --threads 513").exit_code, 2);
  if (run_vug("info").output.find("OpenMP") == std::string::npos) GTEST_SKIP() << "no threads on the host";
  const std::string run = "run " + small_rock + " --steps 2 --threads 3 -o ";
  const struct {
    const char *environment, *remark;
  } settings[] = {{"OMP_THREAD_LIMIT=1", "threads: 1 instead of 3: OMP_THREAD_LIMIT"},
                  {"OMP_DYNAMIC=true", ""},
                  {"OMP_MAX_ACTIVE_LEVELS=0", ""},
                  {"OMP_NUM_THREADS=1000", ""}};
  for (const auto& [environment, remark] : settings) {
    const TemporaryFolder folder;
    const Outcome outcome = with(environment, run + (folder / "out"));
    EXPECT_EQ(outcome.exit_code, 0) << environment << outcome.output;
    EXPECT_THAT(outcome.output, HasSubstr(remark));
  }
  const Outcome many = with("OMP_NUM_THREADS=1000", "info");
  EXPECT_EQ(many.exit_code, 0) << many.output;
  EXPECT_THAT(many.output, HasSubstr("instead of 1000: at most 512"));
}

/// Stacks of threads take address space. Those that have started before it is used up must have ended when the refusal
/// is caught: one that nobody has joined would abort the program.
TEST(Threads, ThatTheSystemRefusesAreCountedAndHaveEnded) {
#if defined(__SANITIZE_ADDRESS__) || defined(VUG_SEPARATE_MEMORY)
  GTEST_SKIP() << "the memory that these builds set aside is beyond any limit";
#endif
  if (run_vug("info").output.find("OpenMP") == std::string::npos) GTEST_SKIP() << "no threads on the host";
  const TemporaryFolder folder;
  const Outcome refused =
      run_command("ulimit -v 600000; OMP_PROC_BIND=false OMP_WAIT_POLICY=passive timeout 60 " VUG_EXECUTABLE " run " +
                  small_rock + " --steps 2 --threads 300 -o " + (folder / "out"));
  EXPECT_EQ(refused.exit_code, 2) << refused.output;
  EXPECT_EQ(lines_in(refused.output), 1) << refused.output;
  EXPECT_THAT(refused.output, testing::ContainsRegex("threads: the system grants [0-9]+ of 300 "));
}

}  // namespace
}  // namespace vug
