#pragma once
// The virtual laboratory: a block or a disc of bonded triangles between two platens, as in paper section 3.5.2.
#include "dem/mechanics.hpp"

#include <functional>
#include <optional>
#include <vector>

namespace vug {

/// What stands between the platens.
enum class Specimen {
  block,  ///< stress = force over width
  disc,   ///< with flats where the platens stand: stress = 2 F / (pi D) times splitting_share (splitting.hpp)
};

/// A test between two rigid frictionless platens along y. The specimen is strained by the platens (compression,
/// tension, Brazilian disc) or by its own heat between platens that stand still.
struct PlatenTest {
  Specimen specimen = Specimen::block;
  double speed = 0.5;       ///< of the upper platen, m/s; positive compresses, negative pulls
  double heating_rate = 0;  ///< of the whole specimen, K/s; needs speed = 0; each step adds its share
  /// Pressure on the flanks of a block, Pa, put on before the test with the platens standing still.
  double confinement = 0;
  /// Support::free: the pressure is the dead load of a membrane, constant to the bit; Support::servo: that of rigid
  /// frictionless platens which follow it (servo.hpp).
  Support flanks = Support::free;
  double confining_time = 150e-6;                      ///< s over which it is raised
  double confining_damping = default_preload_damping;  ///< Cundall's alpha meanwhile
  double largest_strain = 0.02;                        ///< where the test ends at the latest; heating to the step
  double stop_below = 0.6;                             ///< ends when the stress has fallen to this share of its peak
  double step_fraction = 0.3;                          ///< time step over the critical one
  double sample_strain = 1e-5;                         ///< between two points of the curve
  double chemical_damage = 0;                          ///< d_c of all bonds, as after soaking in acid
};

/// Width of the flats of a disc over its diameter: the mean of the edges at its top and at its bottom.
double flat_width(const Assembly& disc, const std::vector<BoundaryEdge>& boundary);

/// What the platens and flanks of a test do to the specimen.
Loads press(const PlatenTest& test);

/// A bond that load or heat has broken: neither a fracture that was there, nor dissolved.
constexpr bool has_broken(BondState state) {
  return state == BondState::failed_in_tension || state == BondState::failed_in_shear;
}
inline int broken(const BondCounts& bonds) {
  return bonds.failed_in_tension + bonds.failed_in_shear;
}

/// What the press records. Stress and strain count positive in the sense in which the platens load: compression in a
/// compression test, a Brazilian test and when heated, tension in a tension test.
struct PlatenResult {
  std::vector<double> strain;  ///< of the platens over the distance of the held centroids, or mean alpha times dT
  std::vector<double> stress;  ///< mean force of the two platens over the width, of a disc the splitting stress, Pa
  std::vector<double> confinement;  ///< mean pressure of servo platens on the flanks, or the membrane's, Pa
  /// Of a block: chord of gauges at 20 and 80 % of the height, 20 to 50 % of the peak, Pa; NaN where the curve has too
  /// few points there.
  double modulus = 0;
  bool gauged = true;      ///< whether there are triangles at all gauges of a block
  double poisson = 0;      ///< from gauges at the flanks, the same chord
  double strength = 0;     ///< largest stress, Pa; of the rock only if the test passed a peak
  double peak_strain = 0;  ///< strain there
  BondCounts bonds_at_peak;
  BondCounts bonds_at_end;
  std::optional<PreloadReport> preload;  ///< how the confinement was put on
  Energies energies;                     ///< at the end; with parameters.energy_ledger
  double time_step = 0;                  ///< s
  long steps = 0;

  /// Bonds have failed and the stress has fallen from its largest: where it still rises at the end the rock would have
  /// borne more, whatever has failed by then.
  bool passed_a_peak() const { return broken(bonds_at_end) > 0 && stress.back() < 0.95 * strength; }
};

/// Called after every point of the curve with the rock and the result so far (moduli come at the end), and whether it
/// is the last one; may write pictures, may change nothing.
using LaboratoryWatch = std::function<void(const Mechanics&, const PlatenResult&, bool last)>;

/// Strains a specimen until it breaks. Throws StabilityError when the motion is no longer finite, InputError for a
/// test that contradicts itself.
PlatenResult load_between_platens(const Exec& exec, const Assembly& specimen, const MechanicsParameters& parameters,
                                  const PlatenTest& test, const LaboratoryWatch& watch = {});

/// A number over several specimens.
struct Spread {
  double mean = 0;
  double deviation = 0;  ///< of a single specimen (n - 1); 0 of one
};
Spread spread_of(const std::vector<double>& values);

/// What a search for the cohesion has found.
struct CohesionFit {
  double cohesion = 0;  ///< Pa
  Spread strength;      ///< over the seeds, Pa
  int rounds = 0;
  std::optional<PreloadReport> restless;  ///< of a specimen that did not come to rest under its confinement, or broke
};

/// The cohesion at which the mean strength over `seeds` consecutive seeds is `strength`, to `tolerance` (relative).
/// Strength is nearly proportional to cohesion, so c <- c strength / mean converges in a few rounds. Materials whose
/// cohesion is that of the rock follow. Throws InputError when ten are not enough, or when a specimen passes no peak:
/// its largest stress is then that of the end of the test.
CohesionFit fit_cohesion(const Exec& exec, const Assembly& specimen, MechanicsParameters parameters,
                         const PlatenTest& test, double strength, int seeds, double tolerance);

}  // namespace vug
