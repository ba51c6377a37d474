// [[output.gauges]]: quantities of the rock in the history.
#include "io/detail/case_tables.hpp"

namespace vug {
namespace {

using Kind = GaugeKind;

/// Reads where a gauge of stress averages: over a form, or over the triangle at a point.
void read_place_of_stress(const TomlCursor& table, Gauge& gauge) {
  if (!table.has("shape") && !table.describing()) {
    table.need("at", gauge.at, unit::metre);
    return;
  }
  table.refuse("at", "is of one triangle; this gauge averages over its shape");
  gauge.region = read_form(table.table("shape"), FormOf::geometry);
}

void read_points_of_opening(const TomlCursor& table, Gauge& gauge) {
  std::vector<Point> points;
  table.need("points", points, unit::metre);
  if (table.describing()) return;
  if (points.size() != 2) table.fail("points", "must hold two points, one on either side of the crack");
  gauge.from = points[0];
  gauge.to = points[1];
  if (gauge.from == gauge.to) table.fail("points", "are the same");
}

Gauge read_gauge(const TomlCursor& table, const std::vector<Gauge>& earlier) {
  Gauge gauge;
  table.need("name", gauge.name);
  check_name(table, gauge.name, earlier, "gauge");
  table.need_choice("type", gauge.kind,
                    {{"displacement", Kind::displacement},
                     {"stress", Kind::stress},
                     {"reaction", Kind::reaction},
                     {"opening", Kind::opening},
                     {"crack_tip", Kind::crack_tip}});
  const bool all = table.describing();
  const auto of = [&](Kind kind) { return all || gauge.kind == kind; };
  if (of(Kind::displacement)) table.need("at", gauge.at, unit::metre);
  if (of(Kind::stress)) read_place_of_stress(table, gauge);
  if (of(Kind::opening)) read_points_of_opening(table, gauge);
  if (of(Kind::crack_tip)) table.need("from", gauge.from, unit::metre);
  if (of(Kind::crack_tip)) table.read("direction", gauge.direction, unit::none);
  if (of(Kind::reaction)) {
    read_side(table, gauge.side);
    table.read("first", gauge.first, unit::metre, range::not_negative);
    table.read("last", gauge.last, unit::metre, range::not_negative);
  }
  if (all) return gauge;
  const auto refuse = [&](bool used, std::initializer_list<const char*> keys, const char* why) {
    if (!used)
      for (const char* key : keys) table.refuse(key, why);
  };
  refuse(of(Kind::displacement) || of(Kind::stress), {"at"}, "is of a displacement or a stress");
  refuse(of(Kind::stress), {"shape"}, "is only for type = \"stress\"");
  refuse(of(Kind::opening), {"points"}, "is only for type = \"opening\"");
  refuse(of(Kind::crack_tip), {"from", "direction"}, "is only for type = \"crack_tip\"");
  refuse(of(Kind::reaction), {"side", "first", "last"}, "is only for type = \"reaction\"");
  if (gauge.kind == Kind::crack_tip && gauge.direction == Point{0, 0}) table.fail("direction", "must not be [0, 0]");
  return gauge;
}

}  // namespace

std::vector<Gauge> read_gauges(const TomlCursor& output) {
  std::vector<Gauge> gauges;
  for (const TomlCursor& element : output.tables("gauges")) gauges.push_back(read_gauge(element, gauges));
  return gauges;
}

}  // namespace vug
