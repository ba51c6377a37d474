#include "dem/crack_aperture.hpp"

#include "dem/bond_kinematics.hpp"
#include "dem/dissolved_rock.hpp"
#include "kernels/launch/launch.hpp"

namespace vug {

struct FindCrackAperture {
  Particles particles;
  Bonds bonds;
  double expansion, residual, unit;
  ScalarField<double> aperture;

  /// Opening at an end of the edge, from the openings of the integration points nearer to it and further from it.
  KOKKOS_FORCEINLINE_FUNCTION double at_end(double near, double far) const {
    const double middle = (near + far) / 2, opening = middle + (near - middle) / gauss_point;
    return residual + (opening > 0 ? opening : 0);
  }
  KOKKOS_FUNCTION void operator()(int k) const {
    if (is_gone(particles.solid_fraction(bonds.pair(k, 0))) || is_gone(particles.solid_fraction(bonds.pair(k, 1))))
      return;  // the place of a triangle that is gone has no meaning
    const double broken =
        has_failed(bonds.state(k)) ? 1 : bonds.d_m(k);  // also when it was dissolved, whatever its d_m
    if (broken == 0) {
      aperture(k) = 0;
      return;
    }
    const BondMotion motion = motion_of_bond(particles, bonds, expansion, k);
    const double a = motion.opening[0].delta_n, b = motion.opening[1].delta_n;
    aperture(k) = broken * wedge_aperture(at_end(a, b), at_end(b, a)) / unit;
  }
};

void find_crack_apertures(const Exec& exec, const Particles& particles, const Bonds& bonds, double expansion,
                          double residual, double unit, const ScalarField<double>& aperture) {
  for_each_node(exec, "vug::crack_aperture::find", bonds.count,
                FindCrackAperture{particles, bonds, expansion, residual, unit, aperture});
}

}  // namespace vug
