#pragma once
// Which pairs of triangles may touch: those near each other that neither faces nor bonds keep apart.
#include "dem/closest_point.hpp"
#include "dem/contacts.hpp"
#include "dem/neighbour_grid.hpp"

namespace vug {

// Used by neighbour_grid.cpp only.
namespace {

/// Pairs closer than the skin, found by the cells of the grid that their centroids lie in.
struct PairCandidates {
  NeighbourGrid grid;
  double skin;
  Particles p;
  Bonds bonds;

  KOKKOS_FUNCTION Vec2 centre(int i) const { return {p.x0(i, 0) + p.u(i, 0), p.x0(i, 1) + p.u(i, 1)}; }
  KOKKOS_FUNCTION int cell_of(int i) const {
    const Vec2 x = centre(i);
    return grid.line(x.y) * grid.nx + grid.column(x.x);
  }

  KOKKOS_FUNCTION Triangle outline(int i) const {
    const Rotation rotation{p.rotation(i, 0), p.rotation(i, 1)};
    Triangle t;
    for (int c = 0; c < 3; ++c) t.corner[c] = centre(i) + rotation.turn({p.eroded(i, c, 0), p.eroded(i, c, 1)});
    return t;
  }

  /// Whether a bond, or the crack that it left, already transmits the forces between the two.
  KOKKOS_FUNCTION bool joined(int i, int j) const {
    for (int e = bonds.row(i); e < bonds.row(i + 1); ++e) {
      const int k = bonds.entry(e) / 2, end = bonds.entry(e) % 2;
      if (bonds.pair(k, 1 - end) == j && bonds.joint(k) == faces_joined) return true;
    }
    return false;
  }

  /// Number of vertices that the two have in common; `which` is one of them.
  KOKKOS_FUNCTION int common_vertices(int i, int j, int& which) const {
    int count = 0;
    for (int c = 0; c < 3; ++c)
      for (int d = 0; d < 3; ++d)
        if (p.vertex(i, c) == p.vertex(j, d)) {
          which = p.vertex(i, c);
          ++count;
        }
    return count;
  }

  KOKKOS_FUNCTION bool share_a_vertex(int i, int j) const {
    int which = 0;
    return common_vertices(i, j, which) > 0;
  }

  /// Whether bond k holds and lies on an edge with this vertex.
  KOKKOS_FUNCTION bool holds_at(int k, int vertex) const {
    return !has_failed(bonds.state(k)) && (bonds.vertex(k, 0) == vertex || bonds.vertex(k, 1) == vertex);
  }

  /// The bond that leads on around a vertex from triangle i, which bond `from` has led to; -1 where none holds.
  KOKKOS_FUNCTION int next_around(int i, int vertex, int from) const {
    for (int e = bonds.row(i); e < bonds.row(i + 1); ++e)
      if (const int k = bonds.entry(e) / 2; k != from && holds_at(k, vertex)) return k;
    return -1;
  }

  /// Whether bonds that hold lead around a vertex of both from i to j.
  KOKKOS_FUNCTION bool joined_around(int i, int j, int vertex) const {
    for (int e = bonds.row(i); e < bonds.row(i + 1); ++e) {
      int at = i, k = holds_at(bonds.entry(e) / 2, vertex) ? bonds.entry(e) / 2 : -1;
      while (k >= 0) {
        at = bonds.pair(k, 0) == at ? bonds.pair(k, 1) : bonds.pair(k, 0);
        if (at == j) return true;
        if (at == i) break;  // once around
        k = next_around(at, vertex, k);
      }
    }
    return false;
  }

  /// Whether bonds keep the two apart: triangles that share one vertex are, as long as bonds around it join them. Bonds
  /// carry the load there. Outlines that pushed as well would stiffen intact rock, and most pairs would be such idle
  /// ones.
  KOKKOS_FUNCTION bool held_apart(int i, int j) const {
    int vertex = 0;
    return common_vertices(i, j, vertex) == 1 && joined_around(i, j, vertex);
  }

  KOKKOS_FUNCTION double reach_of(int i) const {
    double most = 0;
    for (int c = 0; c < 3; ++c) {
      const Vec2 r{p.corner(i, c, 0), p.corner(i, c, 1)};
      most = Kokkos::max(most, dot(r, r));
    }
    return Kokkos::sqrt(most);
  }

  KOKKOS_FUNCTION bool candidate(int i, int j) const {
    if (is_gone(p.solid_fraction(i)) || is_gone(p.solid_fraction(j))) return false;
    const Vec2 gap = centre(j) - centre(i);
    const double near = 2 * p.radius + skin;
    if (dot(gap, gap) > (2 * grid.reach + near) * (2 * grid.reach + near)) return false;
    const double touch = reach_of(i) + reach_of(j) + near;  // in graded rock a cell is full of far smaller triangles
    if (dot(gap, gap) > touch * touch) return false;
    if (joined(i, j) || held_apart(i, j)) return false;
    const Triangle a = outline(i), b = outline(j);
    for (int c = 0; c < 3; ++c) {
      if (closest_on_triangle(a, b.corner[c]).distance < near || closest_on_triangle(b, a.corner[c]).distance < near) {
        return true;
      }
    }
    return false;
  }

  /// Calls found(j) for every candidate j of i, in no particular order.
  template <class Found>
  KOKKOS_FUNCTION void for_candidates(int i, const Found& found) const {
    const Vec2 x = centre(i);
    const int cx = grid.column(x.x), cy = grid.line(x.y);
    for (int y = Kokkos::max(0, cy - 1); y <= Kokkos::min(grid.ny - 1, cy + 1); ++y) {
      for (int c = y * grid.nx + Kokkos::max(0, cx - 1); c <= y * grid.nx + Kokkos::min(grid.nx - 1, cx + 1); ++c) {
        for (int k = grid.start(c); k < grid.start(c + 1); ++k) {
          const int j = grid.item(k);
          if (j != i && candidate(i, j)) found(j);
        }
      }
    }
  }

  /// Idle overlap with which a pair is listed: bonds, or the faces of a crack, have borne what pressed the two
  /// together.
  KOKKOS_FUNCTION double first_idle_overlap(int i, int j) const { return share_a_vertex(i, j) ? before_first_look : 0; }
};

}  // namespace

}  // namespace vug
