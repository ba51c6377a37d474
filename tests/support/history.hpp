#pragma once
// Numbers of a history.csv.
#include "io/history_reader.hpp"

#include <stdexcept>
#include <string>
#include <vector>

namespace vug::test {

/// A column of the history in a run's folder, one number per row.
inline std::vector<double> history_column(const std::string& folder, const std::string& name) {
  const History history = read_history(folder + "/history.csv");
  const int column = history.find(name);
  if (column < 0) throw std::invalid_argument("no column " + name + " in " + folder);
  return history.values[column];
}

}  // namespace vug::test
