#pragma once
// `vug check`: derived numbers, size and cost of a case, before it is run.
#include "coupling/dimensionless.hpp"
#include "coupling/limits.hpp"
#include "coupling/task.hpp"
#include "io/image_reader.hpp"
#include "io/scene.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace vug {

/// Derived numbers, size and cost of a case.
struct CheckReport {
  LimitTable limits;
  DimensionlessNumbers dimensionless;
  std::vector<Task> schedule;  ///< empty for a laboratory test
  std::string explanation;     ///< its numbers in lattice units (explain.hpp); empty for a laboratory test
  std::vector<std::string> warnings;
  std::vector<std::string> choices;  ///< what the choices of the case gain and cost, as measured
  double spacing = 0;                ///< m
  int nx = 0, ny = 0, fluid_nodes = 0, particles = 0, bonds = 0;
  double porosity = 0;                ///< fluid share of the lattice at the start
  double joined_x = 0, joined_y = 0;  ///< share of the lattice: fluid that connects left and right, bottom and top
  std::optional<ImageSummary> image;  ///< of the picture that the rock was read from
  double bytes = 0;                   ///< in Views
  std::int64_t steps = 0;
  int batch = 0;                     ///< steps that were measured together; 0: all of measured_steps
  int measured_steps = 0;            ///< at the start
  std::vector<std::string> not_due;  ///< intervals longer than measured_steps, "accuracy.heat_interval = 400"
  int threads = 0;
  double seconds_per_step =
      0;                 ///< mean of the fastest batch, else of all: processor time over threads; on a GPU wall time
  double slowed_by = 1;  ///< mean wall time of all steps over seconds_per_step; far above 1 the machine is busy
  double seconds = 0;    ///< steps x seconds_per_step
  /// Whether there may be fewer or cheaper steps: a specimen breaks earlier, rock ages faster than the fluid, the flow
  /// is held, or intervals grow.
  bool at_most = false;
  std::string precision, preset;
};

/// Builds the case and measures a few of its steps, whose results are discarded. For a laboratory test it builds the
/// specimen: then nx and ny are 0, and `steps` is the largest number of steps of its mechanics. Writes no file, except
/// where `preview` names a PNG: a picture of the geometry at the start with rock, pores that connect two opposite
/// sides, other pores, and openings. Throws InputError when the preview would replace a file of the case or is not a
/// PNG.
CheckReport check_case(const Scene& scene, const std::string& preview = "");

/// How many steps at least have to be measured for all that is due at intervals to be in them.
struct MeasuredSteps {
  int count = 10;
  bool in_proportion = true;  ///< any so many steps have each in its proportion; several such batches can be compared
};

/// The smallest multiple, from 10 on, of all intervals of what the case has, where that is at most 200. Else the
/// longest of these intervals, but at most 1000. Without `wall_interval`: walls are renewed more often at first, never
/// more seldom, than later.
MeasuredSteps steps_to_measure(const Scene& scene);

/// Seconds per step, from the time of the fastest batch of steps. Where the clock of the processor did not tick in it,
/// from that of all measured steps, else from their wall time. All in s per step.
double time_of_a_step(double fastest, double mean, double mean_wall);

/// The report as text for a person, or as JSON.
std::string to_text(const CheckReport& report);
std::string to_json(const CheckReport& report);

}  // namespace vug
