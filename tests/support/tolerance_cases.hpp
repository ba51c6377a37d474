#pragma once
// What tests of accuracy.tolerance share: the settings that they hold against each other, and columns of histories.
#include "io/history_reader.hpp"

#include <fmt/format.h>

#include <string>
#include <vector>

namespace vug::test {

inline const std::vector<double>& column(const History& history, const std::string& name) {
  return history.values.at(history.find(name));
}

/// Every step of everything.
inline const std::string finest =
    "[accuracy]\nupdate_interval = 1\nwall_interval = 1\nheat_interval = 1\nsolute_interval = 1\nexchange_interval = "
    "1\n";

inline std::string with_tolerance(double tolerance) {
  return fmt::format("[accuracy]\ntolerance = {}\nprecision = \"double\"\n", tolerance);
}

}  // namespace vug::test
