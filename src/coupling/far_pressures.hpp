#pragma once
// Pressures that single precision rounds too coarsely for the flow that they drive.
#include "coupling/flow_paths.hpp"
#include "io/scene.hpp"
#include "io/units.hpp"

#include <optional>
#include <string>

namespace vug {

/// Where the given pressures of a case lie, Pa.
struct PressureLevels {
  double distance = 0;    ///< of the farthest from flow.initial_pressure
  double difference = 0;  ///< that drives the flow: between two of them, of body forces, or that velocities need
  double middle = 0;      ///< half way between the lowest and the highest
};

/// The levels of a case; nothing without a side or opening that has a pressure. Tables count with all of their values,
/// ramps with the value that they end at. `paths` have the pressure that given velocities need.
std::optional<PressureLevels> pressure_levels(const Scene& scene, const FlowPaths& paths, const LatticeUnits& units);

/// A warning where the case computes in single precision with pressures that are much farther from the initial one than
/// they differ among themselves: populations are deviations from rest at that pressure, so that their rounding is a
/// share of the distance, and the velocity follows from the difference. Empty otherwise.
std::string warning_of_far_pressures(const Scene& scene, const FlowPaths& paths, const LatticeUnits& units);

}  // namespace vug
