// Openings on the lattice: their nodes, surface and centre.
#include "base/require.hpp"
#include "coupling/cells.hpp"
#include "coupling/geometry.hpp"
#include "io/form.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace vug {

namespace {

using Point = std::array<double, 2>;

Point unit_vector(const Point& v) {
  const double length = std::hypot(v[0], v[1]);
  return length > 0 ? Point{v[0] / length, v[1] / length} : Point{1, 0};
}

/// 1 where the corners are in counterclockwise order, otherwise -1.
double orientation(const Polygon& polygon) {
  const auto& v = polygon.points;
  double twice = 0;  // the area, by the shoelace formula
  for (std::size_t a = 0, b = v.size() - 1; a < v.size(); b = a++) twice += v[b][0] * v[a][1] - v[b][1] * v[a][0];
  return twice < 0 ? -1 : 1;
}

/// Unit normal of the outline at its point nearest to p.
Point normal_at(const Disc& disc, const Point& p, const Point&) {
  return unit_vector({p[0] - disc.centre[0], p[1] - disc.centre[1]});
}

/// Normal of the nearest edge among those that face `out`. At a corner another edge may be nearer, but a line along
/// `out` does not cross it. Of two that are as near, which meet at a corner, the one that faces `out` more.
Point normal_at(const Polygon& polygon, const Point& p, const Point& out) {
  constexpr double aside = 1e-9;  // smallest cosine; with less, `out` is along the edge
  const auto& v = polygon.points;
  const double round = orientation(polygon);
  Point found = unit_vector(out);
  double nearest = std::numeric_limits<double>::infinity(), facing = 0;
  for (std::size_t a = 0, b = v.size() - 1; a < v.size(); b = a++) {
    const Point along{v[a][0] - v[b][0], v[a][1] - v[b][1]}, to_p{p[0] - v[b][0], p[1] - v[b][1]};
    const double length2 = along[0] * along[0] + along[1] * along[1];
    const Point normal = unit_vector({round * along[1], -round * along[0]});
    const double faces = normal[0] * out[0] + normal[1] * out[1];
    if (length2 == 0 || faces < aside) continue;
    const double t = std::clamp((to_p[0] * along[0] + to_p[1] * along[1]) / length2, 0.0, 1.0);
    const double distance = std::hypot(to_p[0] - t * along[0], to_p[1] - t * along[1]);
    const double alike = 1e-9 * std::sqrt(length2);  // beyond rounding
    if (distance > nearest + alike || (distance > nearest - alike && faces <= facing)) continue;
    nearest = distance;
    facing = faces;
    found = normal;
  }
  return found;
}

Point normal_at(const Rectangle& r, const Point& p, const Point& out) {
  return normal_at(Polygon{{r.from, {r.to[0], r.from[1]}, r.to, {r.from[0], r.to[1]}}}, p, out);
}

Point centre_of(const Disc& disc) {
  return disc.centre;
}

Point centre_of(const Rectangle& r) {
  return {(r.from[0] + r.to[0]) / 2, (r.from[1] + r.to[1]) / 2};
}

/// Centroid of the area, by the shoelace formula with the first corner as origin; the first corner if the area is 0.
Point centre_of(const Polygon& polygon) {
  const Point& o = polygon.points[0];
  double twice_area = 0, x = 0, y = 0;
  for (std::size_t k = 1; k + 1 < polygon.points.size(); ++k) {
    const Point &a = polygon.points[k], &b = polygon.points[k + 1];
    const double cross = (a[0] - o[0]) * (b[1] - o[1]) - (a[1] - o[1]) * (b[0] - o[0]);
    twice_area += cross;
    x += cross * (a[0] + b[0] - 2 * o[0]) / 3;
    y += cross * (a[1] + b[1] - 2 * o[1]) / 3;
  }
  return twice_area == 0 ? o : Point{o[0] + x / twice_area, o[1] + y / twice_area};
}

/// The cells in which a form lies, with one more on each side, within a lattice's size of the lattice.
CellWindow cells_of(const Form& form, const LatticeSection& section) {
  const Box box = box_of(form);
  const auto cell = [&](double at, double way, int n) {
    return static_cast<int>(std::clamp(std::floor(at / section.spacing) + way, -1.0 * n, 2.0 * n));
  };
  return {cell(box.x0, -1, section.nx), cell(box.y0, -1, section.ny), cell(box.x1, 2, section.nx),
          cell(box.y1, 2, section.ny)};
}

/// Length of the outline of a form over the sum of the outer faces of its cells, each multiplied by the cosine between
/// the face and the outline. It is 1 to within some per cent for a form of many cells. A form that is partly outside
/// the lattice has the ratio of the whole one; one that reaches further beyond it than the lattice is large has 1.
double outline_over_faces(const Form& form, const LatticeSection& section, const OutlineNormal& normal) {
  const CellWindow window = cells_of(form, section);
  const int columns = window.x1 - window.x0, rows = window.y1 - window.y0;
  std::vector<bool> inside(static_cast<std::size_t>(columns) * rows, false);
  const auto place = [&](int x, int y) {
    return static_cast<std::size_t>(y - window.y0) * columns + static_cast<std::size_t>(x - window.x0);
  };
  const auto on_rim = [&](int x, int y) {
    return x == window.x0 || x == window.x1 - 1 || y == window.y0 || y == window.y1 - 1;
  };
  std::vector<std::array<int, 2>> cells;
  bool cut = false;
  for_each_cell_in(form, section.spacing, window, [&](int x, int y) {
    inside[place(x, y)] = true;
    cells.push_back({x, y});
    cut = cut || on_rim(x, y);
  });
  if (cut || cells.empty()) return 1;
  double faces = 0;
  for (const auto& [x, y] : cells)
    for (const auto& [i, j] : {std::array{1, 0}, {0, 1}, {-1, 0}, {0, -1}}) {
      if (inside[place(x + i, y + j)]) continue;
      const Point out{1.0 * i, 1.0 * j}, along = normal({x + 0.5 + out[0] / 2, y + 0.5 + out[1] / 2}, out);
      faces += std::abs(along[0] * out[0] + along[1] * out[1]);
    }
  return faces > 0 ? outline_length(form) / section.spacing / faces : 1;
}

}  // namespace

