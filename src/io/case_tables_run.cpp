// [accuracy] and [output]: how a case is computed and what is written.
#include "io/detail/case_tables.hpp"

#include <fmt/format.h>

#include <set>

namespace vug {

namespace {

constexpr double largest_tolerance = 0.1;

}  // namespace

Preset read_preset(const TomlCursor& table) {
  double tolerance = 0;
  table.read("tolerance", tolerance, unit::none, range::between(0, largest_tolerance));
  Preset preset = tolerance > 0 ? preset_of(tolerance) : Preset::careful;
  table.choose("preset", preset,
               {{"fast", Preset::fast},
                {"balanced", Preset::balanced},
                {"careful", Preset::careful},
                {"reference", Preset::reference}});
  return preset;
}

AccuracySection read_accuracy(const TomlCursor& table, Preset preset, bool may_age, bool flows) {
  AccuracySection accuracy = accuracy_of(preset);
  if (!table.describing())
    table.read("tolerance", accuracy.tolerance, unit::none, range::between(0, largest_tolerance));
  if (const double tolerance = accuracy.tolerance; tolerance > 0) {
    if (!table.has("preset")) accuracy.precision = precision_of(tolerance);
    if (may_age && !table.has("dissolution_factor")) accuracy.dissolution_tolerance = tolerance;
    if (accuracy.dissolution_tolerance > 0 && flows) accuracy.flow_tolerance = tolerance / 10;
  }
  table.read("dissolution_tolerance", accuracy.dissolution_tolerance, unit::none, range::between(0, largest_tolerance));
  if (accuracy.chooses_intervals()) set_longest_intervals(accuracy);
  table.choose("precision", accuracy.precision,
               {{"single", Precision::single_precision}, {"double", Precision::double_precision}});
  table.read("update_interval", accuracy.update_interval, range::between(1, 1e6));
  table.read("wall_interval", accuracy.wall_interval, range::between(1, 1e6));
  table.read("heat_interval", accuracy.heat_interval, range::between(1, 1000));
  table.read("solute_interval", accuracy.solute_interval, range::between(1, 1000));
  table.read("exchange_interval", accuracy.exchange_interval, range::between(1, 1000));
  table.read("guard_interval", accuracy.guard_interval, range::between(1, 1e6));
  table.read("flow_tolerance", accuracy.flow_tolerance, unit::none, range::between(0, 1));
  table.read("dissolution_factor", accuracy.dissolution_factor, unit::none, range::between(1, 1e6));
  return accuracy;
}

OutputSection read_output(const TomlCursor& table) {
  OutputSection output;
  table.read("interval", output.interval, unit::second, range::positive);
  table.read("interval_steps", output.interval_steps, range::between(1, 1e15));
  table.read("history_interval", output.history_interval, unit::second, range::positive);
  table.read("checkpoint_interval", output.checkpoint_interval, unit::second, range::positive);
  table.read("fields", output.fields);
  table.read("compress", output.compress);
  table.read("forces", output.forces);
  table.read("flows", output.flows);
  for (const TomlCursor& element : table.tables("probes")) {
    Probe probe{};
    element.need("name", probe.name);
    element.need("at", probe.at, unit::metre);
    check_name(element, probe.name, output.probes, "probe");
    output.probes.push_back(probe);
  }
  output.gauges = read_gauges(table);
  if (table.describing()) return output;
  if (output.interval && output.interval_steps)
    table.fail("interval_steps", "stands beside output.interval; give one of the two");
  std::set<std::string> field_names;
  for (std::size_t i = 0; i < output.fields.size(); ++i) {
    if (output.fields[i].empty()) table.fail(fmt::format("fields.{}", i), "must be the name of a field");
    if (!field_names.insert(output.fields[i]).second)
      table.fail(fmt::format("fields.{}", i), "stands in the list twice");
  }
  return output;
}

}  // namespace vug
