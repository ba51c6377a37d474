#pragma once
// Names of the files that belong to one lattice step.
#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <string>
#include <string_view>

namespace vug::detail {

inline constexpr std::string_view step_prefix = "step_";
inline constexpr std::size_t step_digits = 12;

/// "step_000000000120". Such names sort by step.
inline std::string step_name(std::int64_t step) {
  return fmt::format("{}{:0{}d}", step_prefix, step, step_digits);
}

/// Whether `name` is what step_name returns for some step; other files are not vug's.
inline bool is_step_name(std::string_view name) {
  if (!name.starts_with(step_prefix)) return false;
  const std::string_view digits = name.substr(step_prefix.size());
  return digits.size() >= step_digits && digits.size() < 19 &&
         std::all_of(digits.begin(), digits.end(), [](char c) { return c >= '0' && c <= '9'; });
}

}  // namespace vug::detail
