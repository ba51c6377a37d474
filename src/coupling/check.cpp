#include "coupling/check.hpp"

#include "base/base.hpp"
#include "coupling/case_warnings.hpp"
#include "coupling/choices.hpp"
#include "coupling/explain.hpp"
#include "coupling/fluid_picture.hpp"
#include "coupling/output_schedule.hpp"
#include "coupling/rock_fields.hpp"
#include "coupling/run_files.hpp"
#include "coupling/simulation.hpp"
#include "coupling/specimen.hpp"
#include "host/memory.hpp"
#include "host/this_process.hpp"
#include "host/work_time.hpp"
#include "io/palette_picture.hpp"
#include "io/require_fields.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace vug {

namespace {

constexpr int warm_up_steps = 3;
constexpr int most_measured = 200;
constexpr int longest_stretch = 1000;
constexpr double enough = 0.2;   // s, duration of the measurement
constexpr double patience = 20;  // s by the clock after which a measurement ends in the middle of its steps

/// The intervals, of more than a step, of what the case has, with their keys. One step where they are chosen during the
/// run, since that begins with it.
std::vector<std::pair<const char*, int>> due_intervals(const Scene& scene) {
  const AccuracySection& accuracy = scene.accuracy;
  std::vector<std::pair<const char*, int>> due;
  if (scene.laboratory || accuracy.chooses_intervals()) return due;
  const auto add = [&](bool there, const char* key, int interval) {
    if (there && interval > 1) due.emplace_back(key, interval);
  };
  add(scene.heat.has_value(), "heat_interval", accuracy.heat_interval);
  add(scene.solute.has_value(), "solute_interval", accuracy.solute_interval);
  add(scene.flow && scene.mechanics, "exchange_interval", accuracy.exchange_interval);
  add(scene.reaction || scene.mechanics, "update_interval", accuracy.update_interval);
  return due;
}

/// Measures a few steps. Other work on the machine increases the wall time and, with several threads that wait for each
/// other, the processor time as well. The time of the fastest batch is therefore taken as that on a free machine.
/// `take_steps(count)` takes `count` steps.
template <class Steps>
void measure_steps(const Scene& scene, const Steps& take_steps, CheckReport& report) {
  const MeasuredSteps wanted = steps_to_measure(scene);
  take_steps(warm_up_steps);
  report.threads = shares_host_memory ? Exec().concurrency() : 1;
  const auto now = [&] { return work_seconds() / report.threads; };
  const double start = now();
  const double wall_start = steady_seconds();
  double fastest = std::numeric_limits<double>::infinity();
  const auto impatient = [&] { return steady_seconds() - wall_start > patience; };
  double before = start;
  do {
    int taken = 0;
    while (taken < wanted.count && !(taken > 0 && impatient())) {
      const int some = std::min(10, wanted.count - taken);
      take_steps(some);
      taken += some;
    }
    report.measured_steps += taken;
    const double after = now();
    if (taken == wanted.count && wanted.in_proportion) {
      fastest = std::min(fastest, after - before);
      report.batch = taken;
    }
    before = after;
  } while (wanted.in_proportion && report.measured_steps + wanted.count <= most_measured && before - start < enough &&
           !impatient());
  const double mean = (now() - start) / report.measured_steps;
  const double mean_wall = (steady_seconds() - wall_start) / report.measured_steps;
  report.seconds_per_step = time_of_a_step(report.batch > 0 ? fastest / report.batch : mean, mean, mean_wall);
  report.slowed_by = report.seconds_per_step > 0 ? mean_wall / report.seconds_per_step : 1;
  for (const auto& [key, interval] : due_intervals(scene))
    if (interval > report.measured_steps) report.not_due.push_back(fmt::format("accuracy.{} = {}", key, interval));
}

/// Computes the shares of pores and of joined ones and writes the picture.
void look_at_pores(const Scene& scene, const Geometry& geometry, const std::string& preview, CheckReport& report) {
  const FluidPicture picture(scene, geometry);
  const JoinedPores joined = joined_pores(picture);
  const auto nodes = static_cast<double>(picture.size());
  report.fluid_nodes = static_cast<int>(picture.fluid_nodes());
  report.porosity = static_cast<double>(picture.fluid_nodes()) / nodes;
  report.joined_x = static_cast<double>(joined.along_x) / nodes;
  report.joined_y = static_cast<double>(joined.along_y) / nodes;
  if (preview.empty()) return;
  constexpr Colour palette[] = {{190, 185, 175}, {0, 114, 178}, {230, 159, 0}, {0, 0, 0}};
  constexpr std::uint8_t rock = 0, through = 1, closed = 2, inside_opening = 3;
  const std::vector<int> opening = opening_of_nodes(scene);
  std::vector<std::uint8_t> pixels(picture.size());
  for (std::size_t n = 0; n < pixels.size(); ++n) {
    pixels[n] = !picture.is_fluid(n) ? rock : joined.either[n] ? through : closed;
    if (!opening.empty() && opening[n] >= 0) pixels[n] = inside_opening;
  }
  write_palette_picture(preview, picture.nx, pixels, palette);
}

/// The report of a laboratory test: of its specimen, before it is loaded.
CheckReport check_specimen(const Scene& scene) {
  CheckReport report;
  const double before = allocated_bytes();
  const Assembly specimen = build_specimen(scene);
  Mechanics rock(specimen, scene.mechanics->parameters, Loads{});
  age_chemically(scene, rock);
  report.bytes = allocated_bytes() - before;
  require_testable(scene, specimen, rock);
  FieldList fields;
  add_rock_fields(rock, fields, scene.output.fields);
  require_fields(fields, scene.output.fields);
  const double dt = scene.mechanics->critical_fraction * rock.critical_step();
  report.limits = limits_of_specimen(scene, specimen, rock);
  report.warnings = scene.warnings;
  report.particles = rock.particles().count;
  report.bonds = rock.bonds().count;
  report.steps = std::llround(longest_test(scene, specimen) / dt);
  measure_steps(
      scene, [&](int count) { rock.advance(Exec(), dt, count); }, report);
  report.seconds = report.seconds_per_step * static_cast<double>(report.steps);
  report.at_most = true;
  report.precision = "double";
  report.preset = scene.accuracy.preset;
  return report;
}

}  // namespace

