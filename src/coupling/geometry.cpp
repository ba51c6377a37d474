#include "coupling/geometry.hpp"

#include "coupling/cells.hpp"
#include "io/form.hpp"
#include "io/image_reader.hpp"
#include "kernels/base/require.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace vug {

std::vector<Stretch> boundary_stretches(const Scene& scene) {
  const auto& lattice = scene.lattice;
  std::vector<Stretch> stretches;
  const auto middle = [&](Side side, double along) -> std::array<double, 2> {
    if (side == Side::left || side == Side::right) return {side == Side::left ? 0.0 : lattice.nx, along};
    return {along, side == Side::bottom ? 0.0 : lattice.ny};
  };
  const auto add = [&](const std::string& name, Side side, int first, int last, const BoundarySection& conditions,
                       double centre) {
    if (first <= last) stretches.push_back({name, side, first, last, conditions, nullptr, middle(side, centre)});
  };
  const auto side = [&](Side which, int length, const BoundarySection& conditions) {
    const char* name = name_of(which);
    const auto cell = [&](double at) { return first_cell(at / lattice.spacing); };
    std::vector<const InjectionSection*> here;
    for (const InjectionSection& injection : scene.injections)
      if (injection.side == name) here.push_back(&injection);
    std::sort(here.begin(), here.end(), [](const auto* a, const auto* b) { return a->centre < b->centre; });
    int begin = 0;
    for (const InjectionSection* injection : here) {
      const int first = std::clamp(cell(injection->centre - injection->width / 2), begin, length - 1);
      const int last = std::clamp(cell(injection->centre + injection->width / 2) - 1, first, length - 1);
      add(name, which, begin, first - 1, conditions, length / 2.0);
      add(injection->name, which, first, last, injection->conditions, (first + last + 1) / 2.0);
      begin = last + 1;
    }
    add(name, which, begin, length - 1, conditions, length / 2.0);
  };
  side(Side::left, lattice.ny, scene.left);
  side(Side::right, lattice.ny, scene.right);
  side(Side::bottom, lattice.nx, scene.bottom);
  side(Side::top, lattice.nx, scene.top);
  return stretches;
}

