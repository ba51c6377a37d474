#pragma once
// How many lattice steps what changes slowly is left as it is (docs/model.md, "Intervals from a tolerance").

#include <optional>

namespace vug {

/// Lattice steps, as the keys of [accuracy] of these names.
struct Intervals {
  int heat = 1, solute = 1, wall = 1, exchange = 1, update = 1;
  bool operator==(const Intervals&) const = default;
};

/// By which share of itself has changed since the last look what the intervals hold: temperatures, concentrations, the
/// dissolved volume, the fluid's force on the rock. 0 of what a scene has not; 1 where there is nothing yet.
struct Changes {
  double heat = 0, solute = 0, solid = 0, force = 0;
  std::optional<double> speed{};  ///< that the fluid will not exceed before the next look, lattice units
};

/// The longest interval of at most `most`, a power of two, that is stable where a lattice step takes this share of what
/// a step may take.
inline int stable_interval(int most, double taken) {
  while (most > 1 && most * taken > 1) most /= 2;
  return most;
}

/// The share of itself by which something changed, 1 where it is only about to begin.
inline double share_of(double change, double amount) {
  return amount > 0 ? change / amount : 1;
}

/// The interval that follows `now`, a power of two of at most `most`: what is held changes by at most `allowed` within
/// one, at `change` per lattice step. Shrinks at once, as far as it must; doubles when there is room to spare.
inline int next_interval(int now, int most, double change, double allowed) {
  constexpr double room = 0.7;
  if (now > most || !(now * change <= allowed)) {
    while (now > 1 && (now > most || !(now * change <= allowed))) now /= 2;
    return now;
  }
  return 2 * now <= most && 2 * now * change <= room * allowed ? 2 * now : now;
}

}  // namespace vug
