#pragma once
// `vug lab`: runs a laboratory test from its case and writes its curve, its pictures and its record.
#include "io/scene.hpp"

#include <iosfwd>
#include <optional>
#include <string>

namespace vug {

/// Options of the command line.
struct LaboratoryOptions {
  std::string directory;
  bool overwrite = false;              ///< replace the results in `directory`
  int seeds = 1;                       ///< number of specimens, which differ only in the scatter of their bonds
  std::optional<double> fit_strength;  ///< Pa: search for the cohesion that gives this mean strength instead
  std::ostream* progress = nullptr;    ///< null: quiet
  std::ostream* warnings = nullptr;    ///< for warnings of a quiet test; null: nowhere
};

/// Runs the test of `scene`, which has a [laboratory], and returns its findings as text for people. The directory then
/// contains stress_strain.csv (for a quench cracks.csv), particles.h5 with its XDMF file (first specimen, every
/// output.interval and at the end) and run.json with the results. Throws InputError, StabilityError, FileError,
/// Interrupted.
std::string run_laboratory(const Scene& scene, const LaboratoryOptions& options);

}  // namespace vug