std::vector<int> opening_of_nodes(const Scene& scene) {
  if (scene.openings.empty()) return {};
  std::vector<int> opening(static_cast<std::size_t>(scene.lattice.nx) * scene.lattice.ny, -1);
  const auto& shapes = scene.geometry.shapes;
  for (std::size_t s = 0, next = 0; s < shapes.size(); ++s) {
    const int painted = shapes[s].name.empty() ? -1 : static_cast<int>(next++);
    for_each_node_in(shapes[s].form, scene.lattice, [&](std::size_t n) { opening[n] = painted; });
  }
  return opening;
}

std::vector<InnerOpening> make_openings(const Scene& scene, const Lattice& lattice) {
  const std::vector<int> opening_of = opening_of_nodes(scene);
  std::vector<std::vector<int>> nodes(scene.openings.size());
  for (std::size_t n = 0; n < opening_of.size(); ++n)
    if (opening_of[n] >= 0)
      nodes[opening_of[n]].push_back(lattice.node(static_cast<int>(n) % lattice.nx, static_cast<int>(n) / lattice.nx));
  std::vector<InnerOpening> openings;
  for (std::size_t o = 0; o < nodes.size(); ++o) {
    const OpeningSection& section = scene.openings[o];
    const Shape& shape = scene.geometry.shapes[section.shape];
    if (nodes[o].empty())
      throw InputError(
          fmt::format("{}: the shape \"{}\" holds the centre of no cell that a later shape leaves to it; "
                      "enlarge it or refine lattice.spacing",
                      scene.path, shape.name));
    const double dx = scene.lattice.spacing;
    const auto normal = [&](const Point& at, const Point& out) {
      return std::visit(
          [&](const auto& form) {
            return normal_at(form, Point{at[0] * dx, at[1] * dx}, out);
          },
          shape.form);
    };
    openings.push_back({"shape_" + shape.name,
                        make_opening(lattice, nodes[o], normal, outline_over_faces(shape.form, scene.lattice, normal)),
                        section.conditions,
                        std::visit([&](const auto& form) { return point_in_cells(centre_of(form), dx); }, shape.form),
                        "boundary.shape." + shape.name});
  }
  return openings;
}

}  // namespace vug
