#pragma once
// A loading test instead of a coupled run.
#include "dem/parameters.hpp"
#include "dem/support.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace vug {

enum class LaboratoryTest { compression, tension, brazilian, heating, quench };
/// A loading test on bonded rock alone, without a lattice.
struct LaboratorySection {
  LaboratoryTest test = LaboratoryTest::compression;
  std::array<double, 2> size{0, 0};    ///< of the block, m
  double diameter = 0;                 ///< of the disc, m
  double flat_width = 0.174;           ///< of the disc's flats under the platens, over the diameter (20 degrees of arc)
  std::optional<double> platen_speed;  ///< m/s; absent: see usual_platen_speed()
  double confinement = 0;              ///< Pa
  Support flanks = Support::free;      ///< free: the confinement is a membrane's dead load; servo: that of platens
  double chemical_damage = 0;          ///< d_c of all bonds
  double temperature_change = 0;       ///< K: rise at the end of heating, or fall of the quenched face
  double duration = 1e-3;  ///< s; duration of heating, or time in which the cold advances by the diffusion length
  double diffusion_length = 0.01;  ///< 2 sqrt(kappa t) at the end of a quench, m
  /// Of the quenched face: heat transfer coefficient x height / conductivity.
  double biot = std::numeric_limits<double>::infinity();
  double largest_strain = 0.02;         ///< at which a loading test ends at the latest
  std::optional<double> sample_strain;  ///< between two points of the curve; absent: see sample_strain()
  int samples = 200;                    ///< number of temperatures of a quench
  bool energies = false;                ///< account for where the work of the platens goes
};

/// Strength of bonds that a test overcomes first, Pa.
inline double tested_strength(LaboratoryTest test, const BondParameters& bond) {
  const bool pulled = test == LaboratoryTest::tension || test == LaboratoryTest::brazilian;
  return pulled ? bond.normal_strength : bond.cohesion;
}

/// Smallest value of `of(bond, density)` over the materials of the rock.
template <class Of>
double least_of_materials(const MechanicsParameters& rock, const Of& of) {
  double least = of(rock.bond, rock.density);
  for (const RockMaterial& material : rock.materials) least = std::min(least, of(material.bond, material.density));
  return least;
}

/// Default speed of the moving platen, m/s: 0.5 in compression, 0.1 in tension and splitting, and at most 1/14
/// or 1/19 of strength/sqrt(M_n density), the speed of rock behind a wave that breaks it: so slow that strengths are
/// within 4 % of those at a quarter of it.
inline double usual_platen_speed(LaboratoryTest test, const MechanicsParameters& rock) {
  const auto [usual, slower] = test == LaboratoryTest::compression ? std::pair{0.5, 14.0} : std::pair{0.1, 19.0};
  const double behind_wave = least_of_materials(rock, [&](const BondParameters& bond, double density) {
    return tested_strength(test, bond) / std::sqrt(bond.normal_modulus * density);
  });
  return std::clamp(behind_wave / slower, 1e-3 * usual, usual);
}

/// Speed of the moving platen, m/s.
inline double platen_speed(const LaboratorySection& laboratory, const MechanicsParameters& rock) {
  return laboratory.platen_speed.value_or(usual_platen_speed(laboratory.test, rock));
}

/// Strain between two points of the curve, one of which is its peak. The default is 1e-5, and at most a sixtieth of
/// strength/M_n, about the strain at which the rock breaks.
inline double sample_strain(const LaboratorySection& laboratory, const MechanicsParameters& rock) {
  const double breaking = least_of_materials(rock, [&](const BondParameters& bond, double) {
    return tested_strength(laboratory.test, bond) / bond.normal_modulus;
  });
  return laboratory.sample_strain.value_or(std::min(laboratory.largest_strain, std::clamp(breaking / 60, 1e-8, 1e-5)));
}

}  // namespace vug
