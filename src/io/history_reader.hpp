#pragma once
// Reads history.csv.
#include <string>
#include <vector>

namespace vug {

/// The columns of a history: values[c][row] belongs to names[c]; the first column is the time in s.
struct History {
  std::vector<std::string> names;
  std::vector<std::vector<double>> values;

  std::size_t rows() const { return values.empty() ? 0 : values.front().size(); }
  const std::vector<double>& time() const { return values.front(); }
  /// Index of a column, or -1.
  int find(const std::string& name) const;
  /// The same of columns that must be there; throws InputError, beginning with `where`, for one that is not.
  std::vector<int> find_all(const std::vector<std::string>& wanted, const std::string& where = "") const;
};

/// Reads a file that HistoryWriter wrote; an incomplete last line is left out. Throws FileError where there is no such
/// file, or where a cell is not a number; an empty bar of error_bars.csv is NaN.
History read_history(const std::string& path);

}  // namespace vug
