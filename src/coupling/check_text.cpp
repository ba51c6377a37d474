// The report of `vug check` as text and as JSON.
#include "base/base.hpp"
#include "coupling/check.hpp"
#include "coupling/limit_text.hpp"
#include "io/json_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <iterator>

namespace vug {

namespace {

constexpr double busy = 2;  // mean wall time of the steps over that of the fastest, above which to warn

std::string image_line(const ImageSummary& image, double spacing) {
  std::string text =
      fmt::format("picture of {} x {} pixels, {}, values {:g} ... {:g}{}{}, pixel size {}", image.width, image.height,
                  image.type, image.least, image.largest, image.rock.empty() ? "" : ", ", image.rock,
                  image.pixel_size ? fmt::format("{:g} m", *image.pixel_size)
                                   : fmt::format("not known (lattice.spacing is {:g} m)", spacing));
  for (const auto& [label, share] : image.labels) text += fmt::format("\n  label {}: {:.2f} %", label, 100 * share);
  return text;
}

std::string duration(double seconds) {
  if (seconds < 120) return fmt::format("{:.3g} s", seconds);
  if (seconds < 7200) return fmt::format("{:.3g} min", seconds / 60);
  return fmt::format("{:.3g} h", seconds / 3600);
}

}  // namespace

std::string to_text(const CheckReport& report) {
  std::string text;
  const auto out = std::back_inserter(text);
  const bool specimen = report.nx == 0;
  if (!specimen)
    fmt::format_to(out, "lattice {} x {}, {} fluid nodes ({:.1f} %)", report.nx, report.ny, report.fluid_nodes,
                   100 * report.porosity);
  if (report.particles > 0)
    fmt::format_to(out, "{}{} triangles, {} bonds", specimen ? "specimen of " : ", ", report.particles, report.bonds);
  if (report.image) fmt::format_to(out, "\n{}", image_line(*report.image, report.spacing));
  if (!specimen && report.porosity < 1)
    fmt::format_to(out, "\npores joined from left to right {:.2f} %, from bottom to top {:.2f} % of the lattice",
                   100 * report.joined_x, 100 * report.joined_y);
  fmt::format_to(out, "\n{} precision, preset {}, {:.3g} MiB, {:.1f} bytes per {}\n", report.precision, report.preset,
                 report.bytes / 1048576,
                 report.bytes / (specimen ? report.particles : static_cast<double>(report.nx) * report.ny),
                 specimen ? "triangle" : "node");
  if (report.at_most) text += "at most ";
  fmt::format_to(out, "{} steps of {:.3g} ms on a free machine: about {}\n", report.steps,
                 1e3 * report.seconds_per_step, duration(report.seconds));
  const std::string fastest = report.batch > 0 ? fmt::format("fastest {} of the ", report.batch) : "";
  fmt::format_to(out, "  measured: the {}first {} steps, {}\n", fastest, report.measured_steps,
                 shares_host_memory ? fmt::format("processor time, threads: {}", report.threads) : "by the clock");
  if (!report.not_due.empty())
    fmt::format_to(out, "  too few for {}, whose time is not in it\n", fmt::join(report.not_due, ", "));
  if (report.slowed_by > busy)
    fmt::format_to(out, "  the machine is busy: by the clock they took {:.3g} times as long in the mean\n",
                   report.slowed_by);
  text += '\n';
  fmt::format_to(out, "{:<10} {:<42} {:>12} {:<9} {}\n", "module", "number", "value", "unit", "safe range");
  for (const Limit& limit : report.limits)
    fmt::format_to(out, "{:<10} {:<42} {:>12.5g} {:<9} {}\n", limit.module, limit.name, limit.value, limit.unit,
                   range_of(limit));
  if (!report.dimensionless.numbers.empty()) {
    fmt::format_to(out, "\ndimensionless numbers with {}\n", report.dimensionless.scales);
    for (const DimensionlessNumber& number : report.dimensionless.numbers)
      fmt::format_to(out, "  {:<40} {:>12.5g}  {}\n", number.name, number.value, number.definition);
  }
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
                 "  \"porosity\": {}, \"joined_porosity\": [{}, {}],\n"
                 "  \"precision\": {}, \"preset\": {},\n  \"bytes\": {}, \"steps\": {}, \"seconds_per_step\": {}, "
                 "\"seconds\": {}, \"at_most\": {},\n  \"measured_steps\": {}, \"threads\": {}, \"slowed_by\": {},\n  "
                 "\"limits\": [",
                 report.nx, report.ny, report.fluid_nodes, report.particles, report.bonds, json_number(report.porosity),
                 json_number(report.joined_x), json_number(report.joined_y), json_string(report.precision),
                 json_string(report.preset), json_number(report.bytes), report.steps,
                 json_number(report.seconds_per_step), json_number(report.seconds), report.at_most,
                 report.measured_steps, report.threads, json_number(report.slowed_by));
  for (std::size_t i = 0; i < report.limits.size(); ++i) {
    const Limit& limit = report.limits[i];
    fmt::format_to(out,
                   "{}\n    {{\"module\": {}, \"name\": {}, \"value\": {}, \"unit\": {}, \"low\": {}, \"high\": {}, "
                   "\"inside\": {}, \"advice\": {}}}",
                   i ? "," : "", json_string(limit.module), json_string(limit.name), json_number(limit.value),
                   json_string(limit.unit), json_number(limit.low), json_number(limit.high), limit.inside(),
                   json_string(limit.advice));
  }
  fmt::format_to(out, "\n  ],\n  \"dimensionless_scales\": {},\n  \"dimensionless\": [",
                 json_string(report.dimensionless.scales));
  for (std::size_t i = 0; i < report.dimensionless.numbers.size(); ++i) {
    const DimensionlessNumber& number = report.dimensionless.numbers[i];
    fmt::format_to(out, "{}\n    {{\"name\": {}, \"value\": {}, \"definition\": {}}}", i ? "," : "",
                   json_string(number.name), json_number(number.value), json_string(number.definition));
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
