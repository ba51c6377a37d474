#pragma once
// Settings from a tolerance: the beginning of a case is computed repeatedly with coarser settings, as long as the
// results stay within the tolerance of those with the finest settings.
#include "io/scene.hpp"

#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

namespace vug {

struct TuningOptions {
  double tolerance = 1e-3;            ///< largest difference over the largest change of its column since the start
  std::optional<std::int64_t> steps;  ///< of each pilot; absent: a twentieth of the run, 800 to 8000
  std::vector<std::string> columns;   ///< of the history, to be compared; empty: every amount that changes
  std::ostream* progress = nullptr;   ///< null: quiet
};

/// A setting with its choices, the most accurate first.
struct Setting {
  std::string key;                 ///< "accuracy.heat_interval"
  std::vector<std::string> rungs;  ///< values as in a case file
};

/// The settings that matter to a scene: those of the modules that it has.
std::vector<Setting> settings_of(const Scene& scene);

/// The findings about a setting.
struct TunedSetting {
  Setting setting;
  std::size_t chosen = 0;
  bool seen = true;               ///< whether a column of the pilot depends on it; else it stays as the case has it
  std::vector<double> errors{0};  ///< of the rungs accepted, with all other settings at their first rung
  double error() const { return errors[chosen]; }
};

struct Tuning {
  std::vector<TunedSetting> settings;
  std::int64_t steps = 0;  ///< of a pilot
  int pilots = 0;
  double error = 0;                   ///< of all chosen settings together
  std::string worst;                  ///< the column with that error; empty where nothing differs
  double error_of_case = 0;           ///< of the case as it is; infinite where it is unstable
  double cost = 0, cost_of_case = 0;  ///< time of the pilots' steps over that with the finest settings
};

/// Coarsens every setting alone as long as its error is within half of the tolerance, combines all, and steps back, the
/// setting with the largest error first, until the error of all is within the tolerance. Errors are differences from
/// the first rungs of all settings; errors that these have in common, such as that of the lattice, are not included.
/// Throws what a simulation of the scene throws, and Interrupted.
Tuning tune(const Scene& scene, const TuningOptions& options);

/// A table, and the lines of a case file that choose these settings.
std::string to_text(const Tuning& tuning, double tolerance);

}  // namespace vug
