#pragma once
// Points on a circle by its rational parametrisation: without sines, so that they have the same bits on every machine.
#include <array>

namespace vug::detail {

/// tan x for 0 <= x <= pi/4 by a fraction that is accurate to 1e-3. Its error affects only how evenly the points lie.
inline double tangent(double x) {
  return x * (15 - x * x) / (15 - 6 * x * x);
}

/// Point of the circle around the origin at the angle whose half has the tangent `t`.
inline std::array<double, 2> on_circle(double radius, double t) {
  return {radius * (1 - t * t) / (1 + t * t), radius * 2 * t / (1 + t * t)};
}

}  // namespace vug::detail
