#pragma once
// One attempt at the mesh of a rock: points at random, Delaunay triangles, smoothing.
#include "dem/assembly.hpp"
#include "io/assembly_quality.hpp"
#include "io/detail/disc_outline.hpp"
#include "io/detail/poisson_disc.hpp"
#include "io/detail/rock_outline.hpp"

#include <array>
#include <cstdint>
#include <variant>
#include <vector>

namespace vug::detail {

/// What stays the same between several attempts to make a mesh.
class RockMesher {
 public:
  /// A rectangle [0, length_[0]] × [0, length_[1]], less the holes.
  RockMesher(Point length_, const RockSection& rock);
  /// A disc between flats. Of `rock` only element size and seed are used.
  RockMesher(DiscOutline disc, const RockSection& rock);

  /// The mesh from the points of one stream of random numbers, or what is wrong with it.
  std::variant<Assembly, Flaw> attempt(std::uint64_t stream) const;

  const Point length;
  const ElementSize size;
  const Outline outline;

 private:
  using Triangles = std::vector<std::array<int, 3>>;

  bool in_hole(Point p) const { return (outline.hole && outline.hole->contains(p, 0)) || outline.in_holes(p); }
  bool in_disc(Point p) const;
  bool in_rock(Point p) const;
  // Discs around the edges of the outline; when they stay empty, these edges are Delaunay.
  KeepOut edge_discs(double factor) const;
  std::vector<Point> scatter(std::uint64_t stream) const;
  void smooth(std::vector<Point>& points, const Triangles& triangles) const;
  Assembly assemble(const std::vector<Point>& points, const Triangles& triangles) const;

  IntegerGrid grid_;
  AssemblyLimits limits_;
};

}  // namespace vug::detail
