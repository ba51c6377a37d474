#pragma once
// Texts at which toml++ fails or crashes; they are found and refused before it reads them.
#include <string>

namespace vug {

/// Throws InputError, with the line, for three things: a table header that does not begin with a key, which toml++
/// takes for impossible; a key of more than a hundred levels, for which it would nest tables until the stack overflows;
/// a character beyond ASCII outside strings and comments, which TOML 1.0 does not allow and some of which toml++ 3.3
/// looks up beyond the end of a table. `path` is for messages.
void refuse_toml_hazards(const std::string& text, const std::string& path);

/// Whether a byte is part of such a character.
inline bool is_beyond_ascii(char c) {
  return (static_cast<unsigned char>(c) & 0x80) != 0;
}

}  // namespace vug
