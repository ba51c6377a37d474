#include "io/history_writer.hpp"

#include "base/require.hpp"
#include "io/history_reader.hpp"
#include "support/temporary_folder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <limits>

namespace vug {
namespace {

using test::contents;
using ::testing::HasSubstr;

const std::vector<std::string> columns{"time_s", "mass_kg"};

TEST(HistoryWriter, KeepsEveryBitOfANumber) {
  const test::TemporaryFolder folder;
  const double third = 1.0 / 3.0, tiny = 4.9406564584124654e-324;
  HistoryWriter writer(folder / "history.csv", columns);
  writer.write(std::vector<double>{third, tiny});
  const auto text = contents(folder / "history.csv");  // readable while the writer is alive
  const auto row = text.substr(text.find('\n') + 1);
  EXPECT_EQ(text.substr(0, text.find('\n')), "time_s,mass_kg");
  EXPECT_EQ(std::strtod(row.c_str(), nullptr), third);
  EXPECT_EQ(std::strtod(row.c_str() + row.find(',') + 1, nullptr), tiny);
}

// Only of error_bars.csv, and only its bars: of a history a number that is none stays one.
TEST(HistoryWriter, LeavesUnknownBarsEmpty) {
  const test::TemporaryFolder folder;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const bool empty : {true, false}) {
    HistoryWriter history(folder / "a.csv", {"time_s", "bar_of_a_m"});
    if (empty) history.leave_unknown_empty();
    history.write(std::vector<double>{0, nan});
    EXPECT_EQ(test::contents(folder / "a.csv"), empty ? "time_s,bar_of_a_m\n0,\n" : "time_s,bar_of_a_m\n0,nan\n");
    EXPECT_TRUE(std::isnan(read_history(folder / "a.csv").values[1][0]));
  }
  test::write_text(folder / "b.csv", "time_s,a_m\n0,\n");
  EXPECT_THROW(read_history(folder / "b.csv"), FileError);
}

TEST(HistoryWriter, ContinuesWithoutLaterRowsAndTornLines) {
  const test::TemporaryFolder folder;
  const auto path = folder / "history.csv";
  test::write_text(path, "time_s,mass_kg\n0,1\n0.1,2\n0.2,3\n0.05,4");
  HistoryWriter history(path, columns, 0.1);
  EXPECT_EQ(history.rows(), 2);
  history.write(std::vector<double>{0.15, 5});
  EXPECT_EQ(history.rows(), 3);
  EXPECT_EQ(contents(path), "time_s,mass_kg\n0,1\n0.1,2\n0.14999999999999999,5\n");
}

TEST(HistoryWriter, RefusesToContinueOtherColumns) {
  const test::TemporaryFolder folder;
  test::write_text(folder / "history.csv", "time_s,energy_J\n0,1\n");
  EXPECT_THROW(HistoryWriter(folder / "history.csv", columns, 0.1), FileError);
  EXPECT_THAT(contents(folder / "history.csv"), HasSubstr("energy_J")) << "left as it was";
}

TEST(HistoryWriter, RefusesARowOfAnotherLength) {
  const test::TemporaryFolder folder;
  HistoryWriter writer(folder / "history.csv", columns);
  EXPECT_THROW(writer.write(std::vector<double>{0}), FileError);
}

TEST(HistoryWriter, NamesPathAndReasonWhenItCannotWrite) {
  try {
    HistoryWriter("/proc/no/history.csv", columns);
    FAIL() << "accepted";
  } catch (const FileError& e) {
    EXPECT_THAT(e.what(), HasSubstr("/proc/no/history.csv"));
    EXPECT_THAT(e.what(), HasSubstr("No such file"));
  }
}

}  // namespace
}  // namespace vug
