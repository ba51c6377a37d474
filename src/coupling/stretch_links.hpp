#pragma once
// The links of one stretch of boundary or of an opening, and what has come in through them.
#include "coupling/geometry.hpp"
#include "kernels/flow/open_boundary.hpp"
#include "kernels/launch/long_sum.hpp"
#include "kernels/nodes/opening.hpp"

#include <vector>

namespace vug {

/// A stretch of boundary with the links that leave through it. The kernels add to `gain` per link; births may change
/// the links, so what they had gained is summed into `entered` first.
struct StretchLinks {
  Stretch stretch;
  BoundaryLinks links;
  LongSum gain;                 ///< (link)
  double entered = 0;           ///< sum over links of former times, lattice units
  double looked = 0;            ///< total() when it was last looked whether the flow is steady
  ScalarField<double> area{};   ///< (link) surface it stands for, cells; of given speeds and fluxes only
  ScalarField<double> share{};  ///< (link) of a given velocity (velocity_profile.hpp); empty: all of it
  double inflow = 0;            ///< cells per unit of speed; of given flow rates only
  IndexList mirror{};           ///< (link) see mirror_links.hpp; of pressures and outflows only
  OutflowState outflow{};       ///< of outflows only

  void find(const Exec& exec, const FluidNodes& fluid, int directions, const SideOrder& order = all_sides) {
    entered = total();
    links = stretch.opening
                ? find_opening_links(exec, fluid, *stretch.opening, directions)
                : find_boundary_links(exec, fluid, stretch.side, stretch.first, stretch.last, directions, order);
    gain = LongSum("vug::boundary::gain", links.count);
  }
  /// Everything that has entered so far; waits for the device.
  double total() const { return entered + gain.total(); }
};

}  // namespace vug
