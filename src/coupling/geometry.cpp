#include "coupling/geometry.hpp"

#include "base/require.hpp"
#include "coupling/cells.hpp"
#include "io/form.hpp"
#include "io/image_reader.hpp"
#include "io/periodic.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace vug {

std::vector<Stretch> boundary_stretches(const Scene& scene) {
  const auto& lattice = scene.lattice;
  std::vector<Stretch> stretches;
  const auto middle = [&](Side side, double along) -> std::array<double, 2> {
    if (is_upright(side)) return {side == Side::left ? 0.0 : lattice.nx, along};
    return {along, side == Side::bottom ? 0.0 : lattice.ny};
  };
  struct Whole {
    int first, last;
  };
  const auto add = [&](const std::string& name, const std::string& key, Side side, int first, int last, Whole whole,
                       const BoundarySection& conditions, double centre) {
    if (first <= last)
      stretches.push_back(
          {name, side, first, last, conditions, nullptr, middle(side, centre), key, whole.first, whole.last});
  };
  for (const Side which : all_sides) {
    const BoundarySection& conditions = scene.side(which);
    const int length = is_upright(which) ? lattice.ny : lattice.nx;
    const std::string name = name_of(which), key = "boundary." + name;
    const auto cell = [&](double at) { return first_cell(at / lattice.spacing); };
    std::vector<const InjectionSection*> here;
    for (const InjectionSection& injection : scene.injections)
      if (injection.side == which) here.push_back(&injection);
    std::sort(here.begin(), here.end(), [](const auto* a, const auto* b) { return a->centre < b->centre; });
    const Whole all{0, length - 1};
    int begin = 0;
    for (const InjectionSection* injection : here) {
      const int first = std::clamp(cell(injection->centre - injection->width / 2), begin, length - 1);
      const int last = std::clamp(cell(injection->centre + injection->width / 2) - 1, first, length - 1);
      add(name, key, which, begin, first - 1, all, conditions, length / 2.0);
      add(injection->name, injection->key, which, first, last, {first, last}, injection->conditions,
          (first + last + 1) / 2.0);
      begin = last + 1;
    }
    add(name, key, which, begin, length - 1, all, conditions, length / 2.0);
  }
  return stretches;
}

std::vector<Stretch> boundary_stretches(const Scene& scene, const Geometry& geometry) {
  std::vector<Stretch> stretches = boundary_stretches(scene);
  for (const InnerOpening& opening : geometry.openings)
    stretches.push_back(
        {opening.name, Side::left, 0, -1, opening.conditions, &opening.nodes, opening.centre, opening.key});
  return stretches;
}

std::array<bool, 2> periodic_sides(const Scene& scene) {
  return {is_periodic(scene, scene.left), is_periodic(scene, scene.bottom)};
}

namespace {

using Point = std::array<double, 2>;

Rectangle in_cells(const Rectangle& r, double spacing) {
  return {point_in_cells(r.from, spacing), point_in_cells(r.to, spacing)};
}

Disc in_cells(const Disc& d, double spacing) {
  return {point_in_cells(d.centre, spacing), d.radius / spacing};
}

Polygon in_cells(Polygon polygon, double spacing) {
  for (Point& p : polygon.points) p = point_in_cells(p, spacing);
  return polygon;
}

/// Calls paint(node) for every node whose centre is in the form, row by row without halo.
/// What to give where grey values of a picture are all rock or all pore, as of a mask of 0 and 1.
std::string told_apart(const ImageSummary& found) {
  if (found.rock.empty() || !(found.largest > found.least)) return "";
  return fmt::format(" ({}); geometry.grey_range = [{:g}, {:g}] tells them apart", found.rock, found.least,
                     found.largest);
}

/// The warning where a picture shows no rock at all.
std::string without_rock(const ImageSection& image, const ImageSummary& found) {
  return fmt::format("{}: has values {:g} ... {:g}, and {} no rock of any of them: all is pore{}", image.file,
                     found.least, found.largest,
                     image.labelled() ? "geometry.solid_labels make" : "geometry.grey_range, threshold and invert make",
                     told_apart(found));
}

}  // namespace

void for_each_cell_in(const Form& form, double spacing, const CellWindow& window,
                      const std::function<void(int, int)>& visit) {
  const auto visit_cells = [&](const auto& drawn) {
    for (int y = window.y0; y < window.y1; ++y)
      for (int x = window.x0; x < window.x1; ++x)
        if (holds(drawn, Point{x + 0.5, y + 0.5}, tie)) visit(x, y);
  };
  std::visit([&](const auto& drawn) { visit_cells(in_cells(drawn, spacing)); }, form);
}

void for_each_node_in(const Form& form, const LatticeSection& lattice, const std::function<void(std::size_t)>& visit) {
  for_each_cell_in(form, lattice.spacing, {0, 0, lattice.nx, lattice.ny},
                   [&](int x, int y) { visit(static_cast<std::size_t>(y) * lattice.nx + x); });
}

DrawnRock drawn_rock(const Scene& scene) {
  const int nx = scene.lattice.nx, ny = scene.lattice.ny;
  const GeometrySection& geometry = scene.geometry;
  if (geometry.kind == GeometryKind::image) {
    SolidImage image = read_solid_image(geometry.image, scene.lattice);
    const bool all_rock = std::find(image.solid.begin(), image.solid.end(), false) == image.solid.end();
    const bool no_rock = std::find(image.solid.begin(), image.solid.end(), true) == image.solid.end();
    std::string warning = no_rock ? without_rock(geometry.image, image.summary) : "";
    if (all_rock && !geometry.image.labelled()) {  // e.g. 12 bits taken for 16
      warning = fmt::format(
          "{}: has values {:g} ... {:g}, and geometry.grey_range, threshold and invert make "
          "rock of them all: there is no fluid{}",
          geometry.image.file, image.summary.least, image.summary.largest, told_apart(image.summary));
      if (scene.flow || scene.solute) throw InputError(warning);
    }
    return {std::move(image.solid), std::move(image.mineral), std::move(warning)};
  }
  std::vector<bool> solid(static_cast<std::size_t>(nx) * ny,
                          geometry.kind == GeometryKind::shapes && geometry.background == "solid");
  if (geometry.kind != GeometryKind::shapes) return {std::move(solid), {}, ""};
  for (const Shape& shape : geometry.shapes)
    for_each_node_in(shape.form, scene.lattice, [&](std::size_t n) { solid[n] = shape.solid; });
  return {std::move(solid), {}, ""};
}

}  // namespace vug
