#pragma once
// How large generated triangles are to be.
#include "io/detail/line.hpp"
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

/// The part of the injection hole inside the rock. Throws InputError where it has no area.
std::optional<OrderedRectangle> hole_in_rock(Point length, const RockSection& rock);

double distance_to_rim(const Polygon& polygon, Point p);

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

}  // namespace vug::detail
