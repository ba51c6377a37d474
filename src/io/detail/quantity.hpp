#pragma once
// Numbers written as text with a unit of their own: "10 MPa", "15 degC", "3 mol/L".
#include "io/detail/range.hpp"

#include <optional>
#include <string>
#include <string_view>

namespace vug {

/// The value, in `unit`, of a text with a number and a unit; nothing when its form is not accepted.
std::optional<double> parse_quantity(std::string_view text, Unit unit);

/// The units that may be written where `unit` is expected, for messages: "Pa, kPa, MPa, GPa, bar".
std::string accepted_units(Unit unit);

}  // namespace vug
