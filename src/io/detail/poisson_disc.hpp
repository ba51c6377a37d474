#pragma once
// Points that each keep a distance of their own from all others (Bridson's algorithm, which grows from given points).
#include "base/splitmix64.hpp"
#include "io/detail/delaunay.hpp"

#include <functional>
#include <vector>

namespace vug::detail {

/// Places from which new points must keep a distance, sorted into square cells.
class KeepOut {
 public:
  /// `reach` is the largest distance that a new point must keep from any place.
  KeepOut(Point length, double reach);
  /// Adds a point, from which a new point keeps the mean of both spacings.
  void add_point(Point p, double spacing) { add({p, spacing / 2, 0.5}); }
  /// Adds a disc that stays empty.
  void add_disc(Point centre, double radius) { add({centre, radius, 0}); }
  bool allows(Point p, double spacing) const;

 private:
  struct Place {
    Point centre;
    double own, share;  // distance to keep = own + share × spacing of the new point
  };
  void add(const Place& place);
  int cell(double coordinate, int axis) const;

  double width_;
  std::array<int, 2> cells_;
  std::vector<std::vector<Place>> places_;
};

/// Appends points to `points` until no more fit. Each keeps `spacing(p)` from all others, lies where `inside(p)` holds
/// and is allowed by `keep_out`, which must already contain the given points.
void fill_with_points(std::vector<Point>& points, KeepOut& keep_out, const std::function<double(Point)>& spacing,
                      const std::function<bool(Point)>& inside, CounterRandom random);

}  // namespace vug::detail
