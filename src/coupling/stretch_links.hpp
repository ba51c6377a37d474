#pragma once
// The links of a stretch of boundary or of an opening, and what has entered through them.
#include "coupling/geometry.hpp"
#include "kernels/flow/open_boundary.hpp"
#include "kernels/launch/long_sum.hpp"
#include "kernels/nodes/opening.hpp"

#include <array>
#include <vector>

namespace vug {

/// An end of a stretch of a side: the diagonal link that leads past it. Of a pressure or an outflow only where a
/// velocity is given beyond on the same side.
struct StretchEnd {
  /// What is past it: nothing that takes part; a corner with an open side; a corner with a wall or a given velocity; a
  /// wall or a given velocity on the same side.
  enum class Beyond { nothing, open_corner, corner, same_side };
  Beyond beyond = Beyond::nothing;
  int link = -1;                      ///< in the list of the stretch; -1: none, or the stretch beyond the corner has it
  int other = -1;                     ///< number of the stretch beyond whose velocity counts as well; -1: none
  double share = 1, other_share = 1;  ///< of the velocities of both stretches, at the end
};

/// A stretch of boundary with the links that leave through it. Kernels add to `gain` for each link. Births may change
/// the links; their gains are added to `entered` before.
struct StretchLinks {
  Stretch stretch;
  BoundaryLinks links;
  LongSum gain;                      ///< (link)
  double entered = 0;                ///< sum over former links, lattice units
  double looked = 0;                 ///< total() at the last look (steady_flow.hpp)
  ScalarField<double> area{};        ///< (link) surface of the link, cells; only for given speeds and fluxes
  ScalarField<double> share{};       ///< (link) of a given velocity (velocity_profile.hpp); empty: 1
  double inflow = 0;                 ///< cells per unit of speed; only for given flow rates
  IndexList mirror{};                ///< (link) see find_mirror_links; only for pressures and outflows
  OutflowState outflow{};            ///< only for outflows
  std::array<StretchEnd, 2> ends{};  ///< lower or left, and upper or right; only of sides
  bool slides = false;               ///< a velocity along the side acts on its links, its own or of a stretch beyond
  IndexList image{};                 ///< (link) see find_mirror_links; only where it slides
  /// (end) of a pressure or an outflow beside another one; else empty.
  Kokkos::View<LinkPastEnd*> past{};

  void find(const Exec& exec, const FluidNodes& fluid, int directions, const SideOrder& order = all_sides) {
    entered = total();
    links = stretch.opening
                ? find_opening_links(exec, fluid, *stretch.opening, directions)
                : find_boundary_links(exec, fluid, stretch.side, stretch.first, stretch.last, directions, order);
    gain = LongSum("vug::boundary::gain", links.count);
  }
  /// All that has entered so far, lattice units; waits for the device.
  double total() const { return entered + gain.total(); }
};

}  // namespace vug
