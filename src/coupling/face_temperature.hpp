#pragma once
// The temperature that the reaction at a wall sees.
#include "kernels/base/base.hpp"
#include "kernels/launch/prefetch.hpp"

namespace vug {

/// Temperature in K of the face between a solid and a fluid node whose centres are half a node away on either side:
/// (lambda_f T_f + lambda_s T_s)/(lambda_f + lambda_s), from continuity of the heat flux (Eq. 4).
template <class T>
struct FaceTemperature {
  Kokkos::View<const T*> theta;  ///< (dense node), K above the reference
  double solid_share = 0.5;      ///< lambda_s/(lambda_f + lambda_s)
  double reference = 0;          ///< K
  /// That both will be asked for.
  KOKKOS_FORCEINLINE_FUNCTION void announce(int solid, int fluid) const {
    prefetch(&theta(solid));
    prefetch(&theta(fluid));
  }
  KOKKOS_FORCEINLINE_FUNCTION double operator()(int solid, int fluid) const {
    return reference + solid_share * static_cast<double>(theta(solid)) +
           (1 - solid_share) * static_cast<double>(theta(fluid));
  }
};

/// The same with the conductivity of the mineral.
template <class T>
struct MineralFaceTemperature {
  Kokkos::View<const T*> theta;               ///< (dense node), K above the reference
  Kokkos::View<const std::uint8_t*> mineral;  ///< (dense node)
  Kokkos::View<const double*> solid_share;    ///< (mineral) lambda_s/(lambda_f + lambda_s)
  double reference = 0;                       ///< K
  /// That both will be asked for.
  KOKKOS_FORCEINLINE_FUNCTION void announce(int solid, int fluid) const {
    prefetch(&theta(solid));
    prefetch(&theta(fluid));
  }
  KOKKOS_FORCEINLINE_FUNCTION double operator()(int solid, int fluid) const {
    const double share = solid_share(mineral(solid));
    return reference + share * static_cast<double>(theta(solid)) + (1 - share) * static_cast<double>(theta(fluid));
  }
};

}  // namespace vug