CheckReport check_case(const Scene& scene, const std::string& preview) {
  if (scene.laboratory && !preview.empty())
    throw InputError("--preview draws a lattice, and a laboratory test has none");
  if (scene.laboratory) return check_specimen(scene);
  if (!preview.empty()) {
    std::vector<std::string> files = input_files(scene);
    files.push_back(scene.path);
    require_place_for_picture(preview, files);
  }
  CheckReport report;
  const double before = allocated_bytes();
  Simulation simulation(scene);
  report.bytes = allocated_bytes() - before;
  const Parts& parts = simulation.parts();
  report.limits = simulation.limits();
  report.dimensionless = dimensionless_numbers(scene);
  require_fields(simulation.fields(), scene.output.fields);
  history_columns(scene, simulation);  // refuses two of one name
  report.warnings = warnings_of(scene, parts, parts.paths);
  report.choices = choice_notes(scene);
  report.schedule = simulation.schedule();
  report.explanation = explain(scene, parts.units);
  report.nx = scene.lattice.nx;
  report.ny = scene.lattice.ny;
  if (parts.rock) {
    report.particles = parts.rock->nodes_of_particle.count();
    report.bonds = parts.rock->bonds;
  }
  if (scene.geometry.kind == GeometryKind::image)
    report.image = read_solid_image(scene.geometry.image, scene.lattice).summary;
  look_at_pores(scene, parts.geometry, preview, report);
  report.spacing = scene.lattice.spacing;
  report.steps = last_step(scene);
  const auto take_steps = [&](int count) {
    for (int step = 0; step < count; ++step) simulation.step();
    simulation.catch_up();
  };
  measure_steps(scene, take_steps, report);
  report.seconds = report.seconds_per_step * static_cast<double>(report.steps);
  const AccuracySection& accuracy = scene.accuracy;  // steps are measured at the start, where intervals are shortest
  report.at_most = accuracy.dissolution_tolerance > 0 || accuracy.flow_tolerance > 0 || accuracy.chooses_intervals();
  report.precision = scene.accuracy.precision == Precision::single_precision ? "single" : "double";
  report.preset = scene.accuracy.preset;
  return report;
}

MeasuredSteps steps_to_measure(const Scene& scene) {
  constexpr int least = 10;
  std::int64_t cycle = 1;
  int longest = least;
  for (const auto& [key, interval] : due_intervals(scene)) {
    if (cycle <= most_measured) cycle = std::lcm(cycle, interval);
    longest = std::max(longest, interval);
  }
  if (cycle > most_measured) return {std::min(longest, longest_stretch), false};
  return {static_cast<int>((least + cycle - 1) / cycle * cycle), true};
}

double time_of_a_step(double fastest, double mean, double mean_wall) {
  return fastest > 0 ? fastest : mean > 0 ? mean : mean_wall;
}

}  // namespace vug
