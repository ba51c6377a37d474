#include "coupling/fluid_picture.hpp"

#include <algorithm>
#include <array>
#include <limits>

namespace vug {

FluidPicture::FluidPicture(const Scene& scene, const Geometry& geometry)
    : nx(scene.lattice.nx), ny(scene.lattice.ny), periodic_(periodic_sides(scene)) {
  const auto type = on_host(geometry.type);
  fluid_.resize(static_cast<std::size_t>(nx) * ny);
  for (int y = 0; y < ny; ++y)
    for (int x = 0; x < nx; ++x) fluid_[number(x, y)] = type(geometry.lattice.node(x, y)) == NodeType::fluid;
}

std::size_t FluidPicture::fluid_nodes() const {
  return static_cast<std::size_t>(std::count(fluid_.begin(), fluid_.end(), true));
}

std::vector<int> pieces_of(const FluidPicture& picture, JoinedBy joined) {
  std::vector<int> piece(picture.size(), -1);
  std::vector<std::size_t> open;
  int count = 0;
  for (std::size_t n = 0; n < picture.size(); ++n) {
    if (piece[n] >= 0 || !picture.is_fluid(n)) continue;
    piece[n] = count;
    open.assign(1, n);
    while (!open.empty()) {
      const std::size_t at = open.back();
      open.pop_back();
      const auto visit = [&](std::size_t m) {
        if (piece[m] >= 0 || !picture.is_fluid(m)) return;
        piece[m] = count;
        open.push_back(m);
      };
      if (joined == JoinedBy::corners)
        picture.for_each_neighbour(at, visit);
      else
        picture.for_each_beside(at, visit);
    }
    ++count;
  }
  return piece;
}

namespace {

/// (axis, piece) Whether a piece leads across the lattice. Where sides are joined, every node gets the number of times
/// that the way to it has crossed them; a piece that reaches a node with two numbers leads around.
std::array<std::vector<bool>, 2> crossing_pieces(const FluidPicture& picture, JoinedBy by,
                                                 const std::vector<int>& piece) {
  const auto count = static_cast<std::size_t>(1 + *std::max_element(piece.begin(), piece.end()));
  std::array<std::vector<bool>, 2> crosses{std::vector<bool>(count), std::vector<bool>(count)};
  for (const int axis : {0, 1}) {
    const int length = axis == 0 ? picture.nx : picture.ny, across = axis == 0 ? picture.ny : picture.nx;
    const auto at_end = [&](int k, int end) { return axis == 0 ? picture.number(end, k) : picture.number(k, end); };
    if (!picture.joined(axis)) {
      std::vector<bool> begins(count);
      for (int k = 0; k < across; ++k)
        if (const int p = piece[at_end(k, 0)]; p >= 0) begins[p] = true;
      for (int k = 0; k < across; ++k)
        if (const int p = piece[at_end(k, length - 1)]; p >= 0 && begins[p]) crosses[axis][p] = true;
      continue;
    }
    constexpr int none = std::numeric_limits<int>::min();
    std::vector<int> turns(picture.size(), none);
    const auto place = [&](std::size_t n) { return static_cast<int>(axis == 0 ? n % picture.nx : n / picture.nx); };
    std::vector<std::size_t> open;
    for (std::size_t n = 0; n < picture.size(); ++n) {
      if (piece[n] < 0 || turns[n] != none) continue;
      turns[n] = 0;
      open.assign(1, n);
      while (!open.empty()) {
        const std::size_t at = open.back();
        open.pop_back();
        for (int dy = -1; dy <= 1; ++dy)
          for (int dx = -1; dx <= 1; ++dx) {
            if (by == JoinedBy::faces && dx != 0 && dy != 0) continue;
            const std::optional<std::size_t> m = picture.from(at, dx, dy);
            if (!m || piece[*m] < 0) continue;
            const int reached = place(at) + (axis == 0 ? dx : dy);
            const int there = turns[at] + (reached < 0 ? -1 : reached >= length ? 1 : 0);
            if (turns[*m] == none) {
              turns[*m] = there;
              open.push_back(*m);
            } else if (turns[*m] != there) {
              crosses[axis][piece[at]] = true;
            }
          }
      }
    }
  }
  return crosses;
}

}  // namespace

JoinedPores joined_pores(const FluidPicture& picture, JoinedBy by) {
  const std::vector<int> piece = pieces_of(picture, by);
  const auto crosses = crossing_pieces(picture, by, piece);
  JoinedPores joined;
  joined.either.resize(piece.size());
  for (std::size_t n = 0; n < piece.size(); ++n) {
    if (piece[n] < 0) continue;
    const bool x = crosses[0][piece[n]], y = crosses[1][piece[n]];
    joined.along_x += x;
    joined.along_y += y;
    joined.either[n] = x || y;
  }
  return joined;
}

}  // namespace vug
