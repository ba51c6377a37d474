#pragma once
// The pixels of the geometry on the host, and how the fluid hangs together in them.
#include "coupling/geometry.hpp"

#include <array>
#include <cstddef>
#include <vector>

namespace vug {

/// Nodes of a plain row-by-row picture without halo.
class FluidPicture {
 public:
  FluidPicture(const Scene& scene, const Geometry& geometry);
  std::size_t size() const { return fluid_.size(); }
  std::size_t number(int x, int y) const { return static_cast<std::size_t>(y) * nx + x; }
  bool is_fluid(std::size_t n) const { return fluid_[n]; }
  std::size_t fluid_nodes() const;

  /// Calls visit(neighbour) for the eight around a node, as populations travel, that are on the lattice.
  template <class Visit>
  void for_each_neighbour(std::size_t n, const Visit& visit) const {
    const int x = static_cast<int>(n % nx), y = static_cast<int>(n / nx);
    for (int dy = -1; dy <= 1; ++dy)
      for (int dx = -1; dx <= 1; ++dx) {
        const int px = wrapped(x + dx, nx, periodic_[0]), py = wrapped(y + dy, ny, periodic_[1]);
        if ((dx != 0 || dy != 0) && px >= 0 && py >= 0) visit(number(px, py));
      }
  }

  const int nx, ny;

 private:
  static int wrapped(int at, int length, bool periodic) {
    if (at >= 0 && at < length) return at;
    return periodic ? (at + length) % length : -1;
  }
  std::array<bool, 2> periodic_;
  std::vector<bool> fluid_;
};

/// Numbers the pieces of connected fluid from 0; -1 in rock.
std::vector<int> pieces_of(const FluidPicture& picture);

/// Nodes of fluid in pieces that reach from one side of the lattice to the opposite one.
struct JoinedPores {
  std::size_t along_x = 0, along_y = 0;  ///< nodes: left to right, bottom to top
  std::vector<bool> either;              ///< (node) of one kind or both
};
JoinedPores joined_pores(const FluidPicture& picture);

}  // namespace vug
