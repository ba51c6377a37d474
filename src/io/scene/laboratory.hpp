#pragma once
// A loading test instead of a coupled run.
#include "dem/support.hpp"

#include <array>
#include <limits>
#include <optional>

namespace vug {

enum class LaboratoryTest { compression, tension, brazilian, heating, quench };
/// A loading test on bonded rock alone, without a lattice.
struct LaboratorySection {
  LaboratoryTest test = LaboratoryTest::compression;
  std::array<double, 2> size{0, 0};    ///< of the block, m
  double diameter = 0;                 ///< of the disc, m
  double flat_width = 0.174;           ///< of the disc's flats under the platens, over the diameter (20 degrees of arc)
  std::optional<double> platen_speed;  ///< m/s; absent: 0.5 in compression, 0.1 in tension and splitting
  double confinement = 0;              ///< Pa
  Support flanks = Support::free;      ///< free: the confinement is a membrane's dead load; servo: that of platens
  double chemical_damage = 0;          ///< d_c of all bonds
  double temperature_change = 0;       ///< K: rise at the end of heating, or fall of the quenched face
  double duration = 1e-3;  ///< s; duration of heating, or time in which the cold advances by the diffusion length
  double diffusion_length = 0.01;  ///< 2 sqrt(kappa t) at the end of a quench, m
  /// Of the quenched face: heat transfer coefficient x height / conductivity.
  double biot = std::numeric_limits<double>::infinity();
  double largest_strain = 0.02;  ///< at which a loading test ends at the latest
  double sample_strain = 1e-5;   ///< between two points of the curve
  int samples = 200;             ///< number of temperatures of a quench
  bool energies = false;         ///< account for where the work of the platens goes
};

/// Speed of the moving platen, m/s. The default is so slow that strengths are within 4 % of those at a quarter of it.
inline double platen_speed(const LaboratorySection& laboratory) {
  return laboratory.platen_speed.value_or(laboratory.test == LaboratoryTest::compression ? 0.5 : 0.1);
}

}  // namespace vug
