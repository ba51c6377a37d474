#pragma once
// How fast anything in the rock may be. Does not depend on Kokkos, so that code that only reads a case need not either.

namespace vug {

/// Speed above which a particle counts as diverged, m/s: nothing in rock is faster than its sound, and no platen may
/// be.
inline constexpr double runaway_speed = 3000;

}  // namespace vug
