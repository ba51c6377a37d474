#pragma once
// `vug check`: what a case amounts to and what it will cost, before it is run.
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
  std::vector<Task> schedule;  ///< empty of a laboratory test
  std::string explanation;     ///< what its numbers are on the lattice (explain.hpp); likewise
  std::vector<std::string> warnings;
  std::vector<std::string> choices;  ///< what those of the case gain and cost, as measured
  double spacing = 0;                ///< m
  int nx = 0, ny = 0, fluid_nodes = 0, particles = 0, bonds = 0;
  double porosity = 0;                ///< fluid share of the lattice at the start
  double joined_x = 0, joined_y = 0;  ///< the same of fluid that reaches from left to right, from bottom to top
  std::optional<ImageSummary> image;  ///< of a picture that the rock was read from
  double bytes = 0;                   ///< held in Views
  std::int64_t steps = 0;
  int measured_steps = 0;  ///< of a copy of the case, at the start
  int threads = 0;
  double seconds_per_step = 0;  ///< of the fastest ten: processor time over threads; on a GPU what the clock says
  double slowed_by = 1;         ///< how much longer all took in the mean by the clock: far above 1 the machine is busy
  double seconds = 0;           ///< steps x seconds_per_step
  /// Steps may turn out fewer or cheaper: specimens break earlier, rock ages faster than the fluid, the flow is held,
  /// intervals grow.
  bool at_most = false;
  std::string precision, preset;
};

/// Builds the case (of a laboratory test its specimen: then nx, ny are 0, and steps are those of its mechanics at
/// most), measures a few steps of it that are then forgotten, and writes nothing but, where `preview` names one, a PNG
/// of the geometry at the start: rock, pores that are joined from one side to another, others, openings. Throws
/// InputError for a preview in place of a file of the case, or of anything but a PNG.
CheckReport check_case(const Scene& scene, const std::string& preview = "");

/// The report as text for a person, or as JSON.
std::string to_text(const CheckReport& report);
std::string to_json(const CheckReport& report);

}  // namespace vug
