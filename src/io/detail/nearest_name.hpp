#pragma once
// The name that a user probably meant.
#include <span>
#include <string>
#include <string_view>

namespace vug {

/// Number of single-character insertions, deletions, replacements and swaps of neighbours that turn `a` into `b`.
int edit_distance(std::string_view a, std::string_view b);

/// The candidate with the least edit distance to `name` (the first of equals), empty when there is none.
std::string nearest_name(std::string_view name, std::span<const std::string> candidates);

/// "; did you mean "x"?" when a candidate goes on where the name ends ("time_s" for "time"; the shortest of several),
/// or is close; otherwise nothing.
std::string likely_name(std::string_view name, std::span<const std::string> candidates);

/// The same; where no candidate is close, "; valid are a, b, c".
std::string suggestion(std::string_view name, std::span<const std::string> candidates);

}  // namespace vug
