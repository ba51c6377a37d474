#include "coupling/fluid_picture.hpp"

#include <algorithm>

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

JoinedPores joined_pores(const FluidPicture& picture) {
  const std::vector<int> piece = pieces_of(picture);
  constexpr unsigned left = 1, right = 2, bottom = 4, top = 8;
  std::vector<unsigned> touched(1 + static_cast<std::size_t>(*std::max_element(piece.begin(), piece.end())), 0);
  const auto touch = [&](int x, int y, unsigned side) {
    if (const int p = piece[picture.number(x, y)]; p >= 0) touched[p] |= side;
  };
  for (int y = 0; y < picture.ny; ++y) {
    touch(0, y, left);
    touch(picture.nx - 1, y, right);
  }
  for (int x = 0; x < picture.nx; ++x) {
    touch(x, 0, bottom);
    touch(x, picture.ny - 1, top);
  }
  JoinedPores joined;
  joined.either.resize(piece.size());
  for (std::size_t n = 0; n < piece.size(); ++n) {
    if (piece[n] < 0) continue;
    const bool x = (touched[piece[n]] & (left | right)) == (left | right);
    const bool y = (touched[piece[n]] & (bottom | top)) == (bottom | top);
    joined.along_x += x;
    joined.along_y += y;
    joined.either[n] = x || y;
  }
  return joined;
}

}  // namespace vug
