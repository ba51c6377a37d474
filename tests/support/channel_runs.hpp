#pragma once
// Quick runs of a channel, and what they leave in their folder.
#include "support/run_vug.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <string>

namespace vug::test {

inline const std::string channel = VUG_SOURCE_DIR "/cases/poiseuille.toml";
/// A quick run; what follows in `more` are words of the command line.
inline Outcome run_channel(const std::string& folder, const std::string& more) {
  return run_vug("run " + channel + " --threads 1 --set output.interval_steps=100 --set time.steps=1000 -o " + folder +
                 " " + more);
}

inline std::map<std::string, std::string> files_of(const std::string& folder) {
  std::map<std::string, std::string> files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
    if (entry.is_regular_file() && entry.path().filename() != "run.lock")
      files[entry.path().string()] = contents(entry.path().string());
  return files;
}

inline void expect_refused(const Outcome& outcome, const std::string& reason) {
  EXPECT_EQ(outcome.exit_code, 2) << outcome.output;
  EXPECT_EQ(std::count(outcome.output.begin(), outcome.output.end(), '\n'), 1) << outcome.output;
  EXPECT_THAT(outcome.output, testing::HasSubstr(reason));
}

inline int rows_of(const std::string& folder) {
  return rows_in(contents(folder + "/history.csv"));
}

/// The line of run.json with a key; empty where there is none.
inline std::string line_of(const std::string& folder, const std::string& key) {
  const std::string record = contents(folder + "/run.json");
  const auto at = record.find("\n  \"" + key + "\": ");
  return at == std::string::npos ? "" : record.substr(at, record.find('\n', at + 1) - at);
}

}  // namespace vug::test
