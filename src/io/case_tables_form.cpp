// The keys of a form (rectangle, disc, polygon), for all tables of a case that draw one.
#include "io/detail/case_tables.hpp"

namespace vug {
namespace {

enum class Kind { rectangle, disc, polygon, group, mineral };

Rectangle read_rectangle(const TomlCursor& table) {
  Rectangle rectangle{};
  table.need("from", rectangle.from, unit::metre);
  table.need("to", rectangle.to, unit::metre);
  for (int axis = 0; axis < 2 && !table.describing(); ++axis) {
    if (rectangle.from[axis] == rectangle.to[axis])
      table.fail("to", "makes a rectangle without area; from and to are opposite corners");
  }
  return rectangle;
}

Disc read_disc(const TomlCursor& table) {
  Disc disc{};
  table.need("centre", disc.centre, unit::metre);
  table.need("radius", disc.radius, unit::metre, range::positive);
  return disc;
}

Polygon read_polygon(const TomlCursor& table) {
  Polygon polygon;
  table.need("points", polygon.points, unit::metre);
  if (polygon.points.size() < 3 && !table.describing()) table.fail("points", "must hold three points or more");
  return polygon;
}

/// The `type` of a region that has been read.
std::string word_of_type(const TomlCursor& table) {
  std::string type;
  table.read("type", type);
  return type;
}

}  // namespace

std::optional<Form> read_form(const TomlCursor& table, FormOf of) {
  Kind kind = Kind::rectangle;
  if (of == FormOf::rock)
    table.need_choice("type", kind,
                      {{"rectangle", Kind::rectangle},
                       {"disc", Kind::disc},
                       {"polygon", Kind::polygon},
                       {"group", Kind::group},
                       {"mineral", Kind::mineral}});
  else if (of == FormOf::mesh)
    table.need_choice(
        "type", kind,
        {{"rectangle", Kind::rectangle}, {"disc", Kind::disc}, {"polygon", Kind::polygon}, {"group", Kind::group}});
  else
    table.need_choice("type", kind, {{"rectangle", Kind::rectangle}, {"disc", Kind::disc}, {"polygon", Kind::polygon}});
  const bool describing = table.describing();
  std::optional<Form> form;
  if (kind == Kind::rectangle || describing) {
    form = read_rectangle(table);
  } else {
    table.refuse("from", "is only for type = \"rectangle\"");
    table.refuse("to", "is only for type = \"rectangle\"");
  }
  if (kind == Kind::disc || describing) {
    form = read_disc(table);
  } else {
    table.refuse("centre", "is only for type = \"disc\"");
    table.refuse("radius", "is only for type = \"disc\"");
  }
  if (kind == Kind::polygon || describing) {
    form = read_polygon(table);
  } else {
    table.refuse("points", "is only for type = \"polygon\"");
  }
  return form;
}

RockRegion read_region(const TomlCursor& table, FormOf of) {
  RockRegion region;
  region.form = read_form(table, of);
  const std::string type = table.describing() || region.form ? "" : word_of_type(table);
  table.need_if(type == "group", "group", "is only for type = \"group\"", region.group);
  if (of != FormOf::rock) return region;
  table.need_if(type == "mineral", "mineral", "is only for type = \"mineral\"", region.mineral);
  return region;
}

}  // namespace vug
