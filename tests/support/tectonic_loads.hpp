#pragma once
// The outer stress of the paper's rock.
#include "dem/mechanics.hpp"

namespace vug::test {

/// Rollers on the left and at the bottom, 5 MPa from the right, 7.5 MPa from the top.
inline Loads tectonic() {
  Loads loads;
  loads.support[static_cast<std::size_t>(RockSide::left)] = Support::roller;
  loads.support[static_cast<std::size_t>(RockSide::bottom)] = Support::roller;
  loads.traction[static_cast<std::size_t>(RockSide::right)] = {-5e6, 0};
  loads.traction[static_cast<std::size_t>(RockSide::top)] = {0, -7.5e6};
  return loads;
}

}  // namespace vug::test
