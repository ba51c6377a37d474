#include "coupling/geometry.hpp"

#include "io/image_reader.hpp"

#include <algorithm>
#include <cmath>

namespace vug {

std::vector<Stretch> boundary_stretches(const Scene& scene) {
  const auto& lattice = scene.lattice;
  std::vector<Stretch> stretches;
  const auto add = [&](const char* name, Side side, int first, int last, const BoundarySection& conditions) {
    if (first <= last) stretches.push_back({name, side, first, last, conditions});
  };
  const auto side = [&](Side which, int length, const BoundarySection& conditions) {
    const char* name = name_of(which);
    if (!scene.injection || scene.injection->side != name) return add(name, which, 0, length - 1, conditions);
    const InjectionSection& injection = *scene.injection;
    const auto edge = [&](double at) { return static_cast<int>(std::lround(at / lattice.spacing)); };
    const int first = std::clamp(edge(injection.centre - injection.width / 2), 0, length - 1);
    const int last = std::clamp(edge(injection.centre + injection.width / 2) - 1, first, length - 1);
    add(name, which, 0, first - 1, conditions);
    add("injection", which, first, last, injection.conditions);
    add(name, which, last + 1, length - 1, conditions);
  };
  side(Side::left, lattice.ny, scene.left);
  side(Side::right, lattice.ny, scene.right);
  side(Side::bottom, lattice.nx, scene.bottom);
  side(Side::top, lattice.nx, scene.top);
  return stretches;
}

std::array<bool, 2> periodic_sides(const Scene& scene) {
  const auto joined = [&](const BoundarySection& side) {
    return (scene.flow && side.flow.kind == FlowBoundaryKind::periodic) ||
           (scene.heat && side.heat.kind == HeatBoundaryKind::periodic) ||
           (scene.solute && side.solute.kind == SoluteBoundaryKind::periodic);
  };
  return {joined(scene.left), joined(scene.bottom)};
}

namespace {

using Point = std::array<double, 2>;

bool holds(const Rectangle& r, const Point& p) {
  return p[0] >= std::min(r.from[0], r.to[0]) && p[0] <= std::max(r.from[0], r.to[0]) &&
         p[1] >= std::min(r.from[1], r.to[1]) && p[1] <= std::max(r.from[1], r.to[1]);
}

bool holds(const Disc& d, const Point& p) {
  return std::hypot(p[0] - d.centre[0], p[1] - d.centre[1]) <= d.radius;
}

/// Even-odd rule.
bool holds(const Polygon& polygon, const Point& p) {
  bool in = false;
  const auto& v = polygon.points;
  for (std::size_t a = 0, b = v.size() - 1; a < v.size(); b = a++)
    if ((v[a][1] > p[1]) != (v[b][1] > p[1]) &&
        p[0] < (v[b][0] - v[a][0]) * (p[1] - v[a][1]) / (v[b][1] - v[a][1]) + v[a][0])
      in = !in;
  return in;
}

}  // namespace

std::vector<bool> solid_mask(const Scene& scene) {
  const int nx = scene.lattice.nx, ny = scene.lattice.ny;
  const GeometrySection& geometry = scene.geometry;
  if (geometry.kind == GeometryKind::image) return read_solid_image(geometry, nx, ny);
  std::vector<bool> solid(static_cast<std::size_t>(nx) * ny,
                          geometry.kind == GeometryKind::shapes && geometry.background == "solid");
  if (geometry.kind != GeometryKind::shapes) return solid;
  for (const Shape& shape : geometry.shapes)
    for (int y = 0; y < ny; ++y)
      for (int x = 0; x < nx; ++x) {
        const Point centre{(x + 0.5) * scene.lattice.spacing, (y + 0.5) * scene.lattice.spacing};
        if (std::visit([&](const auto& form) { return holds(form, centre); }, shape.form))
          solid[static_cast<std::size_t>(y) * nx + x] = shape.solid;
      }
  return solid;
}

}  // namespace vug
