#include "coupling/strip.hpp"

#include "coupling/cells.hpp"

#include <algorithm>
#include <cmath>

namespace vug {

namespace {

using Point = std::array<double, 2>;
using BySlope = std::array<double, 11>;  ///< at slopes of 0, 0.1, ... 1

double interpolated(const BySlope& values, double slope) {
  const int left = std::min(9, static_cast<int>(10 * slope));
  return values[left] + (10 * slope - left) * (values[left + 1] - values[left]);
}

/// Number of columns by which a run of columns with n + 1 nodes, between columns with n, counts as shorter than it is:
/// positive where the fluid has to spread at its beginning and gather at its end, negative where it cuts a corner of
/// the staircase. Measured with Stokes flow along cracks of five bonds (verification/pathway_strip_test.cpp).
double columns_lost(int n, double slope) {
  constexpr BySlope one_or_two{0.14, 0.03, -0.09, -0.25, -0.31, -0.06, 0, -0.05, -0.2, -0.3, 0},
      two_or_three{0.49, -0.05, -0.20, -0.30, -0.29, -0.31, -0.34, -0.43, -0.34, -0.10, 0.22},
      more{0.93, 0.40, 0.03, -0.09, -0.08, -0.22, -0.20, -0.30, -0.34, -0.12, 0.41};
  return interpolated(n == 1 ? one_or_two : n == 2 ? two_or_three : more, slope);
}

/// A segment in cells, with coordinates along and across the axis that it follows more closely; columns are across it.
class Line {
 public:
  Line(const Point& a, const Point& b)
      : steep_(std::abs(b[1] - a[1]) > std::abs(b[0] - a[0]) + tie), from_(turned(a)), to_(turned(b)) {
    if (from_[0] > to_[0]) std::swap(from_, to_);
    slope_ = (to_[1] - from_[1]) / (to_[0] - from_[0]);
  }

  /// The smallest aperture that opens the cell with its lower left corner at (x, y).
  double opening_aperture(int x, int y) const {
    const Point cell = turned({static_cast<double>(x), static_cast<double>(y)});
    if (passes(cell)) return 1;
    const Point centre{cell[0] + 0.5, cell[1] + 0.5};
    return std::max(across(centre), 2 * beyond(centre));
  }

 private:
  Point turned(const Point& p) const { return steep_ ? Point{p[1], p[0]} : p; }
  double height(double along) const { return snapped(from_[1] + slope_ * (along - from_[0])); }

  /// Whether the segment passes through the cell; one along a boundary of cells passes through the lower cell.
  bool passes(const Point& cell) const {
    const double first = std::max(cell[0], from_[0]), last = std::min(cell[0] + 1, to_[0]);
    if (last - first < tie) return false;
    const auto [low, high] = std::minmax({height(first), height(last)});
    return cell[1] >= std::ceil(low) - 1 && cell[1] <= std::ceil(high) - 1;
  }

  /// The same for the strip of the whole line, whose columns open one after another.
  double across(const Point& centre) const {
    const double rise = std::abs(slope_), offset = 2 * snapped(centre[1] - height(centre[0]));
    if (offset >= -1 - rise - tie && offset < 1 + rise - tie) return 1;
    const int nearer = static_cast<int>(offset < 0 ? std::ceil(-offset) - 1 : std::floor(offset));  // in its column
    // share of columns that are open when half of this one is to open
    const double columns = to_[0] - from_[0], lost = columns_lost(nearer, rise);
    const double all = std::floor(to_[0] + 0.5) - std::floor(from_[0] + 0.5);  // with their centres between the ends
    const auto length = [&](int run) { return run == 0 ? 0 : run >= all ? all : run - lost; };
    const int nth = place(centre[0]);
    const double share = std::min(1.0, (length(nth - 1) + length(nth)) / (2 * columns));
    return slot_aperture(1 / ((1 - share) / slot_conductivity(strip_aperture(nearer, rise)) +
                              share / slot_conductivity(strip_aperture(nearer + 1, rise))));
  }

  /// Its place, from 1, in the order in which columns open: from the middle outwards, on both sides in turn.
  int place(double column) const {
    const double middle = (from_[0] + to_[0]) / 2, first = std::floor(middle) + 0.5;
    const int away = static_cast<int>(column - first);
    const bool nearer = away != 0 && (away < 0) != (first < middle);  // than the column as far away on the other side
    return 2 * std::abs(away) + (nearer ? 0 : 1);
  }

  /// Distance from the end, for a point beyond an end of the segment; otherwise 0.
  double beyond(const Point& p) const {
    const double along = (p[0] - from_[0]) + slope_ * (p[1] - from_[1]);
    if (along < 0) return std::hypot(p[0] - from_[0], p[1] - from_[1]);
    if (along > (1 + slope_ * slope_) * (to_[0] - from_[0])) return std::hypot(p[0] - to_[0], p[1] - to_[1]);
    return 0;
  }

  bool steep_;
  Point from_, to_;
  double slope_ = 0;
};

}  // namespace

double strip_aperture(int n, double slope) {
  if (n == 1) return narrowest_aperture(slope);
  // Width that the steps of the walls take from the geometric width n cos(angle), at slopes of 0, 0.1, ... 1. Measured
  // with Stokes flow (verification/pathway_strip_test.cpp); the same for all n above two.
  constexpr BySlope of_two{0, 0.120, 0.187, 0.212, 0.213, 0.193, 0.229, 0.232, 0.215, 0.186, 0.150},
      of_more{0, 0.117, 0.184, 0.197, 0.184, 0.165, 0.184, 0.183, 0.172, 0.142, 0.080};
  return n / std::sqrt(1 + slope * slope) - interpolated(n == 2 ? of_two : of_more, slope);
}

std::vector<StripNode> strip_nodes(const Point& a, const Point& b, double aperture, const Lattice& lattice,
                                   double spacing) {
  const Point p{a[0] / spacing, a[1] / spacing}, q{b[0] / spacing, b[1] / spacing};
  const Line line(p, q);
  const double reach = aperture / std::sqrt(2.0) + 2;  // across the line, along the axis, with an allowance for steps
  const auto first = [&](int axis) {
    return std::max(0, static_cast<int>(std::floor(std::min(p[axis], q[axis]) - reach)));
  };
  const auto last = [&](int axis, int length) {
    return std::min(length - 1, static_cast<int>(std::ceil(std::max(p[axis], q[axis]) + reach)));
  };
  std::vector<StripNode> strip;
  for (int y = first(1); y <= last(1, lattice.ny); ++y)
    for (int x = first(0); x <= last(0, lattice.nx); ++x) {
      const double least = line.opening_aperture(x, y) - tie;
      if (least <= aperture) strip.push_back({y * lattice.nx + x, least});
    }
  return strip;
}

}  // namespace vug
