#pragma once
// Settings from a tolerance: the beginning of a case is computed again and again with coarser settings, as long as what
// comes out stays as near as wanted to what the finest settings give.
#include "io/history_reader.hpp"
#include "io/scene.hpp"

#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

namespace vug {

struct TuningOptions {
  double tolerance = 1e-3;            ///< largest difference, over the largest change of its column since the start
  std::optional<std::int64_t> steps;  ///< of each pilot; absent: a twentieth of the run, 800 to 8000
  std::vector<std::string> columns;   ///< of the history to hold to; none: every amount that changes
  std::ostream* progress = nullptr;   ///< null: quiet
};

/// A setting with its choices, the most accurate first.
struct Setting {
  std::string key;                 ///< "accuracy.heat_interval"
  std::vector<std::string> rungs;  ///< values as in a case file
};

/// The settings that matter to a scene: those of the modules that it has.
std::vector<Setting> settings_of(const Scene& scene);

/// What was found of a setting.
struct TunedSetting {
  Setting setting;
  std::size_t chosen = 0;
  bool seen = true;               ///< whether a column of the pilot depends on it; else it stays as the case has it
  std::vector<double> errors{0};  ///< of the rungs climbed, with all other settings at their first
  double error() const { return errors[chosen]; }
};

struct Tuning {
  std::vector<TunedSetting> settings;
  std::int64_t steps = 0;  ///< of a pilot
  int pilots = 0;
  double error = 0;                   ///< of all chosen together
  std::string worst;                  ///< the column that it is of; empty where nothing differs
  double error_of_case = 0;           ///< of the case as it is; infinite where it does not hold
  double cost = 0, cost_of_case = 0;  ///< processor time of the pilots over that of the finest settings
};

/// The largest difference of two histories with the same rows over `columns` (none: every amount), each over the
/// largest change of that column in `reference` since its first row, and its column. Columns that do not change are
/// left out, and, unless they are asked for, counts, energies and momenta of the rock, and of balances all but what is
/// stored. Throws InputError for a column that is not there.
struct Difference {
  double value = 0;
  std::string column;
};
Difference largest_difference(const History& reference, const History& other, const std::vector<std::string>& columns);

/// Climbs every setting alone until it costs half of the tolerance, takes all together, and steps back, the costliest
/// first, until they are within it. The first rungs of all settings are the truth that is compared with; nothing is
/// told of what they have in common, the lattice. Throws what a simulation of the scene throws, Interrupted.
Tuning tune(const Scene& scene, const TuningOptions& options);

/// A table, and the lines of a case file that choose these settings.
std::string to_text(const Tuning& tuning, double tolerance);

}  // namespace vug
