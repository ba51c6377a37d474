#include "io/detail/case_text.hpp"

#include "base/require.hpp"
#include "io/detail/input_file.hpp"
#include "io/message.hpp"

#include <fmt/format.h>

namespace vug {
namespace {

constexpr std::size_t largest = 4u << 20;  // bytes; enough for a long list of shapes many times over

[[noreturn]] void refuse(const std::string& path, const std::string& problem) {
  throw InputError(one_line(fmt::format("{}: {}", path, problem)));
}

}  // namespace

std::string read_case_text(const std::string& path) {
  if (const std::string why = detail::why_no_file(path); !why.empty())
    refuse(path, why + "; give the path of a case file (.toml)");
  return detail::read_input_file(path, largest);
}

void check_text(const std::string& text, const std::string& path) {
  if (text.find_first_not_of(" \t\r\n") == std::string::npos || text == "\xEF\xBB\xBF") {
    refuse(path, "is empty; a case needs at least [lattice] and [time]");
  }
  if (text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF")) {
    refuse(path, "is UTF-16 text; save it as UTF-8");
  }
  if (const auto zero = text.find('\0'); zero != std::string::npos) {
    refuse(path, fmt::format("is not a text file (byte {} is zero); a case is TOML text", zero));
  }
}

}  // namespace vug
