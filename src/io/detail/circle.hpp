#pragma once
// Points on a circle by its rational parametrisation: without sines, so that they have the same bits on every machine.
#include <array>
#include <cmath>

namespace vug::detail {

/// tan x for 0 <= x <= pi/4 by a fraction that is accurate to 1e-3. Its error affects only how evenly the points lie.
inline double tangent(double x) {
  return x * (15 - x * x) / (15 - 6 * x * x);
}

/// The x whose `tangent` is t, for 0 <= t <= 1.
inline double arc_tangent(double t) {
  double low = 0, high = 1;
  for (int halving = 0; halving < 60; ++halving) {
    const double middle = (low + high) / 2;
    (tangent(middle) < t ? low : high) = middle;
  }
  return low;
}

constexpr double eighth_of_a_turn = 0.7855044319574624;  ///< tangent of it is 1

/// Point of the circle around the origin at the angle whose half has the tangent `t`.
inline std::array<double, 2> on_circle(double radius, double t) {
  return {radius * (1 - t * t) / (1 + t * t), radius * 2 * t / (1 + t * t)};
}

/// A vector of the first quarter of a turn, turned by so many quarters.
inline std::array<double, 2> turned(std::array<double, 2> p, int quarters) {
  return quarters == 0   ? p
         : quarters == 1 ? std::array{-p[1], p[0]}
         : quarters == 2 ? std::array{-p[0], -p[1]}
                         : std::array{p[1], -p[0]};
}

/// How far around the origin a vector is from the x axis, in turns, 0 to 1; exact at every quarter, elsewhere as even
/// as `tangent`.
inline double turns_of(std::array<double, 2> p) {
  const int quarters = p[1] >= 0 ? (p[0] > 0 ? 0 : 1) : (p[0] < 0 ? 2 : 3);
  const auto [x, y] = turned(p, (4 - quarters) % 4);
  return (quarters + arc_tangent(y / (std::sqrt(x * x + y * y) + x)) / eighth_of_a_turn) / 4;
}

/// The unit vector so many turns (0 or more) from the x axis: the inverse of turns_of.
inline std::array<double, 2> unit_at_turns(double turns) {
  const double quarters = 4 * turns, whole = std::floor(quarters);
  return turned(on_circle(1, tangent(eighth_of_a_turn * (quarters - whole))), static_cast<int>(whole) % 4);
}

}  // namespace vug::detail
