#include "io/detail/range.hpp"

#include <fmt/format.h>

#include <cmath>

namespace vug {

bool Range::contains(double value) const {
  const bool above = low_open ? value > low : value >= low;
  const bool below = high_open ? value < high : value <= high;
  return above && below;
}

std::string Range::text() const {
  const bool has_low = std::isfinite(low);
  const bool has_high = std::isfinite(high);
  std::string text = "any";
  if (has_low && has_high && !low_open && !high_open) {
    text = fmt::format("{:g} ... {:g}", low, high);
  } else if (has_low || has_high) {
    text = has_low ? fmt::format("{} {:g}", low_open ? ">" : ">=", low) : "";
    if (has_high) text += fmt::format("{}{} {:g}", has_low ? ", " : "", high_open ? "<" : "<=", high);
  }
  return infinity_allowed ? text + " or inf" : text;
}

}  // namespace vug
