#include "coupling/check.hpp"

#include "coupling/choices.hpp"
#include "coupling/flow_paths.hpp"
#include "coupling/limit_text.hpp"
#include "coupling/run.hpp"
#include "coupling/simulation.hpp"
#include "io/require_fields.hpp"
#include "kernels/base.hpp"
#include "kernels/memory.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <iterator>
#include <limits>

namespace vug {

namespace {

constexpr int warm_up_steps = 3;
constexpr int batch = 10, most_steps = 200;
constexpr double enough = 0.2;  // s of measuring
constexpr double busy = 2;      // times what the fastest steps took, by the clock

/// s that all threads together have computed.
double processor_time() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// A few steps that are then forgotten. Other work on the machine stretches the time by the clock, and with several
/// threads, which wait for each other, also that of the processors: what the fastest batch took is what a step takes on
/// a free machine. A GPU's time is seen by the clock only.
void measure_steps(Simulation& simulation, CheckReport& report) {
  for (int step = 0; step < warm_up_steps; ++step) simulation.step();
  Kokkos::fence();
  report.threads = runs_on_host ? Exec().concurrency() : 1;
  const Kokkos::Timer clock;
  const auto now = [&] { return runs_on_host ? processor_time() / report.threads : clock.seconds(); };
  const double start = now();
  double fastest = std::numeric_limits<double>::infinity();
  for (double before = start; report.measured_steps < most_steps && before - start < enough;) {
    for (int step = 0; step < batch; ++step) simulation.step();
    Kokkos::fence();
    report.measured_steps += batch;
    const double after = now();
    fastest = std::min(fastest, after - before);
    before = after;
  }
  report.seconds_per_step = fastest / batch;
  report.slowed_by = clock.seconds() / report.measured_steps / report.seconds_per_step;
}

std::string duration(double seconds) {
  if (seconds < 120) return fmt::format("{:.3g} s", seconds);
  if (seconds < 7200) return fmt::format("{:.3g} min", seconds / 60);
  return fmt::format("{:.3g} h", seconds / 3600);
}

std::string json_number(double value) {
  return std::isfinite(value) ? fmt::format("{:.17g}", value) : "null";
}

std::string json_string(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') out += '\\';
    if (static_cast<unsigned char>(c) < 0x20)
      out += fmt::format("\\u{:04x}", static_cast<int>(c));
    else
      out += c;
  }
  return out + '"';
}

}  // namespace

CheckReport check_case(const Scene& scene) {
  CheckReport report;
  const double before = allocated_bytes();
  Simulation simulation(scene);
  report.bytes = allocated_bytes() - before;
  const Parts& parts = simulation.parts();
  report.limits = simulation.limits();
  require_fields(simulation.fields(), scene.output.fields);
  report.warnings = scene.warnings;
  for (const std::string& warning : find_flow_paths(scene, parts.geometry, parts.units).warnings)
    report.warnings.push_back(warning);
  report.choices = choice_notes(scene);
  report.nx = scene.lattice.nx;
  report.ny = scene.lattice.ny;
  report.fluid_nodes = parts.geometry.fluid.count;
  if (parts.rock) {
    report.particles = parts.rock->nodes_of_particle.count();
    report.bonds = parts.rock->bonds;
  }
  report.porosity = static_cast<double>(report.fluid_nodes) / (static_cast<double>(report.nx) * report.ny);
  report.steps = last_step(scene);
  measure_steps(simulation, report);
  report.seconds = report.seconds_per_step * static_cast<double>(report.steps);
  report.precision = scene.accuracy.precision == Precision::single_precision ? "single" : "double";
  report.preset = scene.accuracy.preset;
  return report;
}

std::string to_text(const CheckReport& report) {
  std::string text;
  const auto out = std::back_inserter(text);
  fmt::format_to(out, "lattice {} x {}, {} fluid nodes ({:.1f} %)", report.nx, report.ny, report.fluid_nodes,
                 100 * report.porosity);
  if (report.particles > 0) fmt::format_to(out, ", {} triangles, {} bonds", report.particles, report.bonds);
  fmt::format_to(out, "\n{} precision, preset {}, {:.3g} MiB, {:.1f} bytes per node\n", report.precision, report.preset,
                 report.bytes / 1048576, report.bytes / (static_cast<double>(report.nx) * report.ny));
  fmt::format_to(out, "{} steps of {:.3g} ms on a free machine: about {}\n", report.steps,
                 1e3 * report.seconds_per_step, duration(report.seconds));
  fmt::format_to(out, "  measured: the fastest {} of the first {} steps, {}\n", batch, report.measured_steps,
                 runs_on_host ? fmt::format("processor time, threads: {}", report.threads) : "by the clock");
  if (report.slowed_by > busy)
    fmt::format_to(out, "  the machine is busy: by the clock they took {:.3g} times as long in the mean\n",
                   report.slowed_by);
  text += '\n';
  fmt::format_to(out, "{:<10} {:<42} {:>12} {:<9} {}\n", "module", "number", "value", "unit", "safe range");
  for (const Limit& limit : report.limits)
    fmt::format_to(out, "{:<10} {:<42} {:>12.5g} {:<9} {}\n", limit.module, limit.name, limit.value, limit.unit,
                   range_of(limit));
  for (const std::string& choice : report.choices) fmt::format_to(out, "choice: {}\n", choice);
  for (const Limit& limit : report.limits)
    if (!limit.inside()) fmt::format_to(out, "warning: {}\n", warning_of(limit));
  for (const std::string& warning : report.warnings) fmt::format_to(out, "warning: {}\n", warning);
  return text;
}

std::string to_json(const CheckReport& report) {
  std::string text;
  const auto out = std::back_inserter(text);
  fmt::format_to(out,
                 "{{\n  \"nx\": {}, \"ny\": {}, \"fluid_nodes\": {}, \"particles\": {}, \"bonds\": {},\n"
                 "  \"precision\": {}, \"preset\": {},\n  \"bytes\": {}, \"steps\": {}, \"seconds_per_step\": {}, "
                 "\"seconds\": {},\n  \"measured_steps\": {}, \"threads\": {}, \"slowed_by\": {},\n  \"limits\": [",
                 report.nx, report.ny, report.fluid_nodes, report.particles, report.bonds,
                 json_string(report.precision), json_string(report.preset), json_number(report.bytes), report.steps,
                 json_number(report.seconds_per_step), json_number(report.seconds), report.measured_steps,
                 report.threads, json_number(report.slowed_by));
  for (std::size_t i = 0; i < report.limits.size(); ++i) {
    const Limit& limit = report.limits[i];
    fmt::format_to(out,
                   "{}\n    {{\"module\": {}, \"name\": {}, \"value\": {}, \"unit\": {}, \"low\": {}, \"high\": {}, "
                   "\"inside\": {}, \"advice\": {}}}",
                   i ? "," : "", json_string(limit.module), json_string(limit.name), json_number(limit.value),
                   json_string(limit.unit), json_number(limit.low), json_number(limit.high), limit.inside(),
                   json_string(limit.advice));
  }
  const auto list = [&](const char* name, const std::vector<std::string>& lines) {
    fmt::format_to(out, "\n  ],\n  \"{}\": [", name);
    for (std::size_t i = 0; i < lines.size(); ++i)
      fmt::format_to(out, "{}\n    {}", i ? "," : "", json_string(lines[i]));
  };
  list("choices", report.choices);
  list("warnings", report.warnings);
  fmt::format_to(out, "\n  ]\n}}\n");
  return text;
}

}  // namespace vug
