#pragma once
// Derived numbers and their ranges in words.
#include "coupling/limits.hpp"

#include <string>

namespace vug {

/// "0 to 0.9", ">= 1"; empty where there is no bound.
std::string range_of(const Limit& limit);

/// One line for a number that is out of range: "flow: viscosity = 2 is outside 0 to 1; change ...", with as many digits
/// as distinguish the number from the bound.
std::string warning_of(const Limit& limit);

}  // namespace vug
