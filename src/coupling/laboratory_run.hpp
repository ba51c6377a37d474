#pragma once
// `vug lab`: a laboratory test from its case to its curve, its pictures and its record.
#include "dem/laboratory.hpp"
#include "dem/quench.hpp"
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
};

/// The specimen of a case: generated, or read from its mesh.
Assembly build_specimen(const Scene& scene);

/// How long the mechanics of a test takes at most, s.
double longest_test(const Scene& scene, const Assembly& specimen);

/// The loading test of a case; not for a quench.
PlatenTest platen_test(const Scene& scene);
QuenchTest quench_test(const Scene& scene);

/// Runs the test of `scene`, which has a [laboratory], and returns what it found as text for people. The directory then
/// holds stress_strain.csv (of a quench cracks.csv), particles.h5 with its XDMF file (first specimen: every
/// output.interval and the end) and run.json with the results. Throws InputError, StabilityError, FileError,
/// Interrupted.
std::string run_laboratory(const Scene& scene, const LaboratoryOptions& options);

}  // namespace vug
