#pragma once
// How much two histories differ.
#include "io/history_reader.hpp"

#include <string>
#include <vector>

namespace vug {

/// The largest difference of two histories with the same rows over `columns` (empty: every amount), and its column.
/// Each difference is divided by the largest change of that column in `reference` since its first row. Columns that do
/// not change are left out. So are, unless they are requested, counts, energies and momenta of the rock, and all of
/// balances except what is stored. Throws InputError for a column that does not exist.
struct Difference {
  double value = 0;
  std::string column;
};
Difference largest_difference(const History& reference, const History& other, const std::vector<std::string>& columns);

}  // namespace vug
