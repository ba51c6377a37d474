#include "dem/loads.hpp"

#include "dem/edges.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace vug {

namespace {

/// Corners of the rectangle around the rock: {left, bottom, right, top}.
std::array<double, 4> bounding_box(const Assembly& assembly) {
  constexpr double far = std::numeric_limits<double>::infinity();
  std::array<double, 4> box{far, far, -far, -far};
  for (const auto& triangle : assembly.triangles) {
    for (const int v : triangle) {
      const auto& point = assembly.vertices[static_cast<std::size_t>(v)];
      box = {std::min(box[0], point[0]), std::min(box[1], point[1]), std::max(box[2], point[0]),
             std::max(box[3], point[1])};
    }
  }
  return box;
}

int side_of(const std::array<double, 2>& p, const std::array<double, 2>& q, const std::array<double, 4>& box) {
  const double tolerance = 1e-6 * std::max(box[2] - box[0], box[3] - box[1]);
  const std::array<double, 4> place{box[2], box[3], box[0], box[1]};  // order of RockSide
  for (std::size_t side = 0; side < 4; ++side) {
    const std::size_t axis = side % 2;
    if (std::abs(p[axis] - place[side]) < tolerance && std::abs(q[axis] - place[side]) < tolerance) {
      return static_cast<int>(side);
    }
  }
  return -1;
}

void hold(Support support, int side, std::array<double, 2> velocity, int i,
          const Kokkos::View<std::uint8_t*>::host_mirror_type& held,
          const VectorField<double>::host_mirror_type& drive) {
  if (support == Support::free) return;
  const int axis = side % 2;
  held(i) = static_cast<std::uint8_t>(held(i) | (support == Support::fixed ? 7 : 4 | 1 << axis));
  drive(i, axis) = velocity[static_cast<std::size_t>(axis)];
  if (support == Support::fixed) drive(i, 1 - axis) = velocity[static_cast<std::size_t>(1 - axis)];
}

}  // namespace

std::vector<BoundaryEdge> find_boundary(const Assembly& assembly) {
  const auto box = bounding_box(assembly);
  std::vector<BoundaryEdge> boundary;
  for (const Edge& edge : find_edges(assembly)) {
    if (edge.triangle[1] >= 0) continue;
    const auto& p = assembly.vertices[static_cast<std::size_t>(edge.vertex[0])];
    const auto& q = assembly.vertices[static_cast<std::size_t>(edge.vertex[1])];
    boundary.push_back({edge.triangle[0], edge.vertex, side_of(p, q, box)});
  }
  return boundary;
}

BoundaryLoads apply_loads(const Assembly& assembly, const std::vector<BoundaryEdge>& boundary, const Loads& loads,
                          const Particles& particles) {
  const auto n = static_cast<std::size_t>(particles.count);
  BoundaryLoads out{VectorField<double>("vug::dem::boundary_force", n),
                    VectorField<double>("vug::dem::boundary_moment", n),
                    VectorField<double>("vug::dem::boundary_stiffness", n), loads.gravity[0], loads.gravity[1]};
  const auto x0 = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, particles.x0);
  const auto force = Kokkos::create_mirror_view(out.force);
  const auto moment = Kokkos::create_mirror_view(out.moment);
  const auto stiffness = Kokkos::create_mirror_view(out.stiffness);
  const auto held = Kokkos::create_mirror_view(particles.held);
  const auto drive = Kokkos::create_mirror_view(particles.drive);
  for (const BoundaryEdge& edge : boundary) {
    if (edge.side < 0) continue;
    const int i = edge.particle;
    const auto side = static_cast<std::size_t>(edge.side);
    const auto& p = assembly.vertices[static_cast<std::size_t>(edge.vertex[0])];
    const auto& q = assembly.vertices[static_cast<std::size_t>(edge.vertex[1])];
    const double length = norm({q[0] - p[0], q[1] - p[1]});
    Vec2 f{length * loads.traction[side][0], length * loads.traction[side][1]};
    if (loads.support[side] == Support::servo) (side % 2 == 0 ? f.x : f.y) = 0;  // its platen sees to it
    const Vec2 r{0.5 * (p[0] + q[0]) - x0(i, 0), 0.5 * (p[1] + q[1]) - x0(i, 1)};
    force(i, 0) += f.x;
    force(i, 1) += f.y;
    moment(i, 0) += cross(r, f);
    moment(i, 1) += dot(r, f);
    stiffness(i, edge.side % 2) += length * loads.stiffness[side];
    hold(loads.support[side], edge.side, loads.velocity[side], i, held, drive);
  }
  Kokkos::deep_copy(out.force, force);
  Kokkos::deep_copy(out.moment, moment);
  Kokkos::deep_copy(out.stiffness, stiffness);
  Kokkos::deep_copy(particles.held, held);
  Kokkos::deep_copy(particles.drive, drive);
  return out;
}

void set_platen_velocity(const std::vector<BoundaryEdge>& boundary, RockSide side, std::array<double, 2> velocity,
                         const Particles& particles) {
  const auto drive = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, particles.drive);
  const auto held = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, particles.held);
  for (const BoundaryEdge& edge : boundary) {
    if (edge.side != static_cast<int>(side)) continue;
    for (int axis = 0; axis < 2; ++axis) {
      if (held(edge.particle) & 1 << axis) drive(edge.particle, axis) = velocity[static_cast<std::size_t>(axis)];
    }
  }
  Kokkos::deep_copy(particles.drive, drive);
}

}  // namespace vug
