#pragma once
// Texts that toml++ cannot bear: they are found, and refused, before it sees them.
#include <string>

namespace vug {

/// Throws InputError naming the line of a table header that begins with no key, which toml++ takes for impossible; of a
/// key of more than a hundred levels, for which it would nest tables until the stack ends; of a character beyond ASCII
/// outside of strings and comments, where TOML 1.0 has none and toml++ 3.3 looks some up beyond the end of a table.
/// `path` is for messages.
void refuse_toml_hazards(const std::string& text, const std::string& path);

/// Whether a byte is part of such a character.
inline bool is_beyond_ascii(char c) {
  return (static_cast<unsigned char>(c) & 0x80) != 0;
}

}  // namespace vug
