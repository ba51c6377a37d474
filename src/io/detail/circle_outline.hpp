#pragma once
// Circles as polygons that have a corner wherever something crosses the circle.
#include "io/detail/line.hpp"
#include "io/form.hpp"

#include <vector>

namespace vug::detail {

/// Points at which a straight line crosses or touches a circle, or ends on it within `tolerance`.
std::vector<Point> crossings(const Disc& circle, const Line& line, double tolerance);
/// The two points at which two circles cross; none for circles that only touch, and for the same circle.
std::vector<Point> crossings(const Disc& a, const Disc& b, double tolerance);

/// The corners, counter-clockwise, of a polygon on a circle with sides of about `edge`. Without crossings it is
/// outline_of. Otherwise every crossing is a corner, and each arc between two of them is divided evenly, into at least
/// eight sides per turn. Crossings that are closer to each other than `tolerance` count once.
std::vector<Point> polygon_of(const Disc& circle, double edge, const std::vector<Point>& crossings, double tolerance);

}  // namespace vug::detail
