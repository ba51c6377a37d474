#pragma once
// Texts in scripts for a shell.
#include <string>

namespace vug {

/// The text as one word of a POSIX shell, which takes nothing in it for more than it is.
inline std::string shell_word(const std::string& text) {
  std::string word = "'";
  for (const char c : text) word += c == '\'' ? "'\\''" : std::string(1, c);
  return word + "'";
}

}  // namespace vug
