#include "dem/particles.hpp"

#include "base/require.hpp"
#include "dem/materials.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace vug {

Vec2 vertex_of(const Assembly& assembly, int v) {
  return {assembly.vertices[v][0], assembly.vertices[v][1]};
}

Triangle triangle_of(const Assembly& assembly, int k) {
  Triangle triangle;
  for (int c = 0; c < 3; ++c) triangle.corner[c] = vertex_of(assembly, assembly.triangles[k][c]);
  return triangle;
}

namespace {

void require_vertices_exist(const Assembly& assembly) {
  const int vertices = static_cast<int>(assembly.vertices.size());
  for (std::size_t k = 0; k < assembly.triangles.size(); ++k) {
    for (const int v : assembly.triangles[k]) {
      if (v < 0 || v >= vertices) {
        throw InputError("rock assembly: triangle " + std::to_string(k) + " names vertex " + std::to_string(v) +
                         ", expected 0 to " + std::to_string(vertices - 1));
      }
    }
  }
}

void require_area(double area, int k) {
  if (!(area > 0) || !std::isfinite(area)) {
    throw InputError("rock assembly: triangle " + std::to_string(k) + " has area " + std::to_string(area) +
                     " m2, expected a positive one (corners counter-clockwise, no two alike)");
  }
}

double smallest_inradius(const Assembly& assembly) {
  double smallest = std::numeric_limits<double>::infinity();
  for (int k = 0; k < static_cast<int>(assembly.triangles.size()); ++k) {
    const Triangle triangle = triangle_of(assembly, k);
    require_area(triangle.area(), k);
    smallest = std::min(smallest, triangle.inradius());
  }
  return smallest;
}

void allocate(Particles& p, int n) {
  p.count = n;
  make_zeros(p.x0, "vug::dem::x0", n);
  make_zeros(p.corner, "vug::dem::corner", n);
  make_zeros(p.eroded, "vug::dem::eroded", n);
  make_zeros(p.vertex, "vug::dem::vertex", n);
  make_zeros(p.mass, "vug::dem::mass", n);
  make_zeros(p.inertia, "vug::dem::inertia", n);
  make_zeros(p.u, "vug::dem::u", n);
  make_zeros(p.u_reference, "vug::dem::u_reference", n);
  make_zeros(p.v, "vug::dem::v", n);
  make_zeros(p.angle, "vug::dem::angle", n);
  make_zeros(p.angle_reference, "vug::dem::angle_reference", n);
  make_zeros(p.spin, "vug::dem::spin", n);
  make_zeros(p.rotation, "vug::dem::rotation", n);
  make_zeros(p.force, "vug::dem::force", n);
  make_zeros(p.torque, "vug::dem::torque", n);
  make_zeros(p.solid_fraction, "vug::dem::solid_fraction", n);
  make_zeros(p.temperature_change, "vug::dem::temperature_change", n);
  p.warming = p.temperature_change;
  p.u_origin = p.u_reference;
  p.angle_origin = p.angle_reference;
  make_zeros(p.held, "vug::dem::held", n);
  make_zeros(p.drive, "vug::dem::drive", n);
  make_zeros(p.reaction, "vug::dem::reaction", n);
  Kokkos::deep_copy(p.solid_fraction, 1.0);
}

}  // namespace

Particles make_particles(const Assembly& assembly, const MechanicsParameters& parameters) {
  require_vertices_exist(assembly);
  require_materials(parameters, assembly);
  if (assembly.triangles.empty()) throw InputError("rock assembly: no triangles, expected at least one");
  Particles p;
  p.radius = parameters.contact.radius_factor * smallest_inradius(assembly);
  allocate(p, static_cast<int>(assembly.triangles.size()));
  if (!assembly.region.empty()) make_zeros(p.warming, "vug::dem::warming", p.count);
  if (parameters.output_from_unloaded) {
    make_zeros(p.u_origin, "vug::dem::u_origin", p.count);
    make_zeros(p.angle_origin, "vug::dem::angle_origin", p.count);
  }
  const HostWriter x0(p.x0);
  const HostWriter corner(p.corner), eroded(p.eroded);
  const HostWriter vertex(p.vertex);
  const HostWriter mass(p.mass), inertia(p.inertia);
  for (int i = 0; i < p.count; ++i) {
    const Triangle triangle = triangle_of(assembly, i);
    const Vec2 c = triangle.centroid();
    x0(i, 0) = c.x;
    x0(i, 1) = c.y;
    mass(i) = material_of(parameters, assembly, i).density * triangle.area();
    inertia(i) = mass(i) * triangle.gyration_squared();
    for (int k = 0; k < 3; ++k) {
      const Vec2 sharp = triangle.corner[k] - c;
      const Vec2 inner = triangle.eroded_corner(k, p.radius) - c;
      corner(i, k, 0) = sharp.x;
      corner(i, k, 1) = sharp.y;
      eroded(i, k, 0) = inner.x;
      eroded(i, k, 1) = inner.y;
      vertex(i, k) = assembly.triangles[i][k];
    }
  }
  return p;
}

}  // namespace vug
