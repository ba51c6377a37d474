#include "coupling/limit_text.hpp"

#include <fmt/format.h>

#include <cmath>
#include <string_view>

namespace vug {

namespace {

std::string range_in(const Limit& limit, int digits) {
  if (std::isinf(limit.low) && std::isinf(limit.high)) return "";
  if (std::isinf(limit.high)) return fmt::format(">= {:.{}g}", limit.low, digits);
  return fmt::format("{:.{}g} to {:.{}g}", limit.low, digits, limit.high, digits);
}

}  // namespace

std::string range_of(const Limit& limit) {
  return range_in(limit, 4);
}

std::string warning_of(const Limit& limit) {
  const double bound = limit.value < limit.low ? limit.low : limit.high;
  int digits = 4;
  std::string advice = limit.advice;
  if (const std::string_view change = "change "; advice.starts_with(change))
    advice.replace(0, change.size(), limit.value < limit.low ? "raise " : "lower ");
  while (digits < 17 && fmt::format("{:.{}g}", limit.value, digits) == fmt::format("{:.{}g}", bound, digits)) ++digits;
  return fmt::format("{}: {} = {:.{}g} is outside {}; {}", limit.module, limit.name, limit.value, digits,
                     range_in(limit, digits), advice);
}

}  // namespace vug
