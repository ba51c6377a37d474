#pragma once
// The temperature at which the reaction at a wall proceeds.
#include "base/base.hpp"
#include "kernels/launch/prefetch.hpp"

namespace vug {

/// lambda_s/(lambda_f + lambda_s) of a solid node: that of its mineral, or the same for all.
struct SolidShare {
  double of_all = 0.5;
  Kokkos::View<const std::uint8_t*> mineral{};  ///< (dense node)
  Kokkos::View<const double*> of_mineral{};     ///< (mineral) empty: the same for all
  KOKKOS_FORCEINLINE_FUNCTION double operator()(int solid) const {
    return of_mineral.extent(0) > 0 ? of_mineral(mineral(solid)) : of_all;
  }
};

/// Temperature in K of the face between a solid and a fluid node whose centres are half a node away on either side:
/// (lambda_f T_f + lambda_s T_s)/(lambda_f + lambda_s), from continuity of the heat flux (Eq. 4).
template <class T>
struct FaceTemperature {
  Kokkos::View<const T*> theta;  ///< (dense node), K above the reference
  SolidShare solid_share;
  double reference = 0;  ///< K
  /// Prefetches the values of both nodes.
  KOKKOS_FORCEINLINE_FUNCTION void announce(int solid, int fluid) const {
    prefetch(&theta(solid));
    prefetch(&theta(fluid));
  }
  KOKKOS_FORCEINLINE_FUNCTION double operator()(int solid, int fluid) const {
    const double share = solid_share(solid);
    return reference + share * static_cast<double>(theta(solid)) + (1 - share) * static_cast<double>(theta(fluid));
  }
};

}  // namespace vug
