#pragma once
// The four sides of the lattice. Without Kokkos, for code that only reads a case.
#include <array>

namespace vug {

/// Sides of the lattice; the value is the number of the outward velocity in D2Q5 and D2Q9.
enum class Side : int { right = 1, top = 2, left = 3, bottom = 4 };
using SideOrder = std::array<Side, 4>;
inline constexpr SideOrder all_sides{Side::left, Side::right, Side::bottom, Side::top};

constexpr bool is_upright(Side side) {
  return side == Side::left || side == Side::right;
}

/// Name of a side in the case file.
constexpr const char* name_of(Side side) {
  constexpr const char* names[] = {"right", "top", "left", "bottom"};
  return names[static_cast<int>(side) - 1];
}

}  // namespace vug
