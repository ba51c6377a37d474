#include "io/detail/case_text.hpp"

#include "io/detail/toml_document.hpp"
#include "kernels/require.hpp"

#include <fmt/format.h>

#include <cctype>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <memory>

namespace vug {
namespace {

constexpr std::size_t largest = 4u << 20;  // bytes; a long list of shapes fits many times
constexpr int deepest = 100;               // levels of dotted keys; the reader knows five

struct CloseFile {
  void operator()(std::FILE* file) const { std::fclose(file); }
};

[[noreturn]] void refuse(const std::string& path, const std::string& problem) {
  throw InputError(one_line(fmt::format("{}: {}", path, problem)));
}

/// Whether a character can stand in a dotted key, between its dots or around them.
bool in_key(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || std::strchr("_-\t \"'.", c) != nullptr;
}

/// The first line with a key dotted more than `deepest` levels deep, outside comments and strings; 0 when there is
/// none. The TOML library would build, and destroy, one table inside the other for each level.
int line_of_deep_key(const std::string& text) {
  int dots = 0, line = 1;
  char quote = 0, previous = 0;
  bool comment = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (c == '\n') {
      ++line;
      comment = false;
      quote = 0;
    }
    if (comment) continue;
    if (quote != 0) {
      if (c == '\\' && quote == '"') ++i;
      if (c == quote) quote = 0;
      continue;
    }
    if (c == '#') comment = true;
    if (c == '"' || c == '\'') quote = c;
    if (!in_key(c)) dots = 0;
    if (c == '.' && previous != '.') ++dots;  // an ellipsis is prose
    if (dots >= deepest) return line;
    previous = c;
  }
  return 0;
}

}  // namespace

std::string read_case_text(const std::string& path) {
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  if (status.type() == std::filesystem::file_type::not_found)
    refuse(path, "no such file; give the path of a case file (.toml)");
  if (error) refuse(path, fmt::format("cannot be opened: {}", error.message()));
  if (std::filesystem::is_directory(status)) refuse(path, "is a folder; give the path of a case file (.toml)");
  errno = 0;
  const std::unique_ptr<std::FILE, CloseFile> file(std::fopen(path.c_str(), "rb"));
  if (!file) refuse(path, fmt::format("cannot be opened: {}", std::strerror(errno)));
  std::string text;
  char block[1 << 16];
  while (const std::size_t count = std::fread(block, 1, sizeof block, file.get())) {
    text.append(block, count);
    if (text.size() > largest) refuse(path, fmt::format("is larger than {} MiB, which no case file is", largest >> 20));
  }
  if (std::ferror(file.get()) != 0) throw FileError(fmt::format("{}: reading failed: {}", path, std::strerror(errno)));
  return text;
}

void check_text(const std::string& text, const std::string& path) {
  if (text.find_first_not_of(" \t\r\n") == std::string::npos || text == "\xEF\xBB\xBF") {
    refuse(path, "is empty; a case needs at least [lattice] and [time]");
  }
  if (text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF")) {
    refuse(path, "1:1: is UTF-16 text; save it as UTF-8");
  }
  if (const auto zero = text.find('\0'); zero != std::string::npos) {
    refuse(path, fmt::format("is not a text file (byte {} is zero); a case is TOML text", zero));
  }
  if (const int line = line_of_deep_key(text); line > 0) {
    throw InputError(
        fmt::format("{}:{}:1: a key is dotted more than {} levels deep; no key of a case is", path, line, deepest));
  }
}

}  // namespace vug
