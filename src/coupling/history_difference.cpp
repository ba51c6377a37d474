#include "coupling/history_difference.hpp"

#include "io/detail/nearest_name.hpp"
#include "kernels/base/require.hpp"

#include <fmt/format.h>

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

/// Whether the values differ by rounding only, as sums of the same terms do.
bool is_still(const std::vector<double>& values) {
  double size = 0;
  for (const double value : values) size = std::max(size, std::abs(value));
  return largest_change(values) <= 1e-9 * size;
}

std::vector<int> columns_of(const History& history, const std::vector<std::string>& wanted) {
  std::vector<int> columns;
  for (const std::string& name : wanted) {
    const int column = history.find(name);
    if (column < 0)
      throw InputError(fmt::format("\"{}\" is no column of the history{}", name, suggestion(name, history.names)));
    columns.push_back(column);
  }
  for (std::size_t c = 0; wanted.empty() && c < history.names.size(); ++c)
    if (is_amount(history.names[c])) columns.push_back(static_cast<int>(c));
  return columns;
}

}  // namespace

Difference largest_difference(const History& reference, const History& other, const std::vector<std::string>& columns) {
  Difference largest;
  for (const int c : columns_of(reference, columns)) {
    const std::vector<double>& truth = reference.values[c];
    if (is_still(truth)) continue;
    const double change = largest_change(truth);
    const std::vector<double>& found = other.values.at(other.find(reference.names[c]));  // settings may add columns
    for (std::size_t row = 0; row < truth.size(); ++row) {
      const double difference = std::abs(found.at(row) - truth[row]) / change;
      if (difference > largest.value || std::isnan(difference))
        largest = {std::isnan(difference) ? std::numeric_limits<double>::infinity() : difference, reference.names[c]};
    }
  }
  return largest;
}

}  // namespace vug
