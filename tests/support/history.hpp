#pragma once
// Numbers of a history.csv.
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace vug::test {

/// A column of the history in a run's folder, one number per row.
inline std::vector<double> history_column(const std::string& folder, const std::string& name) {
  std::ifstream file(folder + "/history.csv");
  const auto cells = [](const std::string& line) {
    std::vector<std::string> result;
    std::istringstream stream(line);
    for (std::string cell; std::getline(stream, cell, ',');) result.push_back(cell);
    return result;
  };
  std::string line;
  std::getline(file, line);
  const std::vector<std::string> names = cells(line);
  std::size_t column = 0;
  while (column < names.size() && names[column] != name) ++column;
  if (column == names.size()) throw std::invalid_argument("no column " + name + " in " + folder);
  std::vector<double> values;
  while (std::getline(file, line)) values.push_back(std::stod(cells(line).at(column)));
  return values;
}

}  // namespace vug::test