std::vector<Stretch> boundary_stretches(const Scene& scene, const Geometry& geometry) {
  std::vector<Stretch> stretches = boundary_stretches(scene);
  for (const InnerOpening& opening : geometry.openings)
    stretches.push_back({opening.name, Side::left, 0, -1, opening.conditions, &opening.nodes, opening.centre});
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

Point in_cells(const Point& p, double spacing) {
  return {snapped(p[0] / spacing), snapped(p[1] / spacing)};
}

Rectangle in_cells(const Rectangle& r, double spacing) {
  return {in_cells(r.from, spacing), in_cells(r.to, spacing)};
}

Disc in_cells(const Disc& d, double spacing) {
  return {in_cells(d.centre, spacing), d.radius / spacing};
}

Polygon in_cells(Polygon polygon, double spacing) {
  for (Point& p : polygon.points) p = in_cells(p, spacing);
  return polygon;
}

/// Calls paint(node) for every node, row by row without halo, whose centre lies in the form.
template <class Paint>
void draw(const Form& shape, const LatticeSection& lattice, const Paint& paint) {
  const auto draw_form = [&](const auto& form) {
    for (int y = 0; y < lattice.ny; ++y)
      for (int x = 0; x < lattice.nx; ++x)
        if (holds(form, Point{x + 0.5, y + 0.5}, tie)) paint(static_cast<std::size_t>(y) * lattice.nx + x);
  };
  std::visit([&](const auto& form) { draw_form(in_cells(form, lattice.spacing)); }, shape);
}

Point unit_vector(const Point& v) {
  const double length = std::hypot(v[0], v[1]);
  return length > 0 ? Point{v[0] / length, v[1] / length} : Point{1, 0};
}

/// 1 where the corners go round counterclockwise, else -1.
double orientation(const Polygon& polygon) {
  const auto& v = polygon.points;
  double twice = 0;  // the area, by the shoelace formula
  for (std::size_t a = 0, b = v.size() - 1; a < v.size(); b = a++) twice += v[b][0] * v[a][1] - v[b][1] * v[a][0];
  return twice < 0 ? -1 : 1;
}

/// Unit normal of the outline at the point of it that is nearest to p.
Point normal_at(const Disc& disc, const Point& p, const Point&) {
  return unit_vector({p[0] - disc.centre[0], p[1] - disc.centre[1]});
}

/// Of the edges that look along `out` the nearest: at a corner the other one may be nearer, which a line along `out`
/// does not cross.
Point normal_at(const Polygon& polygon, const Point& p, const Point& out) {
  constexpr double aside = 1e-9;  // cosine of what lies along an edge
  const auto& v = polygon.points;
  const double round = orientation(polygon);
  Point found = unit_vector(out);
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t a = 0, b = v.size() - 1; a < v.size(); b = a++) {
    const Point along{v[a][0] - v[b][0], v[a][1] - v[b][1]}, to_p{p[0] - v[b][0], p[1] - v[b][1]};
    const double length2 = along[0] * along[0] + along[1] * along[1];
    const Point normal = unit_vector({round * along[1], -round * along[0]});
    if (length2 == 0 || normal[0] * out[0] + normal[1] * out[1] < aside) continue;
    const double t = std::clamp((to_p[0] * along[0] + to_p[1] * along[1]) / length2, 0.0, 1.0);
    const double distance = std::hypot(to_p[0] - t * along[0], to_p[1] - t * along[1]);
    if (distance >= nearest) continue;
    nearest = distance;
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

/// Of the area, by the shoelace formula with the first corner as origin; where there is no area, the first corner.
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

/// What to warn of where a picture shows no rock at all.
std::string without_rock(const ImageSection& image, const ImageSummary& found) {
  return fmt::format(
      "{}: has values {:g} ... {:g}, and {} no rock of any of them: all is pore", image.file, found.least,
      found.largest,
      image.labelled() ? "geometry.solid_labels make" : "geometry.grey_range, threshold and invert make");
}

}  // namespace

std::vector<int> opening_of_nodes(const Scene& scene) {
  if (scene.openings.empty()) return {};
  std::vector<int> opening(static_cast<std::size_t>(scene.lattice.nx) * scene.lattice.ny, -1);
  const auto& shapes = scene.geometry.shapes;
  for (std::size_t s = 0, next = 0; s < shapes.size(); ++s) {
    const int painted = shapes[s].name.empty() ? -1 : static_cast<int>(next++);
    draw(shapes[s].form, scene.lattice, [&](std::size_t n) { opening[n] = painted; });
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
    openings.push_back({"shape_" + shape.name, make_opening(lattice, nodes[o], normal), section.conditions,
                        std::visit([&](const auto& form) { return in_cells(centre_of(form), dx); }, shape.form)});
  }
  return openings;
}

void require_fluid_at_openings(const Exec& exec, const Scene& scene, const Geometry& geometry) {
  if (scene.reaction || scene.damage) return;  // fluid may reach it later
  for (const InnerOpening& opening : geometry.openings) {
    const bool flows = scene.flow && opening.conditions.flow.kind != FlowBoundaryKind::wall;
    const bool dissolves = scene.solute && opening.conditions.solute.kind != SoluteBoundaryKind::no_flux;
    if (!flows && !dissolves) continue;
    if (find_opening_links(exec, geometry.fluid, opening.nodes, D2Q9::Q).count > 0) continue;
    throw InputError(fmt::format("{}: boundary.shape.{}.{} has no effect: no fluid touches the shape", scene.path,
                                 opening.name.substr(opening.name.find('_') + 1), flows ? "flow" : "solute"));
  }
}

void for_each_node_in(const Form& form, const LatticeSection& lattice, const std::function<void(std::size_t)>& visit) {
  draw(form, lattice, visit);
}

DrawnRock drawn_rock(const Scene& scene) {
  const int nx = scene.lattice.nx, ny = scene.lattice.ny;
  const GeometrySection& geometry = scene.geometry;
  if (geometry.kind == GeometryKind::image) {
    SolidImage image = read_solid_image(geometry.image, scene.lattice);
    const bool all_rock = std::find(image.solid.begin(), image.solid.end(), false) == image.solid.end();
    const bool no_rock = std::find(image.solid.begin(), image.solid.end(), true) == image.solid.end();
    if (all_rock && (scene.flow || scene.solute) && !geometry.image.labelled())  // as of 12 bits taken for 16
      throw InputError(
          fmt::format("{}: has values {:g} ... {:g}, and geometry.grey_range, threshold and invert make "
                      "rock of them all: there is no fluid",
                      geometry.image.file, image.summary.least, image.summary.largest));
    return {std::move(image.solid), std::move(image.mineral),
            no_rock ? without_rock(geometry.image, image.summary) : ""};
  }
  std::vector<bool> solid(static_cast<std::size_t>(nx) * ny,
                          geometry.kind == GeometryKind::shapes && geometry.background == "solid");
  if (geometry.kind != GeometryKind::shapes) return {std::move(solid), {}, ""};
  for (const Shape& shape : geometry.shapes)
    draw(shape.form, scene.lattice, [&](std::size_t n) { solid[n] = shape.solid; });
  return {std::move(solid), {}, ""};
}

}  // namespace vug
