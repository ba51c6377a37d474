#include "study/table.hpp"

#include "base/require.hpp"
#include "io/detail/files.hpp"
#include "io/history_reader.hpp"
#include "io/message.hpp"
#include "io/run_summary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>

namespace vug {

namespace {

/// A field of a CSV file (RFC 4180).
std::string csv(const std::string& text) {
  if (text.find_first_of(",\"\n") == std::string::npos) return text;
  std::string out = "\"";
  for (const char c : text) out += c == '"' ? "\"\"" : std::string(1, c);
  return out + "\"";
}

/// A value without the quotes of TOML's text.
std::string plain(const std::string& value) {
  const bool quoted =
      value.size() >= 2 && (value.front() == '"' || value.front() == '\'') && value.back() == value.front();
  return quoted ? value.substr(1, value.size() - 2) : value;
}

/// The last value of a column of a history; empty if there is none.
std::string last_value(const History& history, const std::string& name) {
  const int column = history.find(name);
  return column < 0 || history.rows() == 0 ? "" : fmt::format("{:.17g}", history.values[column].back());
}

void require_columns(const Study& study, const History& history) {
  history.find_all(study.results, study.path + ": study.results: ");
}

/// Throws FileError where the end of a history is missing: an earlier row would be taken for the result.
void require_whole(const Member& member, const History& history) {
  const std::string last = last_value(history, "step_1"), steps = read_run_summary(member.directory)->steps;
  if (std::strtod(last.c_str(), nullptr) != std::strtod(steps.c_str(), nullptr) || last.empty())
    throw FileError(
        fmt::format("{0}/history.csv: ends before the last step of its run, {1}; remove {0} and call with "
                    "--resume to run it again",
                    member.directory, steps));
}

std::string beginning(const Study& study) {
  std::string text = "run";
  for (const StudyKey& key : study.keys) text += "," + csv(key.key);
  return text;
}

std::string beginning(const Member& member) {
  std::string text = member.name;
  for (const std::string& value : member.values) text += "," + csv(plain(value));
  return text;
}

const char* words_of(MemberState state) {
  switch (state) {
    case MemberState::missing:
      return "not begun";
    case MemberState::diverged:
      return "diverged";
    case MemberState::other_case:
      return "of another case";
    default:
      return "unfinished";
  }
}

/// The last line of a file that is not empty.
std::string last_words(const std::string& path) {
  if (!std::filesystem::exists(path)) return "";
  std::istringstream file(detail::read_file(path));
  std::string last;
  for (std::string line; std::getline(file, line);)
    if (!line.empty()) last = line;
  return excerpt(last, 500);
}

}  // namespace

bool look_at_columns(const Study& study, const Member& member) {
  if (study.results.empty()) return true;
  std::ifstream file(member.directory + "/history.csv", std::ios::binary);
  std::string line;
  if (!std::getline(file, line) || file.eof()) return false;
  History history;
  std::istringstream names(line);
  for (std::string name; std::getline(names, name, ',');) history.names.push_back(name);
  require_columns(study, history);
  return true;
}

std::string table_text(const Study& study, const std::vector<Member>& members) {
  std::vector<std::string> columns = study.results, beginnings;
  std::vector<History> last_rows;
  for (const Member& member : members) {
    if (state_of(member) != MemberState::done) continue;
    History history = read_history(member.directory + "/history.csv");
    require_whole(member, history);
    require_columns(study, history);
    if (study.results.empty())  // those of all runs
      std::copy_if(history.names.begin(), history.names.end(), std::back_inserter(columns),
                   [&](const auto& name) { return std::find(columns.begin(), columns.end(), name) == columns.end(); });
    for (std::vector<double>& values : history.values) values = {values.back()};
    beginnings.push_back(beginning(member));
    last_rows.push_back(std::move(history));
  }
  std::string text = beginning(study);
  for (const std::string& column : columns) text += "," + csv(column);
  text += "\n";
  for (std::size_t i = 0; i < beginnings.size(); ++i) {
    text += beginnings[i];
    for (const std::string& column : columns) text += "," + last_value(last_rows[i], column);
    text += "\n";
  }
  return text;
}

std::string failures_text(const Study& study, const std::vector<Member>& members) {
  std::string text = beginning(study) + ",state,last line\n";
  for (const Member& member : members) {
    const MemberState state = state_of(member);
    if (state != MemberState::done)
      text += fmt::format("{},{},{}\n", beginning(member), words_of(state), csv(last_words(member.log)));
  }
  return text;
}

}  // namespace vug
