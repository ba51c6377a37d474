#pragma once
// How a side of the rock is held. Free of Kokkos: what only reads a case needs no more.

namespace vug {

/// How a side is held. Held particles are those with an edge on the side.
enum class Support {
  free,        ///< not at all
  roller,      ///< a frictionless rigid platen: normal motion and rotation are held
  fixed,       ///< a glued rigid platen: all motion is held
  pin,         ///< no motion, but the particles turn
  pin_roller,  ///< no normal motion, but the particles turn
  servo,       ///< a roller whose platen moves so that it presses with the wanted stress
};

}  // namespace vug
