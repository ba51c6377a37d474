#pragma once
// `vug lab`: a laboratory test from its case to its curve, its pictures and its record.
#include "io/scene.hpp"

#include <iosfwd>
#include <optional>
#include <string>

namespace vug {

/// What the command line adds to a test.
struct LaboratoryOptions {
  std::string directory;
  bool overwrite = false;              ///< replace the results that `directory` holds
  int seeds = 1;                       ///< specimens, which differ in the scatter of their bonds alone
  std::optional<double> fit_strength;  ///< Pa: search for the cohesion of this mean strength instead
  std::ostream* progress = nullptr;    ///< null: quiet
  std::ostream* warnings = nullptr;    ///< where warnings go of a quiet test; null: nowhere
};

/// Runs the test of `scene`, which has a [laboratory], and returns what it found as text for people. The directory then
/// holds stress_strain.csv (of a quench cracks.csv), particles.h5 with its XDMF file (first specimen: every
/// output.interval and the end) and run.json with the results. Throws InputError, StabilityError, FileError,
/// Interrupted.
std::string run_laboratory(const Scene& scene, const LaboratoryOptions& options);

}  // namespace vug
