#pragma once
// The pixels of the geometry on the host, and how the fluid in them is connected.
#include "coupling/geometry.hpp"

#include <array>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace vug {

/// Nodes of a picture stored row by row without halo.
class FluidPicture {
 public:
  FluidPicture(const Scene& scene, const Geometry& geometry);
  std::size_t size() const { return fluid_.size(); }
  std::size_t number(int x, int y) const { return static_cast<std::size_t>(y) * nx + x; }
  /// The node at `along` beside a side.
  std::size_t beside(Side side, int along) const {
    if (is_upright(side)) return number(side == Side::left ? 0 : nx - 1, along);
    return number(along, side == Side::bottom ? 0 : ny - 1);
  }
  bool is_fluid(std::size_t n) const { return fluid_[n]; }
  std::size_t fluid_nodes() const;

  /// Calls visit(neighbour) for those of the eight nodes around a node that are on the lattice, with joined sides.
  template <class Visit>
  void for_each_neighbour(std::size_t n, const Visit& visit) const {
    for (int dy = -1; dy <= 1; ++dy)
      for (int dx = -1; dx <= 1; ++dx) {
        const std::optional<std::size_t> m = from(n, dx, dy);
        if ((dx != 0 || dy != 0) && m) visit(*m);
      }
  }
  /// The same for the four nodes that share a face with it.
  template <class Visit>
  void for_each_beside(std::size_t n, const Visit& visit) const {
    for (const auto& [dx, dy] : {std::array{1, 0}, {-1, 0}, {0, 1}, {0, -1}})
      if (const std::optional<std::size_t> m = from(n, dx, dy)) visit(*m);
  }
  /// Goes through the fluid from some of its nodes: calls visit(front, within) with the nodes at one distance after the
  /// other, each one step to any of eight neighbours on, and with all nodes so far, until it returns false.
  template <class Visit>
  void for_each_front(std::vector<std::size_t> front, const Visit& visit) const {
    std::vector<bool> within(size(), false);
    for (const std::size_t n : front) within[n] = true;
    while (!front.empty() && visit(front, within)) {
      std::vector<std::size_t> next;
      for (const std::size_t n : front)
        for_each_neighbour(n, [&](std::size_t m) {
          if (within[m] || !is_fluid(m)) return;
          within[m] = true;
          next.push_back(m);
        });
      front = std::move(next);
    }
  }
  /// The node at a distance from another one; none off the lattice, unless sides are joined.
  std::optional<std::size_t> from(std::size_t n, int dx, int dy) const {
    const int x = wrapped(static_cast<int>(n % nx) + dx, nx, periodic_[0]);
    const int y = wrapped(static_cast<int>(n / nx) + dy, ny, periodic_[1]);
    return x >= 0 && y >= 0 ? std::optional(number(x, y)) : std::nullopt;
  }

  /// Whether the sides at both ends of an axis are joined.
  bool joined(int axis) const { return periodic_[axis]; }

  const int nx, ny;

 private:
  static int wrapped(int at, int length, bool periodic) {
    if (at >= 0 && at < length) return at;
    return periodic ? (at + length) % length : -1;
  }
  std::array<bool, 2> periodic_;
  std::vector<bool> fluid_;
};

/// What joins fluid nodes: corners and faces, as for the flow, or faces alone, as for scalars on D2Q5.
enum class JoinedBy { corners, faces };

/// Numbers the connected pieces of fluid from 0; -1 in rock.
std::vector<int> pieces_of(const FluidPicture& picture, JoinedBy joined = JoinedBy::corners);

/// Fluid nodes in pieces that extend from one side of the lattice to the opposite one; where these are joined, in
/// pieces that lead through them back to where they began.
struct JoinedPores {
  std::size_t along_x = 0, along_y = 0;  ///< number of nodes: left to right, bottom to top
  std::vector<bool> either;              ///< (node) in a piece of either kind
};
JoinedPores joined_pores(const FluidPicture& picture, JoinedBy joined = JoinedBy::corners);

}  // namespace vug
