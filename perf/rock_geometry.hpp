#pragma once
// The geometries on which kernels are timed: the paper's kind of rock, and an open box.
#include "kernels/nodes/fluid_nodes.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <random>
#include <vector>

namespace vug::perf {

/// Fluid strips three nodes wide along a share of the edges of a distorted triangulation of mesh size 40 nodes: on
/// 2000 x 1400 nodes a share of 0.58 is fluid of about 15 % and 1 of about 25 %, as in the paper's rock.
class StripRock {
 public:
  StripRock(const Lattice& lattice, double share_of_edges) : lattice_(lattice) {
    std::uniform_real_distribution<double> offset(-0.3, 0.3);
    for (int j = 0; j < rows(); ++j)
      for (int i = 0; i < columns(); ++i) {
        const double x = (i - 0.5 + offset(random_) + (j % 2) * 0.5) * mesh_;
        points_.push_back({x, (j - 0.5 + offset(random_)) * mesh_});
      }
    type_ = Kokkos::View<NodeType*, Kokkos::HostSpace>("type", lattice.size());
    Kokkos::deep_copy(type_, NodeType::solid);
    for (int j = 0; j + 1 < rows(); ++j)
      for (int i = 0; i + 1 < columns(); ++i) {
        const int a = j * columns() + i;
        for (const auto& [from, to] : {std::pair{a, a + 1}, {a, a + columns()}, {a + 1, a + columns()}})
          if (share_(random_) < share_of_edges) open_strip(points_[from], points_[to]);
      }
  }

  Kokkos::View<NodeType*> type() const {
    Kokkos::View<NodeType*> device("type", type_.extent(0));
    Kokkos::deep_copy(device, type_);
    return device;
  }

 private:
  struct Point {
    double x, y;
  };
  int columns() const { return lattice_.nx / mesh_ + 2; }
  int rows() const { return lattice_.ny / mesh_ + 2; }

  void open_strip(const Point& a, const Point& b) {
    const double dx = b.x - a.x, dy = b.y - a.y, length2 = dx * dx + dy * dy;
    const auto lower = [](double u, double v) { return std::max(0, static_cast<int>(std::min(u, v) - 3)); };
    const auto upper = [](double u, double v, int n) { return std::min(n, static_cast<int>(std::max(u, v) + 4)); };
    for (int y = lower(a.y, b.y); y < upper(a.y, b.y, lattice_.ny); ++y)
      for (int x = lower(a.x, b.x); x < upper(a.x, b.x, lattice_.nx); ++x) {
        const double s = std::clamp(((x - a.x) * dx + (y - a.y) * dy) / length2, 0.0, 1.0);
        if (std::hypot(x - a.x - s * dx, y - a.y - s * dy) <= 1.5) type_(lattice_.node(x, y)) = NodeType::fluid;
      }
  }

  static constexpr int mesh_ = 40;
  Lattice lattice_;
  std::mt19937 random_{1};
  std::uniform_real_distribution<double> share_{0, 1};
  std::vector<Point> points_;
  Kokkos::View<NodeType*, Kokkos::HostSpace> type_;
};

struct Geometry {
  const char* name;
  double share_of_edges;  ///< of the strip rock; 0: an open box
};
inline constexpr Geometry geometries[] = {{"rock_15", 0.58}, {"rock_25", 1.0}, {"box", 0}};

/// Too large for most caches; with VUG_PERF_SMALL in the environment such that it fits.
inline Lattice timed_lattice() {
  return std::getenv("VUG_PERF_SMALL") ? Lattice(400, 280) : Lattice(2000, 1400);
}

/// Node types of a geometry on the lattice.
inline Kokkos::View<NodeType*> node_types(const Geometry& geometry, const Lattice& lattice) {
  if (geometry.share_of_edges > 0) return StripRock(lattice, geometry.share_of_edges).type();
  return Kokkos::View<NodeType*>("type", lattice.size());  // zero is fluid
}

}  // namespace vug::perf
