// [case], [lattice], [time], [geometry]: what is simulated, where and for how long.
#include "base/lattice_size.hpp"
#include "io/detail/case_tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdint>

namespace vug {
namespace {

/// Number of cells in a length. It must be whole within a tolerance, in cells, which allows for decimal fractions such
/// as 0.07 / 5e-5.
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

Shape read_shape(const TomlCursor& table, const std::vector<Shape>& earlier) {
  Shape shape;
  shape.form = *read_form(table, FormOf::geometry);
  table.choose("material", shape.solid, {{"solid", true}, {"fluid", false}});
  std::optional<std::string> name;
  table.read("name", name);
  if (!name) return shape;
  check_name(table, *name, earlier, "shape");
  table.refuse("material", "is of a shape without a name; one with a name is an opening, neither solid nor fluid");
  shape.name = *name;
  return shape;
}

void read_shapes(const TomlCursor& table, GeometrySection& geometry) {
  for (const TomlCursor& element : table.tables("shapes")) {
    const Shape shape = read_shape(element, geometry.shapes);
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

/// Reads the keys of a raw file. They are refused for a picture with a header, which contains these values.
void read_raw(const TomlCursor& table, ImageSection& image) {
  const std::string& file = image.file;
  const auto ends = [&](std::string ending) {
    std::string last = file.size() < ending.size() ? "" : file.substr(file.size() - ending.size());
    std::transform(last.begin(), last.end(), last.begin(), [](unsigned char c) { return std::tolower(c); });
    return last == ending;
  };
  const bool known = ends(".png") || ends(".tif") || ends(".tiff") || ends(".nrrd") || ends(".npy");
  if (known && !table.describing()) {
    for (const char* key : {"raw_size", "raw_type", "raw_order", "raw_pages"})
      table.refuse(key, "is for raw files; a picture with a header knows its own");
    return;
  }
  for (const char* ending : {".jpg", ".jpeg", ".bmp", ".gif", ".webp"})
    if (ends(ending) && !table.has("raw_size"))
      table.fail("file", fmt::format("is a picture of a kind that is not read, {}; save it as .png or .tif", ending));
  if (!table.describing() && !table.has("raw_size"))
    table.fail("raw_size",
               "is missing; a file that is not .png, .tif, .tiff, .nrrd or .npy is read as raw values and needs "
               "raw_size = [columns, rows]");
  table.read("raw_size", image.raw_size, range::between(1, 1 << 28));
  table.choose("raw_type", image.raw_type,
               {{"uint8", SampleType::uint8},
                {"uint16", SampleType::uint16},
                {"uint32", SampleType::uint32},
                {"int8", SampleType::int8},
                {"int16", SampleType::int16},
                {"int32", SampleType::int32},
                {"float32", SampleType::float32},
                {"float64", SampleType::float64}});
  table.choose("raw_order", image.raw_big_endian, {{"little", false}, {"big", true}});
  table.read("raw_pages", image.raw_pages, range::between(1, 1 << 20));
}

/// Reads how rock and pore are distinguished: by grey values or by labels.
void read_phases(const TomlCursor& table, ImageSection& image) {
  table.read("solid_labels", image.solid_labels);
  table.read("fluid_labels", image.fluid_labels);
  if (image.labelled() && !table.describing()) {
    for (const char* key : {"threshold", "invert", "grey_range"}) table.refuse(key, "stands beside labels");
    for (const std::int64_t label : image.fluid_labels)
      if (std::count(image.solid_labels.begin(), image.solid_labels.end(), label) > 0)
        table.fail("fluid_labels", fmt::format("holds {}, which is in solid_labels as well", label));
    return;
  }
  table.read("threshold", image.threshold, unit::none, range::between(0, 1));
  table.read("invert", image.invert);
  table.read("grey_range", image.grey_range, unit::none);
  if (table.has("grey_range") && image.grey_range[0] == image.grey_range[1])
    table.fail("grey_range", "must be two different values, [black, white]");
}

void read_image(const TomlCursor& table, GeometrySection& geometry) {
  if (geometry.kind != GeometryKind::image && !table.describing()) {
    for (const char* key : {"file", "threshold", "invert", "grey_range", "solid_labels", "fluid_labels", "page",
                            "pixel_size", "crop_from", "crop_size", "rotate", "mirror", "coarsen", "coarsen_rule",
                            "raw_size", "raw_type", "raw_order", "raw_pages"})
      table.refuse(key, "is only for geometry.type = \"image\"");
    return;
  }
  ImageSection& image = geometry.image;
  table.need("file", image.file);
  read_phases(table, image);
  table.read("page", image.page, range::between(0, 1 << 20));
  table.read("pixel_size", image.pixel_size, unit::metre, range::positive);
  table.read("crop_from", image.crop_from, range::between(0, 1 << 28));
  table.read("crop_size", image.crop_size, range::between(1, 1 << 28));
  table.choose(
      "rotate", image.rotate,
      {{"none", ImageTurn::none}, {"left", ImageTurn::left}, {"half", ImageTurn::half}, {"right", ImageTurn::right}});
  table.choose(
      "mirror", image.mirror,
      {{"none", ImageMirror::none}, {"left_right", ImageMirror::left_right}, {"top_bottom", ImageMirror::top_bottom}});
  table.read("coarsen", image.coarsen, range::between(1, 1000));
  table.choose("coarsen_rule", image.coarsen_rule, {{"majority", CoarsenRule::majority}, {"mean", CoarsenRule::mean}});
  if (image.labelled() && image.coarsen_rule == CoarsenRule::mean)
    table.fail("coarsen_rule", "needs grey values; labels have no mean");
  read_raw(table, image);
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
  if (const std::int64_t nodes = dense_nodes(lattice.nx, lattice.ny); nodes > most_nodes)
    table.fail("size",
               fmt::format("is {} x {} nodes of spacing {:g} m; with their halo, in rows of {}, these are {:.4g}, "
                           "at most 2^31 / 9 = 2.386e+08 are accepted",
                           lattice.nx, lattice.ny, lattice.spacing, row_pitch(lattice.nx), static_cast<double>(nodes)));
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
  read_image(table, geometry);
  return geometry;
}

}  // namespace vug
