#pragma once
// The virtual laboratory: loading tests on a block or a disc of bonded triangles, as in paper section 3.5.2.
#include "dem/mechanics.hpp"

#include <vector>

namespace vug {

/// A test between two rigid frictionless platens along y.
struct PlatenTest {
  double speed = 0.5;            ///< of the upper platen, m/s; positive compresses, negative pulls
  double largest_strain = 0.02;  ///< where the test ends at the latest
  double stop_below = 0.6;       ///< ends when the stress has fallen to this share of its peak
  double step_fraction = 0.3;    ///< time step over the critical one
  double sample_strain = 1e-5;   ///< between two points of the curve
  double chemical_damage = 0;    ///< d_c of all bonds, as after soaking in acid
};

/// What the press records; compression positive in a compression test, tension positive in a tension test.
struct PlatenResult {
  std::vector<double> strain;  ///< of the platens over the distance of the held centroids
  std::vector<double> stress;  ///< mean force of the two platens over the width, Pa
  double modulus = 0;          ///< chord of gauges at 20 and 80 % of the height, 20 to 50 % of the peak, Pa
  double poisson = 0;          ///< from gauges at the flanks, the same chord
  double strength = 0;         ///< largest stress, Pa
  double peak_strain = 0;      ///< strain there
  BondCounts bonds_at_peak;
  BondCounts bonds_at_end;
  double time_step = 0;  ///< s
  long steps = 0;
};

/// Strains a block of width × height whose lower left corner is the origin until it breaks.
PlatenResult load_between_platens(const Exec& exec, const Assembly& block, const MechanicsParameters& parameters,
                                  const PlatenTest& test);

/// The cohesion at which the mean strength over `seeds` consecutive seeds is `strength`. Strength is nearly
/// proportional to cohesion, so c <- c strength / mean converges in a few rounds; ends when the mean is within
/// `tolerance` (relative). Throws InputError when ten rounds are not enough.
double fit_cohesion(const Exec& exec, const Assembly& block, MechanicsParameters parameters, const PlatenTest& test,
                    double strength, int seeds, double tolerance);

}  // namespace vug
