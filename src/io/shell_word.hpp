#pragma once
// Quotes texts for shell scripts.
#include <string>

namespace vug {

/// The text as one word of a POSIX shell, quoted so that no character in it is special.
inline std::string shell_word(const std::string& text) {
  std::string word = "'";
  for (const char c : text) word += c == '\'' ? "'\\''" : std::string(1, c);
  return word + "'";
}

}  // namespace vug
