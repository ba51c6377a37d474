#pragma once
// The numbers that `vug check` prints, by name.
#include "coupling/simulation.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <vector>

namespace vug::test {

inline LimitTable limits_of(const std::string& text, const std::vector<std::string>& overrides = {}) {
  return Simulation(parse_scene(text, "a.toml", overrides)).limits();
}

/// Whether there is a number of this name.
inline bool has_limit(const LimitTable& limits, const std::string& name) {
  return std::any_of(limits.begin(), limits.end(), [&](const Limit& limit) { return limit.name == name; });
}

/// The first number of a module whose name begins like this.
inline const Limit& limit_of(const LimitTable& limits, const std::string& module, const std::string& name) {
  for (const Limit& limit : limits)
    if (limit.module == module && limit.name.starts_with(name)) return limit;
  throw std::invalid_argument("no limit " + module + ": " + name);
}

/// The value of a column in the history at present.
inline double history_value(const Simulation& run, const std::string& name) {
  for (const HistoryValue& value : run.history())
    if (value.name == name) return value.value;
  throw std::invalid_argument("no column " + name);
}

/// The largest Mach number in so many steps, looked at now and then.
inline double largest_mach(Simulation& run, int steps, int between = 50) {
  double largest = 0;
  for (int step = 1; step <= steps; ++step) {
    run.step();
    if (step % between == 0) largest = std::max(largest, history_value(run, "largest_mach_1"));
  }
  return largest;
}

}  // namespace vug::test
