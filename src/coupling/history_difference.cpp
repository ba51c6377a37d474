#include "coupling/history_difference.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace vug {

namespace {

/// Whether a column is an amount. Excluded are counts, parts of balances, and the energy and momentum of the rock,
/// which oscillate.
bool is_amount(const std::string& name) {
  if (name.ends_with("_1") || name == "time_s") return false;
  if (name.find("_energy_") != std::string::npos || name.find("_momentum_") != std::string::npos) return false;
  return name.find("_initial_") == std::string::npos && name.find("_gain_") == std::string::npos;
}

double largest_change(const std::vector<double>& values) {
  double change = 0;
  for (const double value : values) change = std::max(change, std::abs(value - values.front()));
  return change;
}

/// Row from which a column counts: rates at the start are those of a first step, long or short, after whatever jump.
std::size_t first_row(const std::string& name) {
  return name.find("_flow_") != std::string::npos || name.find("_mean_") != std::string::npos ? 1 : 0;
}

/// Whether the values differ by rounding only, as sums of the same terms do.
bool is_still(const std::vector<double>& values) {
  double size = 0;
  for (const double value : values) size = std::max(size, std::abs(value));
  return largest_change(values) <= 1e-9 * size;
}

/// The column of the other component, where a column is a component of the mean velocity; otherwise -1.
int other_component(const History& history, int column) {
  const std::string x = "mean_velocity_x_m/s", y = "mean_velocity_y_m/s", &name = history.names[column];
  return name == x ? history.find(y) : name == y ? history.find(x) : -1;
}

/// The largest change by which differences in a column are divided.
double scale_of(const History& history, int column) {
  const double own = largest_change(history.values[column]);
  const int other = other_component(history, column);
  return other < 0 ? own : std::max(own, largest_change(history.values[other]));
}

std::vector<int> columns_of(const History& history, const std::vector<std::string>& wanted, double sound) {
  std::vector<int> columns = history.find_all(wanted);
  for (std::size_t c = 0; wanted.empty() && c < history.names.size(); ++c)
    if (const int column = static_cast<int>(c);
        is_amount(history.names[c]) && !is_rounding_of_velocity(history, column, sound))
      columns.push_back(column);
  return columns;
}

}  // namespace

double speed_of_sound(const LatticeSection& lattice) {
  return lattice.spacing / (std::sqrt(3.0) * lattice.time_step);
}

bool is_rounding_of_velocity(const History& history, int column, double sound, double share) {
  const int other = other_component(history, column), mach = history.find("largest_mach_1");
  if (other < 0) return false;
  double larger = largest_change(history.values[other]);
  if (mach >= 0)
    for (const double value : history.values[mach]) larger = std::max(larger, value * sound);
  const double own = largest_change(history.values[column]);
  return own > 0 && own <= share * larger;
}

Difference largest_difference(const History& reference, const History& other, const std::vector<std::string>& columns,
                              double sound) {
  Difference largest;
  for (const int c : columns_of(reference, columns, sound)) {
    const std::size_t first = std::min(first_row(reference.names[c]), reference.values[c].size());
    const std::vector<double> truth(reference.values[c].begin() + static_cast<std::ptrdiff_t>(first),
                                    reference.values[c].end());
    if (truth.empty() || is_still(truth) || is_rounding_of_velocity(reference, c, 0)) continue;
    const double change = first > 0 ? largest_change(truth) : scale_of(reference, c);
    const std::vector<double>& found = other.values.at(other.find(reference.names[c]));  // settings may add columns
    for (std::size_t row = 0; row < truth.size(); ++row) {
      const double difference = std::abs(found.at(first + row) - truth[row]) / change;
      if (difference > largest.value || std::isnan(difference))
        largest = {std::isnan(difference) ? std::numeric_limits<double>::infinity() : difference, reference.names[c]};
    }
  }
  return largest;
}

}  // namespace vug
