#pragma once
// The lines that a generated mesh must contain: the sides of the rock, the rim of the hole, the notches.
#include "io/detail/element_size.hpp"

#include <optional>
#include <string>
#include <vector>

namespace vug::detail {

/// Points along the lines, and the edges between them.
struct Outline {
  struct Edge {
    int a, b;
    bool notch;
    int shape;  ///< index in `shapes`
  };
  std::optional<OrderedRectangle> hole;  ///< the part of it inside the rock
  std::vector<Polygon> holes;
  double tie = 0;                ///< m, distance within which a point counts as on the rim of one of `holes`
  bool in_holes(Point p) const;  ///< in one of `holes` and not on its rim
  /// The outline is convex and lies inside its rectangle, whose corners, the first four points, do not belong to the
  /// rock.
  bool round = false;
  std::vector<Point> points;
  std::vector<Edge> edges;
  std::vector<std::string> shapes;  ///< what the edges belong to, as the case calls it
};

/// The outline of the rock of a case, in edges of about the wanted size. A circle becomes a polygon that has a corner
/// wherever a side, a notch or another outline crosses it. Throws InputError for a hole without area in the rock.
Outline rock_outline(Point length, const RockSection& rock, const ElementSize& size);

}  // namespace vug::detail
