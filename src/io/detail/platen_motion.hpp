#pragma once
// How fast a side of the rock is moved.
#include "io/scene/boundaries.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace vug {

/// Largest speed of a held side, max over t of |v(t)|, m/s: at a point of its table, as v is linear in between.
inline double fastest(const TractionLoad& load) {
  const auto speed = [&](double time) { return std::hypot(load.velocity[0].at(time), load.velocity[1].at(time)); };
  double largest = speed(0);
  for (const TimeTable& component : load.velocity)
    for (const double time : component.moments()) largest = std::max(largest, speed(time));
  return largest;
}

/// Time after which a held side is at rest for good, s; infinity where it never is.
inline double comes_to_rest(const TractionLoad& load) {
  double last = 0;
  for (const TimeTable& component : load.velocity) {
    if (component.at(component.settled()) != 0) return std::numeric_limits<double>::infinity();
    last = std::max(last, component.settled());
  }
  return last;
}

}  // namespace vug
