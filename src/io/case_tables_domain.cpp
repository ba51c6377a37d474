// [case], [lattice], [time], [geometry]: what is simulated, where and for how long.
#include "io/detail/case_tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace vug {
namespace {

/// Whole number of cells in a length. The tolerance, in cells, forgives decimal fractions such as 0.07 / 5e-5.
int cells_along(const TomlCursor& table, double length, double spacing, int axis) {
  constexpr double tolerance = 1e-6, fewest = 3, most = 1 << 28;
  const double cells = length / spacing;
  const std::string key = fmt::format("size.{}", axis);
  if (cells > most)
    table.fail(key,
               fmt::format("is {:g} cells of lattice.spacing = {:g} m, at most 2^28 are accepted", cells, spacing));
  const double whole = std::round(cells);
  if (std::abs(cells - whole) > tolerance) {
    table.fail(
        key,
        fmt::format(
            "m is {:.6g} cells of lattice.spacing = {:g} m, it must be a whole number of them: use {:.10g} or {:.10g}",
            cells, spacing, std::floor(cells) * spacing, std::ceil(cells) * spacing));
  }
  if (whole < fewest)
    table.fail(key, fmt::format("m is {:g} cells of lattice.spacing = {:g} m, at least 3 are needed", whole, spacing));
  return static_cast<int>(whole);
}

Shape read_shape(const TomlCursor& table) {
  enum class Form { rectangle, disc, polygon };
  Shape shape;
  Form form = Form::rectangle;
  table.need_choice("type", form, {{"rectangle", Form::rectangle}, {"disc", Form::disc}, {"polygon", Form::polygon}});
  Rectangle rectangle{};
  Disc disc{};
  Polygon polygon;
  const bool describing = table.describing();
  if (form == Form::rectangle || describing) {
    table.need("from", rectangle.from, unit::metre);
    table.need("to", rectangle.to, unit::metre);
    for (int axis = 0; axis < 2 && !describing; ++axis) {
      if (rectangle.from[axis] == rectangle.to[axis])
        table.fail("to", "makes a rectangle without area; from and to are opposite corners");
    }
    shape.form = rectangle;
  } else {
    table.refuse("from", "is only for type = \"rectangle\"");
    table.refuse("to", "is only for type = \"rectangle\"");
  }
  if (form == Form::disc || describing) {
    table.need("centre", disc.centre, unit::metre);
    table.need("radius", disc.radius, unit::metre, range::positive);
    shape.form = disc;
  } else {
    table.refuse("centre", "is only for type = \"disc\"");
    table.refuse("radius", "is only for type = \"disc\"");
  }
  if (form == Form::polygon || describing) {
    table.need("points", polygon.points, unit::metre);
    if (polygon.points.size() < 3 && !describing) table.fail("points", "must hold three points or more");
    shape.form = polygon;
  } else {
    table.refuse("points", "is only for type = \"polygon\"");
  }
  table.choose("material", shape.solid, {{"solid", true}, {"fluid", false}});
  std::optional<std::string> name;
  table.read("name", name);
  if (!name) return shape;
  if (!is_plain_name(*name)) table.fail("name", plain_name_rule);
  table.refuse("material", "is of a shape without a name; one with a name is an opening, neither solid nor fluid");
  shape.name = *name;
  return shape;
}

void read_shapes(const TomlCursor& table, GeometrySection& geometry) {
  for (const TomlCursor& element : table.tables("shapes")) {
    const Shape shape = read_shape(element);
    const bool again = std::any_of(geometry.shapes.begin(), geometry.shapes.end(), [&](const Shape& earlier) {
      return !shape.name.empty() && earlier.name == shape.name;
    });
    if (again) element.fail("name", "is the name of an earlier shape");
    if (shape.name.empty() && geometry.kind != GeometryKind::shapes && !table.describing()) {
      element.fail("name",
                   "is missing; shapes of solid or fluid are only for geometry.type = \"shapes\", others "
                   "need a name and are openings");
    }
    geometry.shapes.push_back(shape);
  }
  if (geometry.shapes.empty() && geometry.kind == GeometryKind::shapes)
    table.fail("shapes", "is missing; type = \"shapes\" needs at least one [[geometry.shapes]]");
}

}  // namespace

void read_case(const TomlCursor& table, Scene& scene) {
  table.read("name", scene.name);
  table.read("description", scene.description);
}

LatticeSection read_lattice(const TomlCursor& table) {
  LatticeSection lattice;
  Point size{};
  table.need("size", size, unit::metre, range::positive);
  table.need("spacing", lattice.spacing, unit::metre, range::positive);
  table.need("time_step", lattice.time_step, unit::second, range::positive);
  lattice.length_x = size[0];
  lattice.length_y = size[1];
  if (table.describing()) return lattice;
  lattice.nx = cells_along(table, size[0], lattice.spacing, 0);
  lattice.ny = cells_along(table, size[1], lattice.spacing, 1);
  const double nodes = static_cast<double>(lattice.nx) * lattice.ny;
  if (nodes > 1 << 28)
    table.fail("size",
               fmt::format("is {:g} nodes of spacing {:g} m, at most 2^28 are accepted", nodes, lattice.spacing));
  return lattice;
}

TimeSection read_time(const TomlCursor& table) {
  TimeSection time;
  table.read("end", time.end, unit::second, range::positive);
  table.read("steps", time.steps, range::between(1, 1e15));
  if (table.describing()) return time;
  if (time.end && time.steps) table.fail("steps", "stands beside time.end; give one of the two");
  if (!time.end && !time.steps) table.fail("end", "is missing; give time.end in seconds or time.steps");
  return time;
}

GeometrySection read_geometry(const TomlCursor& table) {
  GeometrySection geometry;
  table.choose("type", geometry.kind,
               {{"open", GeometryKind::open},
                {"image", GeometryKind::image},
                {"shapes", GeometryKind::shapes},
                {"rock", GeometryKind::rock}});
  bool solid_background = false;
  if (geometry.kind == GeometryKind::shapes || table.describing()) {
    table.choose("background", solid_background, {{"fluid", false}, {"solid", true}});
    geometry.background = solid_background ? "solid" : "fluid";
  } else {
    table.refuse("background", "is only for geometry.type = \"shapes\"");
  }
  read_shapes(table, geometry);
  if (geometry.kind == GeometryKind::image || table.describing()) {
    table.need("file", geometry.image_file);
    table.read("threshold", geometry.image_threshold, unit::none, range::between(0, 1));
    table.read("invert", geometry.image_invert);
    table.read("raw_size", geometry.raw_size, range::between(1, 1 << 28));
    if (table.describing()) return geometry;
    const bool png = geometry.image_file.ends_with(".png") || geometry.image_file.ends_with(".PNG");
    if (png) table.refuse("raw_size", "is for raw files; a .png knows its own size");
    if (!png && !table.has("raw_size")) {
      table.fail("raw_size",
                 "is missing; a file that is not .png is read as raw bytes, one per pixel, and needs raw_size = "
                 "[columns, rows]");
    }
  } else {
    for (const char* key : {"file", "threshold", "invert", "raw_size"})
      table.refuse(key, "is only for geometry.type = \"image\"");
  }
  return geometry;
}

}  // namespace vug
