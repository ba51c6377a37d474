#include "io/detail/case_text.hpp"

#include "io/detail/toml_document.hpp"
#include "kernels/require.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <memory>

namespace vug {
namespace {

constexpr std::size_t largest = 4u << 20;  // bytes; a long list of shapes fits many times

struct CloseFile {
  void operator()(std::FILE* file) const { std::fclose(file); }
};

[[noreturn]] void refuse(const std::string& path, const std::string& problem) {
  throw InputError(one_line(fmt::format("{}: {}", path, problem)));
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
}

}  // namespace vug
