#pragma once
// The virtual laboratory: a block or a disc of bonded triangles between two platens, as in paper section 3.5.2.
#include "dem/mechanics.hpp"

#include <functional>
#include <optional>
#include <vector>

namespace vug {

/// Shape of the specimen between the platens.
enum class Specimen {
  block,  ///< stress = force over width
  disc,   ///< with flats at the platens: stress = 2 F / (pi D) times splitting_share (splitting.hpp)
};

/// A test between two rigid frictionless platens along y. The specimen is strained by the platens (compression,
/// tension, Brazilian disc) or by its own thermal expansion between platens that do not move.
struct PlatenTest {
  Specimen specimen = Specimen::block;
  double speed = 0.5;       ///< of the upper platen, m/s; positive compresses, negative pulls
  double heating_rate = 0;  ///< of the whole specimen, K/s, applied in every step; needs speed = 0
  /// Pressure on the flanks of a block, Pa; applied before the test, while the platens do not move.
  double confinement = 0;
  /// Support::free: the pressure is the dead load of a membrane, constant to the bit; Support::servo: it is that of
  /// rigid frictionless platens that follow it (servo.hpp).
  Support flanks = Support::free;
  double confining_time = 150e-6;                      ///< s, of the ramp to that pressure
  double confining_damping = default_preload_damping;  ///< Cundall's alpha during it
  double largest_strain = 0.02;  ///< strain at which the test ends at the latest; when heated, exactly there
  double stop_below = 0.6;       ///< the test ends when the stress has fallen to this share of its peak
  double step_fraction = 0.3;    ///< time step over the critical one
  double sample_strain = 1e-5;   ///< strain between two points of the curve
  double chemical_damage = 0;    ///< d_c of all bonds, as after soaking in acid
};

/// Length of the edges that lie on a side of the bounding rectangle, which platens and a confinement load, m.
double loaded_length(const Assembly& specimen, const std::vector<BoundaryEdge>& boundary, RockSide side);

/// Width of the flats of a disc over its diameter: the mean of the edges at its top and at its bottom.
double flat_width(const Assembly& disc, const std::vector<BoundaryEdge>& boundary);

/// Loads on the specimen by the platens and flanks of a test.
Loads press(const PlatenTest& test);

/// Whether load or heat has broken the bond: neither a fracture from the start, nor dissolved.
constexpr bool has_broken(BondState state) {
  return state == BondState::failed_in_tension || state == BondState::failed_in_shear;
}
inline int broken(const BondCounts& bonds) {
  return bonds.failed_in_tension + bonds.failed_in_shear;
}

/// Results of a test. Stress and strain are positive in the sense in which the platens load: compression in a
/// compression test, a Brazilian test and when heated, tension in a tension test.
struct PlatenResult {
  std::vector<double> strain;  ///< of the platens over the distance of the held centroids, or mean alpha times dT
  std::vector<double> stress;  ///< mean force of the two platens over the width; for a disc the splitting stress, Pa
  std::vector<double> confinement;  ///< mean pressure of servo platens on the flanks, or the membrane's, Pa
  /// For a block: chord modulus of gauges at 20 and 80 % of the height, from 20 to 50 % of the peak, Pa; NaN where the
  /// curve has too few points there, or is that of the first wave.
  double modulus = 0;
  bool gauged = true;      ///< whether there are triangles at all gauges of a block
  double poisson = 0;      ///< from gauges at the flanks, for the same chord
  double strength = 0;     ///< largest stress, Pa; the strength of the rock only if the test passed a peak
  double peak_strain = 0;  ///< strain there
  BondCounts bonds_at_peak;
  BondCounts bonds_at_end;
  std::optional<PreloadReport> preload;  ///< how the confinement was applied
  Energies energies;                     ///< at the end; with parameters.energy_ledger
  double time_step = 0;                  ///< s
  long steps = 0;

  /// Whether bonds have failed and the stress has fallen from its largest value, or there was none: rock without
  /// strength. Where it still rises at the end, the rock could have carried more, even if bonds have failed.
  bool passed_a_peak() const { return broken(bonds_at_end) > 0 && (strength <= 0 || stress.back() < 0.95 * strength); }
};

/// Called after every point of the curve with the rock, the result so far (moduli are computed at the end), and whether
/// it is the last point. It may write pictures, but must not change anything.
using LaboratoryWatch = std::function<void(const Mechanics&, const PlatenResult&, bool last)>;

/// Strains a specimen until it breaks. Throws StabilityError when the motion is no longer finite, InputError for a test
/// with contradictory settings.
PlatenResult load_between_platens(const Exec& exec, const Assembly& specimen, const MechanicsParameters& parameters,
                                  const PlatenTest& test, const LaboratoryWatch& watch = {});

/// Mean and scatter of a number over several specimens.
struct Spread {
  double mean = 0;
  double deviation = 0;  ///< standard deviation of a single specimen (n - 1); 0 for one specimen
};
Spread spread_of(const std::vector<double>& values);

/// Result of a search for the cohesion.
struct CohesionFit {
  double cohesion = 0;  ///< Pa
  Spread strength;      ///< over the seeds, Pa
  int rounds = 0;
  std::optional<PreloadReport> restless;  ///< of a specimen that broke under its confinement or did not come to rest
};

/// The test of a rock with these parameters: weak rock is pressed more slowly.
using TestOfRock = std::function<PlatenTest(const MechanicsParameters&)>;

/// Finds the cohesion at which the mean strength over `seeds` consecutive seeds is `strength`, to `tolerance`
/// (relative). Strength is nearly proportional to cohesion, so c <- c strength / mean converges in a few rounds.
/// Materials whose cohesion is that of the rock follow. Throws InputError when ten rounds are not enough, or when a
/// specimen passes no peak, because its largest stress is then only that at the end of the test.
CohesionFit fit_cohesion(const Exec& exec, const Assembly& specimen, MechanicsParameters parameters,
                         const TestOfRock& test, double strength, int seeds, double tolerance);

}  // namespace vug
