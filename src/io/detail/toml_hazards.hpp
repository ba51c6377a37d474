#pragma once
// Texts that toml++ cannot bear: they are found, and refused, before it sees them.
#include <string>

namespace vug {

/// Throws InputError naming the line of a table header that begins with no key, which toml++ takes for impossible, or
/// of a key of more than a hundred levels, for which it would nest tables until the stack ends. `path` is for messages.
void refuse_toml_hazards(const std::string& text, const std::string& path);

}  // namespace vug
