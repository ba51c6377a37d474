#pragma once
// Result of a ramped preload, in numbers and in words.
#include "dem/monitors.hpp"

#include <string>

namespace vug {

/// Result of a ramped preload.
struct PreloadReport {
  long steps = 0;
  double time = 0;       ///< of mechanics, s
  double crossings = 0;  ///< crossings of the rock by sound in that time
  bool settled = false;  ///< kinetic energy fell below 1e-9 of the elastic one
  double kinetic_over_elastic = 0;
  BondCounts bonds;  ///< damage that the preload did
};

/// One line about rock that did not come to rest; empty if it did.
std::string unrest_of(const PreloadReport& report);

}  // namespace vug
