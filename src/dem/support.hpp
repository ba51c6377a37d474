#pragma once
// Supports of the sides of the rock. Does not depend on Kokkos, so that code that only reads a case need not either.

namespace vug {

/// Support of a side. Held particles are those with an edge on the side.
enum class Support {
  free,        ///< no support
  roller,      ///< a frictionless rigid platen: normal motion and rotation are held
  fixed,       ///< a glued rigid platen: all motion is held
  pin,         ///< no motion, but the particles turn
  pin_roller,  ///< no normal motion, but the particles turn
  servo,       ///< a roller whose platen moves so that it presses with the given stress
};

}  // namespace vug
