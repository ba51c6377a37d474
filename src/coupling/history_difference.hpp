#pragma once
// How much two histories differ.
#include "io/history_reader.hpp"
#include "io/scene/geometry.hpp"

#include <string>
#include <vector>

namespace vug {

/// Share of a larger amount below which another is its rounding.
inline constexpr double rounding_share = 1e-9;

/// Speed of sound on a lattice, spacing/(3^1/2 time step), m/s.
double speed_of_sound(const LatticeSection& lattice);

/// Whether a column is a component of the mean velocity that is rounding: its largest change is below `share` of that
/// of the other component, as across a symmetric channel, or of the largest speed in the history, as in a closed
/// cavity. `sound`: the speed of sound of the lattice, m/s, for that speed; 0: it is not known.
bool is_rounding_of_velocity(const History& history, int column, double sound, double share = rounding_share);

/// The largest difference of two histories with the same rows over `columns` (empty: every amount), and its column.
/// Each difference is divided by the largest change of that column in `reference` since its first row, that of a
/// component of the mean velocity by the larger one of both components. Columns that do not change are left out, and
/// components that are rounding of the other. So are, unless they are requested, counts, energies and momenta of the
/// rock, all of balances except what is stored, and a mean velocity that is rounding (`sound` as above). Rates
/// (flows, means of what crosses) count from the second row on. Throws InputError for a column that does not exist.
struct Difference {
  double value = 0;
  std::string column;
};
Difference largest_difference(const History& reference, const History& other, const std::vector<std::string>& columns,
                              double sound = 0);

}  // namespace vug
