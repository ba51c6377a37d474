#pragma once
// The lines that a generated mesh must contain: the sides of the rock, the rim of the hole, the notches.
#include "io/detail/delaunay.hpp"
#include "io/form.hpp"

#include <optional>
#include <vector>

namespace vug::detail {

/// Rectangle, corners ordered.
struct OrderedRectangle {
  Point low, high;
  bool contains(Point p, double margin) const {
    return p[0] > low[0] - margin && p[1] > low[1] - margin && p[0] < high[0] + margin && p[1] < high[1] + margin;
  }
};

/// Wanted edge length at a point: linear in the distance from the holes (or the notches), scaled so that the mean over
/// all edges is the element size of the case.
class ElementSize {
 public:
  ElementSize(Point length, const RockSection& rock);
  double operator()(Point p) const;
  double largest() const { return finest_ * grading_; }

 private:
  double relative(Point p) const;
  double distance(Point p) const;

  std::optional<OrderedRectangle> hole_;
  std::vector<Notch> notches_;
  std::vector<Polygon> holes_;
  double grading_ = 1, reach_ = 0, finest_ = 1;
};

/// Points along the lines, and the edges between them.
struct Outline {
  struct Edge {
    int a, b;
    bool notch;
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
};

Outline rock_outline(Point length, const RockSection& rock, const ElementSize& size);

}  // namespace vug::detail
