#pragma once
// The laws at an interface between fluid and rock: continuous temperature, continuous heat flux (paper Eq. 4).
#include "kernels/base/base.hpp"

namespace vug {

/// Reflection r = (1 - sigma) / (1 + sigma) of a link between fluid and solid, sigma = (rho cp)_s / (rho cp)_f.
KOKKOS_FORCEINLINE_FUNCTION constexpr double interface_reflection(double capacity_ratio) {
  return (1 - capacity_ratio) / (1 + capacity_ratio);
}

/// The population that arrives through a link: in = pulled + r (s_nb - s_x) (own - pulled), where `pulled` left the
/// neighbour for this node, `own` left this node for the neighbour in the same step, and s is 1 in solid, 0 in fluid.
/// Between unlike nodes this is Li, Chen, Mei & Klausner's half-link condition: into fluid
/// [(1 - sigma) own + 2 sigma pulled] / (1 + sigma), into solid [2 pulled - (1 - sigma) own] / (1 + sigma). Conserves
/// energy: (own - in) on the fluid side is sigma times (in - own) on the solid side.
template <class T>
KOKKOS_FORCEINLINE_FUNCTION T conjugate_link(T pulled, T own, T r, T solid_here, T solid_beyond) {
  return pulled + r * (solid_beyond - solid_here) * (own - pulled);
}

/// The same between any two kinds of matter, by their heat capacities: r = (c_x - c_nb) / (c_x + c_nb). It is the law
/// above where one of them is fluid, c = 1, and passes what was pulled between like nodes.
template <class T>
KOKKOS_FORCEINLINE_FUNCTION T conjugate_link_of(T pulled, T own, T capacity_here, T capacity_beyond) {
  return pulled + (capacity_here - capacity_beyond) / (capacity_here + capacity_beyond) * (own - pulled);
}

}  // namespace vug
