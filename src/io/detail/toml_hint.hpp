#pragma once
// What to write instead, for the mistakes that new users of TOML make.
#include <string>
#include <string_view>

namespace vug {

/// What to write instead in a line that is not valid TOML: quotes around a value with a unit or around a path, a
/// decimal point, / in a path, true for yes, = for a colon. Empty where the line shows none of these mistakes.
std::string hint_on(std::string_view line);

/// The line of this number, counted from 1; empty beyond the last.
std::string_view line_of(std::string_view text, std::size_t number);

/// Whether a comma stands between two digits, as in "1,2 mm".
bool has_decimal_comma(std::string_view text);

}  // namespace vug
