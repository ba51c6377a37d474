#include "io/run_record.hpp"

#include "base/require.hpp"
#include "io/run_folder.hpp"
#include "support/temporary_folder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

namespace vug {
namespace {

using ::testing::HasSubstr;

TEST(RunRecord, IsJsonThatKeepsTheCaseToTheLetter) {
  const test::TemporaryFolder folder;
  RunRecord record;
  record.case_path = "cases/\"odd\" name.toml";
  record.case_text = "# tab\there, quote \", backslash \\ and µm\n[case]\r\n\x01";
  record.overrides = {"time.end = 1e-3", "case.name = \"x\""};
  record.mlups = NAN;
  write_run_record(folder.path(), record);
  test::write_text(folder / "case.toml", record.case_text);
  const std::string script =
      "import json,sys; r=json.load(open(sys.argv[1]+'/run.json',encoding='utf-8')); "
      "assert r['case_text']==open(sys.argv[1]+'/case.toml',newline='',encoding='utf-8').read(); "
      "assert r['status']=='running' and r['mlups'] is None and len(r['overrides'])==2; "
      "assert r['peak_memory_bytes']>1e6 and len(r['case_hash'])==16";
  EXPECT_EQ(std::system((std::string(VUG_PYTHON) + " -c \"" + script + "\" " + folder.path()).c_str()), 0);
}

/// Linux takes any bytes for the name of a file; a record of it is JSON all the same, and gives the name back.
TEST(RunRecord, IsJsonWhateverTheNamesOfFilesAre) {
  const test::TemporaryFolder folder;
  RunRecord record;
  record.case_path = "out\xff \xc3\xa9.toml";
  record.case_text = "# \xc3\xa9";
  record.events = {record.case_path, "\xc3\xa9"};
  write_run_record(folder.path(), record);
  const std::string script =
      "import json,sys; r=json.load(open(sys.argv[1]+'/run.json',encoding='utf-8')); "
      "assert r['case_text']=='# \\u00e9' and r['events'][1]=='\\u00e9'; "
      "assert r['case_path'].encode('latin-1')==b'out\\xff \\xc3\\xa9.toml'";
  test::write_text(folder / "look.py", script);
  EXPECT_EQ(std::system((std::string(VUG_PYTHON) + " " + (folder / "look.py") + " " + folder.path()).c_str()), 0);
  EXPECT_EQ(read_run_summary(folder.path())->events, record.events);
  EXPECT_EQ(read_run_origin(folder.path()).case_path, record.case_path);
}

/// As the process that the error ends: host/exit_code.hpp.
TEST(RunRecord, KeepsTheExitCodeOfTheErrorThatEndedTheRun) {
  RunRecord failed;
  note_failure(failed, std::logic_error("vector::at"));
  EXPECT_EQ(failed.status, "failed");
  EXPECT_EQ(failed.exit_code, 1);
  EXPECT_EQ(failed.exit_reason, "an error of vug itself: vector::at");
  note_failure(failed, FileError("a: disk full"));
  EXPECT_EQ(failed.exit_code, 4);
  EXPECT_EQ(failed.exit_reason, "a: disk full");
  note_failure(failed, std::bad_alloc());
  EXPECT_EQ(failed.exit_code, 5);
}

TEST(RunRecord, ReplacesTheOneBefore) {
  const test::TemporaryFolder folder;
  RunRecord record;
  write_run_record(folder.path(), record);
  record.status = "done";
  write_run_record(folder.path(), record);
  EXPECT_THAT(test::contents(folder / "run.json"), HasSubstr("\"status\": \"done\""));
  EXPECT_FALSE(std::filesystem::exists(folder / "run.json.tmp"));
}

TEST(RunRecord, GivesBackItsEventsUpToAStep) {
  const test::TemporaryFolder folder;
  RunRecord record;
  record.events = {"step 5, 1 s: \"a\\b\", c", "step 10, 2 s: tab\there\nand \x01", "step 11, 2 s: later",
                   "at the end"};
  write_run_record(folder.path(), record);
  const RunSummary summary = read_run_summary(folder.path()).value();
  EXPECT_EQ(summary.events, record.events);
  EXPECT_THAT(summary.events_until(10), testing::ElementsAre(record.events[0], record.events[1]));
  EXPECT_FALSE(summary.had_checkpoint());
  record.last_checkpoint = 10;
  write_run_record(folder.path(), record);
  EXPECT_TRUE(read_run_summary(folder.path())->had_checkpoint());
}

TEST(RunRecord, HashesTextAndOverrides) {
  EXPECT_EQ(case_hash("", {}), "cbf29ce484222325");        // FNV-1a, published offset basis
  EXPECT_EQ(case_hash("foobar", {}), "85944171f73967e8");  // published test vector
  EXPECT_NE(case_hash("a", {}), case_hash("a", {"b"}));
}

TEST(RunRecord, NamesPathAndReasonWhenTheFolderIsMissing) {
  try {
    write_run_record("/proc/no/such", {});
    FAIL() << "accepted";
  } catch (const FileError& e) {
    EXPECT_THAT(e.what(), HasSubstr("/proc/no/such/run.json"));
    EXPECT_THAT(e.what(), HasSubstr("No such file"));
  }
}

}  // namespace
}  // namespace vug
