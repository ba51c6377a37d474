#include "dem/particles.hpp"

#include "base/require.hpp"
#include "dem/materials.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace vug {

Triangle triangle_of(const Assembly& assembly, int k) {
  Triangle triangle;
  for (int c = 0; c < 3; ++c) {
    const auto& point = assembly.vertices[static_cast<std::size_t>(assembly.triangles[static_cast<std::size_t>(k)][c])];
    triangle.corner[c] = {point[0], point[1]};
  }
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

template <class V>
V fresh(const char* label, int count) {
  return V(std::string("vug::dem::") + label, static_cast<std::size_t>(count));
}

void allocate(Particles& p, int n) {
  p.count = n;
  p.x0 = fresh<VectorField<double>>("x0", n);
  p.corner = fresh<decltype(p.corner)>("corner", n);
  p.eroded = fresh<decltype(p.eroded)>("eroded", n);
  p.vertex = fresh<decltype(p.vertex)>("vertex", n);
  p.mass = fresh<ScalarField<double>>("mass", n);
  p.inertia = fresh<ScalarField<double>>("inertia", n);
  p.u = fresh<VectorField<double>>("u", n);
  p.u_reference = fresh<VectorField<double>>("u_reference", n);
  p.v = fresh<VectorField<double>>("v", n);
  p.angle = fresh<ScalarField<double>>("angle", n);
  p.angle_reference = fresh<ScalarField<double>>("angle_reference", n);
  p.spin = fresh<ScalarField<double>>("spin", n);
  p.rotation = fresh<VectorField<double>>("rotation", n);
  p.force = fresh<VectorField<double>>("force", n);
  p.torque = fresh<ScalarField<double>>("torque", n);
  p.solid_fraction = fresh<ScalarField<double>>("solid_fraction", n);
  p.temperature_change = fresh<ScalarField<double>>("temperature_change", n);
  p.warming = p.temperature_change;
  p.u_origin = p.u_reference;
  p.angle_origin = p.angle_reference;
  p.held = fresh<decltype(p.held)>("held", n);
  p.drive = fresh<VectorField<double>>("drive", n);
  p.reaction = fresh<VectorField<double>>("reaction", n);
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
  if (!assembly.region.empty()) p.warming = fresh<ScalarField<double>>("warming", p.count);
  if (parameters.output_from_unloaded) {
    p.u_origin = fresh<VectorField<double>>("u_origin", p.count);
    p.angle_origin = fresh<ScalarField<double>>("angle_origin", p.count);
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
      vertex(i, k) = assembly.triangles[static_cast<std::size_t>(i)][static_cast<std::size_t>(k)];
    }
  }
  return p;
}

}  // namespace vug
