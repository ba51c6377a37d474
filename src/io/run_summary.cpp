#include "io/run_summary.hpp"

#include "base/require.hpp"
#include "io/detail/files.hpp"
#include "io/json_text.hpp"

#include <cstdio>
#include <cstdlib>
#include <filesystem>

namespace vug {

namespace {

/// Value of a key in run.json, which has one key on each line.
std::string value_of(const std::string& json, const std::string& key) {
  const std::string mark = "\n  \"" + key + "\": ";
  const auto at = json.find(mark);
  if (at == std::string::npos) return "";
  const auto from = at + mark.size();
  std::string value = json.substr(from, json.find('\n', from) - from);
  if (value.ends_with(',')) value.pop_back();
  return value;
}

/// The same for a text.
std::string text_of(const std::string& json, const std::string& key) {
  const std::vector<std::string> texts = json_texts(value_of(json, key));
  return texts.empty() ? "" : texts.front();
}

std::string record_of(const std::string& directory) {
  return directory + "/run.json";
}

}  // namespace

std::optional<RunSummary> read_run_summary(const std::string& directory) {
  const std::string path = record_of(directory);
  std::error_code none;
  const bool there = std::filesystem::is_regular_file(path, none);
  if (none && none != std::errc::no_such_file_or_directory && none != std::errc::not_a_directory)
    throw FileError(path + ": " + none.message());
  if (!there) return std::nullopt;
  const std::string json = detail::read_file(path);
  RunSummary summary{text_of(json, "run"),
                     text_of(json, "status"),
                     text_of(json, "case_hash"),
                     value_of(json, "inputs"),
                     value_of(json, "steps"),
                     text_of(json, "started"),
                     text_of(json, "exit_reason"),
                     value_of(json, "first_step"),
                     value_of(json, "last_step"),
                     value_of(json, "last_checkpoint"),
                     value_of(json, "wall_time_s"),
                     value_of(json, "exit_code"),
                     json_texts(value_of(json, "events"))};
  if (summary.status.empty() || summary.case_hash.empty())
    throw InputError(path +
                     ": is no record of a run of vug; choose another folder, or remove the file if it is "
                     "what is left of one: --resume goes on from the checkpoints");
  return summary;
}

bool RunSummary::had_checkpoint() const {
  const auto counts = [](const std::string& number) { return !number.empty() && number != "0"; };
  // records without last_checkpoint: such a run wrote a checkpoint at its end, and a resumed one began at a checkpoint
  const bool ended_with_one = counts(steps) && (status == "done" || status == "interrupted");
  return !last_checkpoint.empty() || ended_with_one || counts(first_step);
}

std::vector<std::string> RunSummary::events_until(std::int64_t step) const {
  std::vector<std::string> kept;
  for (const std::string& event : events)
    if (long long at = 0; std::sscanf(event.c_str(), "step %lld,", &at) == 1 && at <= step) kept.push_back(event);
  return kept;
}

RunOrigin read_run_origin(const std::string& directory) {
  const std::string json = detail::read_file(record_of(directory));
  RunOrigin origin{text_of(json, "version"),
                   text_of(json, "commit"),
                   text_of(json, "compiler"),
                   text_of(json, "backend"),
                   text_of(json, "device"),
                   text_of(json, "case_path"),
                   text_of(json, "case_text"),
                   json_texts(value_of(json, "overrides")),
                   {}};
  const std::vector<std::string> inputs = json_texts(value_of(json, "inputs"));
  constexpr std::size_t texts = 5;  // of an input: "path", its value, "bytes" before a number, "hash", its value
  for (std::size_t i = 0; i + texts <= inputs.size(); i += texts)
    origin.inputs.push_back({inputs[i + 1], 0, inputs[i + 4]});
  return origin;
}

}  // namespace vug
