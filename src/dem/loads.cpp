#include "dem/loads.hpp"

#include "dem/edges.hpp"
#include "dem/extent.hpp"
#include "dem/require_edges.hpp"

#include <algorithm>
#include <cmath>

namespace vug {

namespace {

/// Distance from a line within which a vertex counts as on it.
double tolerance_of(const Extent& rock) {
  return 1e-6 * std::max(rock.width(), rock.height());
}

/// RockSide of the edge p -> q with the rock on its left, or -1. Of the sides on which both its ends lie it is the one
/// that it faces most, n . n_side with its outward normal n: in a corner an edge shorter than the tolerance lies on
/// two. Where it faces none of them (the face of a slot close to the side), it is an inner surface.
int side_of(const std::array<double, 2>& p, const std::array<double, 2>& q, const Extent& rock) {
  const double tolerance = tolerance_of(rock);
  const std::array<double, 4> place{rock.right, rock.top, rock.left, rock.bottom};  // order of RockSide
  const std::array<double, 4> faces{q[1] - p[1], p[0] - q[0], p[1] - q[1], q[0] - p[0]};
  int owner = -1;
  double most = 0;
  for (std::size_t side = 0; side < 4; ++side) {
    const std::size_t axis = side % 2;
    const auto lies_there = [&](const std::array<double, 2>& end) {
      return std::abs(end[axis] - place[side]) < tolerance;
    };
    if (!(faces[side] > most) || !lies_there(p) || !lies_there(q)) continue;
    owner = static_cast<int>(side);
    most = faces[side];
  }
  return owner;
}

/// Bits of the axes that a support holds (Particles::held).
int held_axes(Support support, int side) {
  const int normal = 1 << side % 2;
  switch (support) {
    case Support::free:
      return 0;
    case Support::fixed:
      return 7;
    case Support::pin:
      return 3;
    case Support::pin_roller:
      return normal;
    default:
      return 4 | normal;
  }
}

using Interval = std::array<double, 2>;

/// Removes [from, to] from the intervals and returns what was removed.
std::vector<Interval> take(std::vector<Interval>& left, double from, double to) {
  std::vector<Interval> taken, rest;
  for (const auto& [low, high] : left) {
    const double a = std::max(low, from), b = std::min(high, to);
    if (!(a < b)) {
      rest.push_back({low, high});
      continue;
    }
    taken.push_back({a, b});
    if (low < a) rest.push_back({low, a});
    if (b < high) rest.push_back({b, high});
  }
  left = rest;
  return taken;
}

/// Whether pieces hold an edge together: those of one part, and those of parts and sides at rest with the same support.
bool alike(const LoadedPiece& a, const LoadedPiece& b, const Loads& loads) {
  const auto rests = [&](const LoadedPiece& piece) {
    return piece.part < 0 ? loads.velocity[piece.side] == std::array<double, 2>{} : !loads.parts[piece.part].moves();
  };
  return a.part == b.part || (support_of(a, loads) == support_of(b, loads) && rests(a) && rests(b));
}

/// Of the pieces of an edge from number `first` on, those hold it that together have more than half of its length; the
/// longest of them decides.
void let_more_than_half_decide(const Loads& loads, double edge, std::size_t first, std::vector<LoadedPiece>& pieces) {
  for (std::size_t k = first; k < pieces.size(); ++k) {
    double together = 0;
    bool longest = true;
    for (std::size_t m = first; m < pieces.size(); ++m) {
      if (!alike(pieces[m], pieces[k], loads)) continue;
      together += pieces[m].length;
      longest = longest && (pieces[m].length < pieces[k].length || (pieces[m].length == pieces[k].length && m >= k));
    }
    pieces[k].holds = 2 * together > edge;
    pieces[k].decides = longest && pieces[k].holds;
  }
}

/// Adds the pieces of one edge p -> q of a side. Their length is that along the side, so that the edges of a side add
/// up to it also where they lie on it within rounding only.
void add_pieces(const BoundaryEdge& edge, Vec2 p, Vec2 q, Vec2 centroid, const Loads& loads,
                std::vector<LoadedPiece>& pieces) {
  const bool upright = edge.side % 2 == 0;
  const double at_p = upright ? p.y : p.x, at_q = upright ? q.y : q.x;
  const double low = std::min(at_p, at_q), high = std::max(at_p, at_q), length = high - low;
  const std::size_t first = pieces.size();
  const auto add = [&](int part, double a, double b) {
    const double middle = (0.5 * (a + b) - at_p) / (at_q - at_p);
    pieces.push_back(
        {part, edge.side, edge.particle, length * (b - a) / (high - low), p + middle * (q - p) - centroid});
  };
  std::vector<Interval> left{{low, high}};
  const auto is_left = [&](double place) {
    return std::any_of(left.begin(), left.end(),
                       [&](const Interval& free) { return place >= free[0] && place < free[1]; });
  };
  int point = -1;
  for (int n = static_cast<int>(loads.parts.size()) - 1; n >= 0; --n) {
    const SidePart& part = loads.parts[n];
    if (static_cast<int>(part.side) != edge.side) continue;
    if (part.from == part.to && point < 0 && is_left(part.from)) point = n;  // else a later part is there
    for (const auto& [a, b] : take(left, part.from, part.to)) add(n, a, b);
  }
  if (pieces.size() == first)
    pieces.push_back({-1, edge.side, edge.particle, length, 0.5 * (p + q) - centroid});
  else
    for (const auto& [a, b] : left) add(-1, a, b);
  let_more_than_half_decide(loads, length, first, pieces);
  if (point < 0) return;
  for (std::size_t k = first; k < pieces.size(); ++k) pieces[k].holds = pieces[k].decides = false;
  pieces.push_back({point, edge.side, edge.particle, 0, {}, true, true});
}

}  // namespace

std::vector<BoundaryEdge> find_boundary(const Assembly& assembly) {
  const Extent rock = extent_of(assembly);
  std::vector<BoundaryEdge> boundary;
  for (const Edge& edge : find_edges(assembly)) {
    if (edge.triangle[1] >= 0) continue;
    const int side = side_of(assembly.vertices[edge.vertex[0]], assembly.vertices[edge.vertex[1]], rock);
    boundary.push_back({edge.triangle[0], edge.vertex, side});
  }
  return boundary;
}

bool faces_itself(const Assembly& assembly, const std::vector<BoundaryEdge>& boundary) {
  const double tolerance = tolerance_of(extent_of(assembly));
  // every vertex of the boundary is the first one of some edge
  return std::any_of(boundary.begin(), boundary.end(), [&](const BoundaryEdge& edge) {
    if (edge.side >= 0) return false;  // nothing lies beyond the bounding box
    const Vec2 p = vertex_of(assembly, edge.vertex[0]), along = vertex_of(assembly, edge.vertex[1]) - p;
    const double beyond = -tolerance * norm(along);
    return std::any_of(boundary.begin(), boundary.end(), [&](const BoundaryEdge& other) {
      return cross(along, vertex_of(assembly, other.vertex[0]) - p) < beyond;
    });
  });
}

Support support_of(const LoadedPiece& piece, const Loads& loads) {
  return piece.part >= 0 ? loads.parts[piece.part].support : loads.support[piece.side];
}

std::vector<AxesOfSides> axes_held(const std::vector<LoadedPiece>& pieces, const Loads& loads, int particles) {
  std::vector<AxesOfSides> held(particles), owned(held.size());
  for (const LoadedPiece& piece : pieces)
    if (piece.decides) held[piece.particle][piece.side] |= held_axes(support_of(piece, loads), piece.side);
  for (std::size_t i = 0; i < held.size(); ++i)
    for (const int axis : {0, 1}) {
      int owner = -1;
      for (const int s : {axis, axis + 2, 1 - axis, 3 - axis})  // the sides with this normal, then the others
        if (owner < 0 && (held[i][s] & 1 << axis) != 0) owner = s;
      if (owner >= 0) owned[i][owner] |= 1 << axis;
    }
  return owned;
}

std::vector<LoadedPiece> pieces_of_boundary(const Assembly& assembly, const std::vector<BoundaryEdge>& boundary,
                                            const Loads& loads, const Particles& particles) {
  const auto x0 = on_host(particles.x0);
  std::vector<LoadedPiece> pieces;
  for (const BoundaryEdge& edge : boundary)
    if (edge.side >= 0)
      add_pieces(edge, vertex_of(assembly, edge.vertex[0]), vertex_of(assembly, edge.vertex[1]),
                 {x0(edge.particle, 0), x0(edge.particle, 1)}, loads, pieces);
  return pieces;
}

BoundaryLoads apply_loads(const Assembly& assembly, const std::vector<BoundaryEdge>& boundary, const Loads& loads,
                          const Particles& particles) {
  const int n = particles.count;
  BoundaryLoads out{VectorField<double>("vug::dem::boundary_force", n),
                    VectorField<double>("vug::dem::boundary_moment", n),
                    VectorField<double>("vug::dem::boundary_stiffness", n), loads.gravity[0], loads.gravity[1]};
  const HostWriter force(out.force), moment(out.moment), stiffness(out.stiffness), drive(particles.drive);
  const HostWriter held(particles.held);
  require_edges(assembly, boundary, loads, particles);
  const std::vector<LoadedPiece> pieces = pieces_of_boundary(assembly, boundary, loads, particles);
  const std::vector<AxesOfSides> owned = axes_held(pieces, loads, particles.count);
  for (const LoadedPiece& piece : pieces) {
    const int i = piece.particle;
    const int side = piece.side;
    const SidePart* part = piece.part < 0 ? nullptr : &loads.parts[piece.part];
    std::array<double, 2> traction = loads.traction[side];
    if (part) traction = {value_at(part->traction[0], 0), value_at(part->traction[1], 0)};
    const Support support = support_of(piece, loads);
    Vec2 f{piece.length * traction[0], piece.length * traction[1]};
    if (support == Support::servo) (side % 2 == 0 ? f.x : f.y) = 0;  // its platen provides this pressure
    force(i, 0) += f.x;
    force(i, 1) += f.y;
    moment(i, 0) += cross(piece.arm, f);
    moment(i, 1) += dot(piece.arm, f);
    stiffness(i, piece.side % 2) += piece.length * (part ? part->stiffness : loads.stiffness[side]);
    if (!piece.decides) continue;
    const int axes = held_axes(support, piece.side), own = axes & owned[i][side];
    held(i) |= axes;
    for (int axis = 0; axis < 2; ++axis)
      if (own & 1 << axis) drive(i, axis) = part ? 0 : loads.velocity[side][axis];
  }
  return out;
}

void set_platen_velocity(const std::vector<BoundaryEdge>& boundary, RockSide side, std::array<double, 2> velocity,
                         const Particles& particles) {
  const auto drive = on_host(particles.drive);
  const auto held = on_host(particles.held);
  for (const BoundaryEdge& edge : boundary) {
    if (edge.side != static_cast<int>(side)) continue;
    for (int axis = 0; axis < 2; ++axis) {
      if (held(edge.particle) & 1 << axis) drive(edge.particle, axis) = velocity[axis];
    }
  }
  Kokkos::deep_copy(particles.drive, drive);
}

}  // namespace vug
