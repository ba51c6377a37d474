#pragma once
// Points that keep a distance of their own from each other (Bridson's growth from the points already there).
#include "io/detail/delaunay.hpp"
#include "kernels/base/splitmix64.hpp"

#include <functional>
#include <vector>

namespace vug::detail {

/// Places that new points must keep clear of, in square cells.
class KeepOut {
 public:
  /// `reach` is the largest distance that any place and newcomer keep.
  KeepOut(Point length, double reach);
  /// A point: a newcomer keeps the mean of both spacings.
  void add_point(Point p, double spacing) { add({p, spacing / 2, 0.5}); }
  /// A disc that stays empty.
  void add_disc(Point centre, double radius) { add({centre, radius, 0}); }
  bool allows(Point p, double spacing) const;

 private:
  struct Place {
    Point centre;
    double own, share;  // distance kept = own + share × the newcomer's spacing
  };
  void add(const Place& place);
  int cell(double coordinate, int axis) const;

  double width_;
  std::array<int, 2> cells_;
  std::vector<std::vector<Place>> places_;
};

/// Appends points to `points` until no more fit: each keeps `spacing(p)` from all others, lies where `inside(p)` holds
/// and is allowed by `keep_out`, which already knows the first points.
void fill_with_points(std::vector<Point>& points, KeepOut& keep_out, const std::function<double(Point)>& spacing,
                      const std::function<bool(Point)>& inside, CounterRandom random);

}  // namespace vug::detail
