#pragma once
// For how many lattice steps slow quantities are held (docs/model.md, "Intervals from a tolerance").

#include <optional>

namespace vug {

/// Lattice steps, as the keys of [accuracy] with these names.
struct Intervals {
  int heat = 1, solute = 1, wall = 1, exchange = 1, update = 1;
  bool operator==(const Intervals&) const = default;
};

/// Shares by which the quantities that intervals hold have changed since the last look: temperatures, concentrations,
/// the dissolved volume, the fluid's force on the rock. 0 for what the scene does not have and for what there is none
/// of (amount_share.hpp); 1 where there is no force yet.
struct Changes {
  double heat = 0, solute = 0, solid = 0, force = 0;
  std::optional<double> speed{};  ///< bound of the fluid's speed until the next look, lattice units
};

/// The longest stable interval, a power of two of at most `most`. `taken` is the length of a lattice step over that of
/// the longest stable step.
inline int stable_interval(int most, double taken) {
  while (most > 1 && most * taken > 1) most /= 2;
  return most;
}

/// Share of itself by which something has changed; 1 where it has not begun yet.
inline double share_of(double change, double amount) {
  return amount > 0 ? change / amount : 1;
}

/// The interval that follows `now`, a power of two of at most `most`. What is held may change by at most `allowed`
/// within it, at `change` per lattice step. Shrinks at once as far as necessary; doubles where there is enough room.
inline int next_interval(int now, int most, double change, double allowed) {
  constexpr double room = 0.7;
  if (now > most || !(now * change <= allowed)) {
    while (now > 1 && (now > most || !(now * change <= allowed))) now /= 2;
    return now;
  }
  return 2 * now <= most && 2 * now * change <= room * allowed ? 2 * now : now;
}

}  // namespace vug
