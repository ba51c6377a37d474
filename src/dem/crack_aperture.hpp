#pragma once
// Apertures of cracks, for the flow through them.
#include "dem/bonds.hpp"

namespace vug {

/// Aperture of the plane slot that conducts as well as a wedge from aperture `a` to `b`: by lubrication the resistances
/// 12/w^3 are in series, the mean of 1/w^3 over a linear w is (a + b)/(2 a^2 b^2). 0 where one end is closed.
KOKKOS_FORCEINLINE_FUNCTION double wedge_aperture(double a, double b) {
  return a + b > 0 ? Kokkos::cbrt(2 * a * a * b * b / (a + b)) : 0;
}

/// Sets aperture(bond) to d_m (1 for a bond that has failed) times the aperture of the wedge between the bond's two
/// faces, in units of `unit` m. The aperture at each end is the distance along the normal by which the faces have
/// parted there, at least 0, plus `residual` (m), which a crack keeps when it closes (rough faces). A bond of a
/// triangle that is gone keeps the aperture that it had.
void find_crack_apertures(const Exec& exec, const Particles& particles, const Bonds& bonds, double expansion,
                          double residual, double unit, const ScalarField<double>& aperture);

}  // namespace vug
