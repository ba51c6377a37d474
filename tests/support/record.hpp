#pragma once
// What a verification test measured, kept for docs/validation.md.
#include <cstdio>
#include <cstdlib>
#include <initializer_list>
#include <string>
#include <utility>
#include <variant>

namespace vug::test {

using Recorded = std::variant<double, int, std::string>;

/// Appends one row {"key": value, ...} to NAME.jsonl in the folder that the environment variable VUG_RECORD names
/// (scripts/validate sets it); without it does nothing. Keys and text need no escaping in JSON. One write per row, so
/// that tests that run at once may share a file.
inline void record(const std::string& name, std::initializer_list<std::pair<const char*, Recorded>> row) {
  const char* folder = std::getenv("VUG_RECORD");
  if (folder == nullptr) return;
  std::string line;
  for (const auto& [key, value] : row) {
    line += (line.empty() ? "{\"" : ", \"") + std::string(key) + "\": ";
    char number[32];
    if (const auto* text = std::get_if<std::string>(&value)) {
      line += '"' + *text + '"';
    } else {
      const double x = std::holds_alternative<int>(value) ? std::get<int>(value) : std::get<double>(value);
      std::snprintf(number, sizeof number, "%.17g", x);
      line += number;
    }
  }
  line += "}\n";
  std::FILE* file = std::fopen((std::string(folder) + "/" + name + ".jsonl").c_str(), "a");
  if (file == nullptr) return;
  std::fwrite(line.data(), 1, line.size(), file);
  std::fclose(file);
}

}  // namespace vug::test
