#pragma once
// What drives fluid between boundaries with given pressures, also where a body force acts.
#include "io/scene/boundaries.hpp"
#include "io/units.hpp"

#include <algorithm>
#include <vector>

namespace vug {

/// Values that something has along a boundary and over time, from the lowest to the highest.
struct Span {
  double low = 0, high = 0;
  /// The shortest span that has both.
  Span with(const Span& other) const { return {std::min(low, other.low), std::max(high, other.high)}; }
};

/// Pressures that a boundary has in the run, lattice units; a ramp begins at the initial pressure, which is 0.
inline Span pressures_of(const FlowBoundary& flow, const LatticeUnits& units) {
  const Span given{units.lattice_pressure(flow.pressure.lowest()), units.lattice_pressure(flow.pressure.highest())};
  return flow.ramp_time > 0 ? Span{std::min(given.low, 0.0), std::max(given.high, 0.0)} : given;
}

/// Lowest and highest difference p_a - p_b of the pressures of two boundaries at one time of the run, lattice units; 0
/// where it is rounding. An outflow counts as a boundary at the initial pressure. Between the points of tables and
/// ramps the difference is a parabola: a ramp multiplies a table.
Span difference_over_time(const FlowBoundary& a, const FlowBoundary& b, const LatticeUnits& units);

/// Largest difference of the potential Phi = p - f.x that drives fluid, lattice units: between any two of `mouths` (the
/// boundaries with a given pressure), or between one of them and the fluid at the start, whose potential is
/// `start`, as far as it is outside of that. Fluid at rest under its weight has the same potential everywhere. 0
/// without `mouths`.
inline double largest_drive(const std::vector<Span>& mouths, const Span& start) {
  if (mouths.empty()) return 0;
  Span all = mouths.front();
  for (const Span& mouth : mouths) all = all.with(mouth);
  return std::max(all.high, start.low) - std::min(all.low, start.high);
}

}  // namespace vug
