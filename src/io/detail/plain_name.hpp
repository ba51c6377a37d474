#pragma once
// Names that a case may give.
#include <string>

namespace vug {

/// Whether a name can be part of a data set's name and of `--set`.
bool is_plain_name(const std::string& name);
/// The rule of is_plain_name, for messages.
inline constexpr const char* plain_name_rule =
    "must begin with a letter and hold at most 40 letters, digits, '_', '+' or '-'";

}  // namespace vug
