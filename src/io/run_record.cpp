#include "io/run_record.hpp"

#include "host/exit_code.hpp"
#include "host/this_process.hpp"
#include "io/detail/digest.hpp"
#include "io/detail/files.hpp"
#include "io/detail/input_file.hpp"
#include "io/json_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <ctime>
#include <random>

namespace vug {

InputFile digest_of_file(const std::string& path) {
  const detail::BinaryFile file(path);
  detail::TextDigest digest;
  std::uint64_t size = 0;
  char block[1 << 16];
  while (const std::size_t count = file.read(size, block, sizeof block)) {
    digest.add({block, count});
    size += count;
  }
  return {path, size, fmt::format("{:016x}", digest.value())};
}

std::string case_hash(const std::string& case_text, const std::vector<std::string>& overrides,
                      const std::vector<InputFile>& inputs) {
  detail::TextDigest digest;
  digest.add(case_text);
  for (const auto& entry : overrides) digest.add("\n" + entry);
  for (const auto& input : inputs) digest.add("\n" + input.hash);
  return fmt::format("{:016x}", digest.value());
}

std::string new_run_name() {
  std::random_device random;
  return fmt::format("{:08x}{:08x}", random(), random());
}

std::string utc_now() {
  const std::time_t now = std::time(nullptr);
  std::tm parts{};
  gmtime_r(&now, &parts);
  char text[32];
  std::strftime(text, sizeof(text), "%Y-%m-%dT%H:%M:%SZ", &parts);
  return text;
}

void note_end(RunRecord& record, const std::string& status, const std::string& reason, ExitCode code) {
  record.status = status;
  record.exit_reason = reason;
  record.exit_code = code;
}

void note_failure(RunRecord& record, const std::exception& error) {
  const ExitCode code = exit_code_of(error);
  const char* status = code == interrupted ? "interrupted" : code == diverged ? "diverged" : "failed";
  note_end(record, status, reason_of(error), code);
}

void write_run_record(const std::string& directory, const RunRecord& r) {
  std::string text = "{\n";
  const auto put = [&text](const char* key, const std::string& value) {
    text += fmt::format("{}  \"{}\": {}", text.size() > 2 ? ",\n" : "", key, value);
  };
  const auto list = [](const std::vector<std::string>& entries) {
    std::vector<std::string> all;
    for (const auto& entry : entries) all.push_back(json_string(entry));
    return fmt::format("[{}]", fmt::join(all, ", "));
  };
  put("run", json_string(r.run));
  put("status", json_string(r.status));
  put("exit_reason", json_string(r.exit_reason));
  put("exit_code", fmt::format("{}", r.exit_code));
  put("started", json_string(r.started));
  put("ended", json_string(r.ended));
  put("wall_time_s", json_number(r.wall_time));
  put("first_step", fmt::format("{}", r.first_step));
  put("steps", fmt::format("{}", r.steps));
  if (r.last_step > 0) put("last_step", fmt::format("{}", r.last_step));
  if (r.last_checkpoint) put("last_checkpoint", fmt::format("{}", *r.last_checkpoint));
  put("simulated_time_s", json_number(r.simulated_time));
  put("mlups", json_number(r.mlups));
  if (!r.events.empty()) put("events", list(r.events));
  if (!r.results.empty()) {
    std::vector<std::string> results;
    for (const auto& [name, value] : r.results) results.push_back(json_string(name) + ": " + json_number(value));
    put("results", fmt::format("{{{}}}", fmt::join(results, ", ")));
  }
  put("peak_memory_bytes", fmt::format("{}", peak_memory_bytes()));
  put("version", json_string(r.version));
  put("commit", json_string(r.commit));
  put("compiler", json_string(r.compiler));
  put("backend", json_string(r.backend));
  put("device", json_string(r.device));
  put("precision", json_string(r.precision));
  put("threads", fmt::format("{}", r.threads));
  put("ranks", fmt::format("{}", r.ranks));
  put("case_path", json_string(r.case_path));
  put("case_hash", json_string(case_hash(r.case_text, r.overrides, r.inputs)));
  put("overrides", list(r.overrides));
  std::vector<std::string> inputs;
  for (const auto& input : r.inputs)
    inputs.push_back(fmt::format("{{\"path\": {}, \"bytes\": {}, \"hash\": {}}}", json_string(input.path), input.bytes,
                                 json_string(input.hash)));
  put("inputs", fmt::format("[{}]", fmt::join(inputs, ", ")));
  put("case_text", json_string(r.case_text));
  detail::replace_file(directory + "/run.json", text + "\n}\n", true);
}

}  // namespace vug
