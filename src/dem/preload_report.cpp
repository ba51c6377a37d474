#include "dem/preload_report.hpp"

#include <array>
#include <cstdio>

namespace vug {

std::string unrest_of(const PreloadReport& report) {
  if (report.settled) return {};
  std::array<char, 400> line;
  std::snprintf(line.data(), line.size(),
                "the preload did not come to rest: after %.3g s, %.0f crossings of sound through the rock, its kinetic "
                "energy is %.2g of the elastic one, where 1e-9 is rest; the rock was stopped there: something slides, "
                "breaks or is held by nothing (mechanics.preload)",
                report.time, report.crossings, report.kinetic_over_elastic);
  return line.data();
}

}  // namespace vug
