// A study has one table, however many runs are made at once and however often they are killed.
#include "study/sweep.hpp"

#include "host/interruption.hpp"
#include "support/background_vug.hpp"
#include "support/no_locks.hpp"
#include "support/run_vug.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <sstream>

namespace vug {
namespace {

using test::rows_in;

/// Six runs of a channel, of which two cannot work: their fluid is far too fast for the lattice.
std::string study_file(const test::TemporaryFolder& folder, const std::string& more = "") {
  const std::string path = folder / "study.toml";
  test::write_text(
      path, "[study]\ncase = \"" + std::filesystem::absolute(VUG_SOURCE_DIR "/cases/poiseuille.toml").string() +
                "\"\nset = [\"time.steps=3000\", \"output.interval_steps=500\", \"flow.speed_limit=0\"]\n" + more +
                "[[study.keys]]\nkey = \"flow.viscosity\"\nvalues = [1e-6, 2e-6]\n"
                "[[study.keys]]\nkey = \"flow.body_force\"\nvalues = [[1e-3, 0], [2e-3, 0], [3e4, 0]]\n");
  return path;
}

TEST(Sweep, HasOneTableForAnyNumberOfRunsAtOnce) {
  const test::TemporaryFolder folder;
  const std::string study = study_file(folder);
  EXPECT_EQ(test::run_vug("sweep " + study + " -o " + (folder / "one") + " -j 1 --quiet").exit_code, 3);
  EXPECT_EQ(test::run_vug("sweep " + study + " -o " + (folder / "two") + " -j 2 --quiet").exit_code, 3);
  const std::string table = test::contents(folder / "one/table.csv");
  EXPECT_EQ(table, test::contents(folder / "two/table.csv"));
  EXPECT_EQ(rows_in(table), 4) << table;
  EXPECT_TRUE(table.starts_with("run,flow.viscosity,flow.body_force,time_s,step_1,")) << table;
  EXPECT_NE(table.find("\n0002,1e-06,\"[ 0.002, 0 ]\",3,3000,"), std::string::npos) << table;
  const std::string failures = test::contents(folder / "one/failures.csv");
  EXPECT_EQ(rows_in(failures), 2) << failures;
  EXPECT_NE(failures.find("diverged"), std::string::npos) << failures;
  EXPECT_EQ(test::run_vug("sweep " + study + " -o " + (folder / "one") + " --quiet").exit_code, 2) << "asks first";
}

/// Whichever run comes first: one whose flow is never held has no column for it.
TEST(Sweep, HasTheColumnsOfAllRuns) {
  const test::TemporaryFolder folder;
  test::write_text(folder / "study.toml",
                   "[study]\ncase = \"" + std::filesystem::absolute(VUG_SOURCE_DIR "/cases/poiseuille.toml").string() +
                       "\"\nset = [\"time.steps=200\", \"output.interval_steps=200\"]\n[[study.keys]]\nkey = "
                       "\"accuracy.flow_tolerance\"\n"
                       "values = [0, 1e-3]\n");
  ASSERT_EQ(test::run_vug("sweep " + (folder / "study.toml") + " -o " + (folder / "out") + " -j 1 --quiet").exit_code,
            0);
  std::istringstream table(test::contents(folder / "out/table.csv"));
  std::string header, never, held;
  std::getline(table, header);
  std::getline(table, never);
  std::getline(table, held);
  EXPECT_TRUE(header.ends_with(",flow_held_steps_1")) << header;
  EXPECT_TRUE(never.ends_with(",")) << never;
  EXPECT_TRUE(held.ends_with(",0")) << held;
}

TEST(Sweep, HasTheSameTableAfterKills) {
  const test::TemporaryFolder folder;
  const std::string study = study_file(folder, "results = [\"largest_mach_1\"]\n");
  const std::string study_alone = " sweep " + study + " -o ";
  ASSERT_EQ(test::run_vug(study_alone + (folder / "whole") + " -j 2 --quiet").exit_code, 3);
  const std::string call = "sweep " + study + " -o " + (folder / "killed") + " -j 2 --resume";
  int killed = 0;
  for (const std::string member : {"0001", "0002", "0003", "0004", "0005", "0006"}) {
    const std::string record = folder / ("killed/runs/" + member + "/run.json");
    if (std::filesystem::exists(record)) continue;
    test::BackgroundVug sweep(call, folder / "log");
    EXPECT_TRUE(sweep.wait_for_file(record)) << sweep.log();  // the run of this member has just begun
    sweep.signal(killed % 2 == 0 ? SIGKILL : SIGTERM);
    killed += sweep.wait() == (killed % 2 == 0 ? 128 + SIGKILL : 130);  // else it had done all
  }
  std::printf("    killed %d times\n", killed);
  EXPECT_GE(killed, 2);  // of 3 to 6: two runs begin at once
  EXPECT_EQ(test::run_vug(call).exit_code, 3);
  EXPECT_EQ(test::contents(folder / "killed/table.csv"), test::contents(folder / "whole/table.csv"));
}

/// An earlier row must not pass for the result.
TEST(Sweep, MakesNoTableOfAHistoryThatHasLostItsEnd) {
  const test::TemporaryFolder folder;
  const std::string call =
      "sweep " + study_file(folder, "results = [\"largest_mach_1\"]\n") + " -o " + (folder / "runs") + " --quiet";
  ASSERT_EQ(test::run_vug(call).exit_code, 3);
  const std::string table = test::contents(folder / "runs/table.csv"), history = folder / "runs/runs/0002/history.csv";
  const std::string whole = test::contents(history);
  for (const std::string& rest : {whole.substr(0, whole.size() - 1), whole.substr(0, whole.find('\n') + 1)}) {
    test::write_text(history, rest);
    const test::Outcome outcome = test::run_vug(call + " --resume");
    EXPECT_EQ(outcome.exit_code, 4) << outcome.output;
    EXPECT_NE(outcome.output.find("0002/history.csv: ends before the last step of its run, 3000; remove "),
              std::string::npos)
        << outcome.output;
    EXPECT_EQ(test::contents(folder / "runs/table.csv"), table);
  }
}

// The header of a history is there when its run begins: runs of hours need not end before a slip is told.
TEST(Sweep, TellsOfAResultThatIsNoneWhenTheFirstRunHasBegun) {
  const test::TemporaryFolder folder;
  const auto write = [&](const char* result, const char* steps) {
    test::write_text(folder / "study.toml",
                     "[study]\ncase = \"" +
                         std::filesystem::absolute(VUG_SOURCE_DIR "/cases/poiseuille.toml").string() +
                         "\"\nset = [\"time.steps=" + steps + "\"]\nresults = [\"" + result +
                         "\"]\n[[study.keys]]\nkey = \"flow.viscosity\"\nvalues = [1e-6, 2e-6, 3e-6]\n");
    return "sweep " + (folder / "study.toml") + " -o " + (folder / "out") + " -j 1 --quiet";
  };
  const test::Outcome misspelt = test::run_vug(write("largest_mach", "100000000"));
  EXPECT_EQ(misspelt.exit_code, 2);
  EXPECT_NE(misspelt.output.find("\"largest_mach\" is no column of the history; did you mean \"largest_mach_1\"?"),
            std::string::npos)
      << misspelt.output;
  EXPECT_FALSE(std::filesystem::exists(folder / "out/runs/0002"));
  EXPECT_NE(test::contents(folder / "out/runs/0001/run.json").find("interrupted"), std::string::npos);
  ASSERT_EQ(test::run_vug("sweep " + study_file(folder) + " -o " + (folder / "done") + " --quiet").exit_code, 3);
  const std::string again = study_file(folder, "results = [\"mach\"]\n");
  EXPECT_EQ(test::run_vug("sweep " + again + " -o " + (folder / "done") + " --resume --quiet").exit_code, 2);
  EXPECT_EQ(test::run_vug("sweep " + study_file(folder, "results = [\"largest_mach_1\"]\n") + " -o " +
                          (folder / "done") + " --resume --quiet")
                .exit_code,
            3);
}

TEST(Sweep, WritesAnArrayForSlurmWhoseMembersMakeTheSameTable) {
  const test::TemporaryFolder folder;
  const std::string study = study_file(folder);
  const test::Outcome script = test::run_vug("sweep " + study + " -o " + (folder / "array") + " --batch slurm");
  ASSERT_EQ(script.exit_code, 0) << script.output;
  EXPECT_NE(script.output.find("#SBATCH --array=0-5\n"), std::string::npos) << script.output;
  test::write_text(folder / "array.sh", script.output);
  EXPECT_NE(script.output.find("/array' --table\n"), std::string::npos) << script.output;
  const std::string make_table = "sweep " + study + " -o " + (folder / "array") + " --table --quiet";
  EXPECT_EQ(test::run_vug(make_table).exit_code, 2) << "there is nothing yet";
  EXPECT_FALSE(std::filesystem::exists(folder / "array"));
  for (int member = 0; member < 6; ++member) {
    test::run_command("SLURM_ARRAY_TASK_ID=" + std::to_string(member) + " bash " + (folder / "array.sh"));
    if (member != 1) continue;
    EXPECT_EQ(test::run_vug(make_table).exit_code, 3);
    EXPECT_EQ(rows_in(test::contents(folder / "array/table.csv")), 2);
    EXPECT_EQ(rows_in(test::contents(folder / "array/failures.csv")), 4);
    EXPECT_FALSE(std::filesystem::exists(folder / "array/runs/0003")) << "it runs nothing";
  }
  EXPECT_EQ(test::run_vug(make_table).exit_code, 3);
  EXPECT_EQ(test::run_vug(make_table + " --resume").exit_code, 2);
  EXPECT_EQ(test::run_vug("sweep " + study + " -o " + (folder / "local") + " --quiet").exit_code, 3);
  EXPECT_EQ(test::contents(folder / "array/table.csv"), test::contents(folder / "local/table.csv"));
  const std::string failures = test::contents(folder / "array/failures.csv");
  EXPECT_NE(failures.find("\n0003,1e-06,\"[ 30000.0, 0 ]\",diverged,\"vug: flow diverged at step "), std::string::npos)
      << failures;
  EXPECT_EQ(test::contents(folder / "array/runs/0001.log"), test::contents(folder / "local/runs/0001.log"));
  EXPECT_EQ(test::run_vug("sweep " + study + " -o " + (folder / "array") + " --member 6").exit_code, 2);
}

TEST(Sweep, KeepsTheWarningsOfItsRunsInTheirLogs) {
  const test::TemporaryFolder folder;
  test::write_text(folder / "viscous.toml",
                   "[study]\ncase = \"" + std::filesystem::absolute(VUG_SOURCE_DIR "/cases/poiseuille.toml").string() +
                       "\"\nset = [\"time.steps=2000\"]\n[[study.keys]]\nkey = "
                       "\"flow.viscosity\"\nvalues = [1e-5]\n");
  ASSERT_EQ(test::run_vug("sweep " + (folder / "viscous.toml") + " -o " + (folder / "study") + " --quiet").exit_code,
            0);
  const std::string log = test::contents(folder / "study/runs/0001.log");
  EXPECT_TRUE(log.starts_with("warning: flow: ")) << log;
}

TEST(Sweep, SaysThatItsFolderCannotBeLocked) {
  const test::TemporaryFolder folder;
  const std::string study = study_file(folder);
  ASSERT_EQ(test::run_vug("sweep " + study + " -o " + (folder / "out") + " --quiet").exit_code, 3);
  const auto warning = [&] {  // nothing is left to be run: this process is no vug
    std::ostringstream warnings;
    SweepOptions options;
    options.directory = folder / "out";
    options.resume = true;
    options.warnings = &warnings;
    EXPECT_EQ(sweep(study, options), 2);
    return warnings.str();
  };
  EXPECT_EQ(warning(), "");
  const test::NoLocks none;
  EXPECT_EQ(warning(), "warning: " + (folder / "out") +
                           ": cannot be locked (Function not implemented): see to it that no other sweep runs there\n");
}

/// Asks with every word that it is told whether a signal would be noted, or would end the process where it stands.
struct AsksForOrder : std::stringbuf {
  bool in_order = true, asked = false;
  std::streamsize xsputn(const char* text, std::streamsize count) override {
    asked = true;
    in_order = in_order && StopsInOrder::now();
    return std::stringbuf::xsputn(text, count);
  }
};

TEST(Sweep, StopsInOrderAlsoWhereNoRunIsUnderWay) {
  const test::TemporaryFolder folder;
  const std::string study = study_file(folder);
  ASSERT_EQ(test::run_vug("sweep " + study + " -o " + (folder / "out") + " --quiet").exit_code, 3);
  AsksForOrder asks;
  std::ostream progress(&asks);
  SweepOptions options;
  options.directory = folder / "out";
  options.resume = true;
  options.progress = &progress;
  EXPECT_EQ(sweep(study, options), 2);
  EXPECT_TRUE(asks.asked);
  EXPECT_TRUE(asks.in_order);
  EXPECT_STREQ(words_when_ended(), "interrupted when the study was done");
}

/// A folder's study.toml, table.csv and failures.csv are a sweep's, or the user's: then they stay.
TEST(Sweep, LeavesFilesOfOthersAlone) {
  const test::TemporaryFolder folder;
  const std::string study = study_file(folder);
  for (const char* name : {"study.toml", "table.csv", "failures.csv"})
    for (const char* resume : {"", " --resume"}) {
      const std::string out = folder / "mine";
      std::filesystem::create_directories(out);
      test::write_text(out + "/" + name, "mine");
      const test::Outcome refused = test::run_vug("sweep " + study + " -o " + out + " --quiet" + resume);
      EXPECT_EQ(refused.exit_code, 2) << refused.output;
      EXPECT_NE(refused.output.find(std::string(name) + ": is in the way, and no sweep wrote it"), std::string::npos)
          << refused.output;
      EXPECT_EQ(test::contents(out + "/" + name), "mine");
      EXPECT_FALSE(std::filesystem::exists(out + "/runs"));
      std::filesystem::remove_all(out);
    }
  // the folder of the study itself will do: its copy is the study
  EXPECT_EQ(test::run_vug("sweep " + study + " -o " + folder.path() + " --quiet").exit_code, 3);
  EXPECT_EQ(test::run_vug("sweep " + study + " -o " + folder.path() + " --quiet --resume").exit_code, 3);
}

}  // namespace
}  // namespace vug
