#pragma once
// Thermal shock: a hot slab whose upper face is suddenly cold (water quench), and the cracks that grow down from it.
#include "dem/laboratory.hpp"
#include "dem/slab_cooling.hpp"

#include <string>
#include <vector>

namespace vug {

/// A test of the upper half of a slab: its bottom is the mid-plane (a roller, no heat flux), its flanks are free, and
/// the temperature outside its upper face falls by `drop` at time zero. Heat diffuses over seconds, but stress
/// equilibrates in microseconds: the cracks depend on the diffusion length alone. Time therefore runs faster here, and
/// local damping removes the oscillations that remain.
struct QuenchTest {
  double drop = 100;                                      ///< K
  double biot = std::numeric_limits<double>::infinity();  ///< heat transfer coefficient x height / conductivity
  double final_length =
      10e-3;  ///< diffusion length 2 sqrt(kappa t) at the end, m; at three times its height the slab is cold
  double duration = 1e-3;      ///< mechanical time in which it is reached, s; long against height / sound speed
  double step_fraction = 0.3;  ///< time step over the critical one
  double local_damping = 0.3;  ///< Cundall's
  int samples = 200;           ///< number of times at which temperatures are set
  double chemical_damage = 0;  ///< d_c of all bonds
};

/// Cracks after a quench.
struct QuenchResult {
  std::vector<double> depth;   ///< below the surface, m
  std::vector<double> cracks;  ///< (depth) number of cracks that cross the level
  double spacing = 0;          ///< width over the number of cracks at the first level, two elements deep, m
  double mean_depth = 0;       ///< of the cracks that cross the first level, m
  double deepest = 0;          ///< deepest level that a crack crosses, m
  BondCounts bonds_at_end;
  double time_step = 0;  ///< s
  long steps = 0;
};

/// Throws InputError, which begins with `where`, for a slab that is not higher than two edges of its triangles, because
/// cracks are counted from that depth on.
void require_depth_for_cracks(const Assembly& slab, const std::string& where);

/// Number of its steps. Throws InputError, which begins with `where`, for fewer than it has temperatures.
long steps_of_quench(const QuenchTest& test, double time_step, const std::string& where);

/// Called after every new temperature with the rock, the diffusion length and whether it is the last time.
using QuenchWatch = std::function<void(const Mechanics&, double length, bool last)>;

/// Quenches the upper face of a block. Throws StabilityError when the motion is no longer finite, and InputError for a
/// slab that is too low or a test of too many steps.
QuenchResult quench(const Exec& exec, const Assembly& slab, MechanicsParameters parameters, const QuenchTest& test,
                    const QuenchWatch& watch = {});

}  // namespace vug
