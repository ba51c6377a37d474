#pragma once
// How a ramped preload ended, in numbers and in words.
#include "dem/monitors.hpp"

#include <string>

namespace vug {

/// How the preload ended.
struct PreloadReport {
  long steps = 0;
  double time = 0;       ///< of mechanics, s
  double crossings = 0;  ///< of sound through the rock in that time
  bool settled = false;  ///< kinetic energy fell below 1e-9 of the elastic one
  double kinetic_over_elastic = 0;
  BondCounts bonds;  ///< damage that the preload did
};

/// One line about rock that did not come to rest; nothing about rock that did.
std::string unrest_of(const PreloadReport& report);

}  // namespace vug
