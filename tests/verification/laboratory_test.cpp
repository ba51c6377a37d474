// Laboratory tests on generated specimens against closed forms and the paper's section 3.5.2.
#include "dem/laboratory.hpp"

#include "dem/mean_stress.hpp"
#include "dem/paper_reading.hpp"
#include "dem_support.hpp"
#include "io/rock_generator.hpp"
#include "support/record.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace {

using namespace vug;
using vug::test::host_copy;
using vug::test::record;

constexpr double printed_modulus = 27.8e9, printed_strength = 91.1e6;  // paper section 3.5.2
constexpr double calibrated_cohesion = 60e6;

RockSection elements(double size, std::uint64_t seed = 1) {
  RockSection rock;
  rock.element_size = size;
  rock.seed = seed;
  return rock;
}

/// The paper's specimen, 10 cm x 5 cm.
Assembly specimen(double size, std::uint64_t seed = 1) {
  return generate_rock(0.05, 0.1, elements(size, seed));
}

MechanicsParameters rock_of(double cohesion, std::uint64_t seed = 1) {
  MechanicsParameters p;
  p.bond.cohesion = cohesion;
  p.bond.seed = seed;
  return p;
}

MechanicsParameters unbreakable() {
  MechanicsParameters p;
  p.bond.normal_strength = p.bond.cohesion = 1e15;
  return p;
}

void record_curve(const char* name, double parameter, const PlatenResult& r) {
  for (std::size_t i = 0; i < r.strain.size(); i += std::max<std::size_t>(1, r.strain.size() / 150))
    record(name, {{"parameter", parameter}, {"strain", r.strain[i]}, {"stress", r.stress[i]}});
}

void record_cracks(const char* name, const Assembly& assembly, const Bonds& bonds) {
  const auto state = host_copy(bonds.state);
  const auto vertex = host_copy(bonds.vertex);
  for (int k = 0; k < bonds.count; ++k) {
    if (!has_failed(state(k))) continue;
    const auto &p = assembly.vertices[vertex(k, 0)], &q = assembly.vertices[vertex(k, 1)];
    record(name, {{"x0", p[0]},
                  {"y0", p[1]},
                  {"x1", q[0]},
                  {"y1", q[1]},
                  {"shear", static_cast<int>(state(k) == BondState::failed_in_shear)}});
  }
}

/// Particles whose centroids lie within `radius` of a point.
std::vector<int> around(const Particles& p, double x, double y, double radius) {
  const auto x0 = host_copy(p.x0);
  std::vector<int> inside;
  for (int i = 0; i < p.count; ++i)
    if (std::hypot(x0(i, 0) - x, x0(i, 1) - y) < radius) inside.push_back(i);
  return inside;
}

// ---------------------------------------------------------------- Brazilian disc

constexpr double diameter = 0.05, flat_width = 0.174;  // flats of 20 degrees of arc

TEST(BrazilianDisc, HasTheElasticStressOfTheClosedFormAtItsCentre) {
  // Point loads: 2 P / (pi D) across, -6 P / (pi D) along the load. Loads spread evenly over an arc of 2 alpha (Hondros
  // 1959): across 2 P / (pi D) (sin 2 alpha / alpha - 1): 0.990 of it for the narrow flats of alpha = 5 degrees
  constexpr double narrow = 0.0872;
  const Assembly disc = generate_disc(diameter, narrow, elements(1.25e-3));
  PlatenTest test;
  test.specimen = Specimen::disc;
  test.speed = 0.1;
  test.largest_strain = 4e-4;
  MechanicsParameters parameters = unbreakable();
  parameters.local_damping = 0.1;
  Stress centre;
  load_between_platens(Exec(), disc, parameters, test, [&](const Mechanics& rock, const PlatenResult& r, bool last) {
    if (!last) return;
    const double y = 0.5 * diameter * std::sqrt(1 - narrow * narrow);
    centre = mean_stress(rock.particles(), rock.bonds(), around(rock.particles(), 0.5 * diameter, y, 0.08 * diameter));
    centre = {centre.xx / r.stress.back(), centre.xy / r.stress.back(), centre.yy / r.stress.back()};
  });
  record("brazilian_centre", {{"across", centre.xx}, {"along", centre.yy}, {"shear", centre.xy}});
  EXPECT_NEAR(centre.xx, 1, 0.05);
  EXPECT_NEAR(centre.yy, -3, 0.05 * 3);
  EXPECT_NEAR(centre.xy, 0, 0.05);
}

TEST(BrazilianDisc, BreaksFirstAlongTheLoadedDiameterAndSplits) {
  const Assembly disc = generate_disc(diameter, flat_width, elements(1.5e-3));
  PlatenTest test;
  test.specimen = Specimen::disc;
  test.speed = 0.1;
  const double y = 0.5 * diameter * std::sqrt(1 - flat_width * flat_width);
  double first_x = 0, first_y = 0, first_count = 0, first_strain = 0;
  const PlatenResult r = load_between_platens(
      Exec(), disc, rock_of(95e6), test, [&](const Mechanics& rock, const PlatenResult& so_far, bool last) {
        if (last) record_cracks("brazilian_cracks", disc, rock.bonds());
        if (first_count >= 10) return;  // the first crack: ten failed bonds
        const auto state = host_copy(rock.bonds().state);
        const auto pair = host_copy(rock.bonds().pair);
        const auto x0 = host_copy(rock.particles().x0);
        first_x = first_y = first_count = 0;
        for (int k = 0; k < rock.bonds().count; ++k) {
          if (!has_failed(state(k))) continue;
          first_x += std::abs(0.5 * (x0(pair(k, 0), 0) + x0(pair(k, 1), 0)) - 0.5 * diameter);
          first_y += std::abs(0.5 * (x0(pair(k, 0), 1) + x0(pair(k, 1), 1)) - y);
          first_count += 1;
        }
        first_strain = so_far.strain.back();
      });
  record_curve("brazilian_curve", 95e6, r);
  record("brazilian_strength", {{"strength", r.strength},
                                {"first_off_axis", first_x / first_count / (0.5 * diameter)},
                                {"first_off_centre", first_y / first_count / (0.5 * diameter)},
                                {"first_strain", first_strain},
                                {"peak_strain", r.peak_strain}});
  EXPECT_GT(r.bonds_at_end.failed_in_tension, 5 * r.bonds_at_end.failed_in_shear);
  // failures at random over the disc would lie 0.42 of the radius off the axis in the mean
  EXPECT_LT(first_x / first_count, 0.2 * 0.5 * diameter);
  EXPECT_LT(first_y / first_count, 0.6 * 0.5 * diameter);
  EXPECT_GT(r.strength, 5e6);
  EXPECT_LT(r.strength, 15e6);  // mean strength of the bonds
}

// ---------------------------------------------------------------- confinement and heat

TEST(ConfinedCompression, FollowsHookesLawInPlaneStress) {
  // sigma_1 = E epsilon_1 + nu sigma_3 between platens that stood still while the flanks were loaded
  const double confinement = 10e6;
  const Assembly block = generate_rock(0.03, 0.06, elements(2e-3));
  PlatenTest test;
  test.largest_strain = 1e-3;
  test.speed = 0.25;
  const PlatenResult free = load_between_platens(Exec(), block, unbreakable(), test);
  test.confinement = confinement;
  const PlatenResult confined = load_between_platens(Exec(), block, unbreakable(), test);
  for (std::size_t i = 0; i < confined.strain.size(); i += 10)
    record("confined_elastic", {{"strain", confined.strain[i]},
                                {"stress", confined.stress[i]},
                                {"free", free.stress[i]},
                                {"poisson", free.poisson},
                                {"confinement", confinement}});
  EXPECT_NEAR(confined.modulus, free.modulus, 0.01 * free.modulus);
  const std::size_t half = confined.strain.size() / 2;
  const double more = confined.stress[half] - free.stress[half];
  EXPECT_NEAR(more, free.poisson * confinement, 0.05 * free.poisson * confinement);
}

TEST(RestrainedHeating, GivesTheStressOfItsModulus) {
  // free flanks: sigma = E alpha dT
  const Assembly block = generate_rock(0.03, 0.06, elements(2e-3));
  PlatenTest test;
  test.speed = 0;
  test.heating_rate = 100 / 1e-3;
  test.largest_strain = 8e-6 * 50;
  MechanicsParameters parameters = unbreakable();
  parameters.local_damping = 0.1;
  const PlatenResult heated = load_between_platens(Exec(), block, parameters, test);
  // both from 20 to 90 % of the curve; the modulus by the platens, as in the heating
  test.heating_rate = 0;
  test.speed = 0.25;
  const PlatenResult pressed = load_between_platens(Exec(), block, parameters, test);
  const auto slope = [](const PlatenResult& r) {
    const std::size_t a = r.strain.size() / 5, b = 9 * r.strain.size() / 10;
    return (r.stress[b] - r.stress[a]) / (r.strain[b] - r.strain[a]);
  };
  record_curve("restrained_heating", 0, heated);
  record("restrained_heating_slope", {{"heated", slope(heated)}, {"pressed", slope(pressed)}});
  EXPECT_NEAR(slope(heated), slope(pressed), 0.02 * slope(pressed));
}

// ---------------------------------------------------------------- paper section 3.5.2

struct Sample {
  double mean = 0, deviation = 0, smallest = 1e300, largest = 0;
};

Sample sample_of(const std::vector<double>& values) {
  Sample s;
  const auto n = static_cast<double>(values.size());
  for (const double v : values) {
    s.mean += v / n;
    s.smallest = std::min(s.smallest, v), s.largest = std::max(s.largest, v);
  }
  for (const double v : values) s.deviation += std::pow(v - s.mean, 2) / (n - 1);
  s.deviation = std::sqrt(s.deviation);
  return s;
}

/// Five specimens of other elements and other bonds; `number` orders the profiles in the records.
void compress_five(int number, const char* profile, MechanicsParameters parameters, double size, Sample& modulus,
                   Sample& strength) {
  std::vector<double> moduli, strengths;
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const Assembly block = specimen(size, seed);
    const bool shown = seed == 1 && size == 2e-3;
    parameters.bond.seed = seed;
    const PlatenResult r =
        load_between_platens(Exec(), block, parameters, {}, [&](const Mechanics& rock, const PlatenResult&, bool last) {
          if (last && shown) record_cracks((std::string("compression_cracks_") + profile).c_str(), block, rock.bonds());
        });
    if (shown) record_curve("compression_profiles", number, r);
    moduli.push_back(r.modulus), strengths.push_back(r.strength);
    record("compression_specimens", {{"profile", std::string(profile)},
                                     {"element", size},
                                     {"seed", static_cast<int>(seed)},
                                     {"modulus", r.modulus},
                                     {"poisson", r.poisson},
                                     {"strength", r.strength},
                                     {"peak_strain", r.peak_strain},
                                     {"tension", r.bonds_at_end.failed_in_tension},
                                     {"shear", r.bonds_at_end.failed_in_shear}});
  }
  modulus = sample_of(moduli), strength = sample_of(strengths);
}

TEST(PaperCompressionLong, TableOneGivesThePrintedModulusAndAboveThePrintedStrength) {
  for (const double size : {2e-3, 3e-3}) {
    Sample modulus, strength;
    compress_five(0, "paper-literal", {}, size, modulus, strength);
    EXPECT_NEAR(modulus.mean, printed_modulus, 0.03 * printed_modulus);
    // what Table 1 gives, measured on two other kinds of mesh: 123 to 146 MPa; the printed 91.1 MPa it does not give
    EXPECT_GT(strength.mean, 120e6);
    EXPECT_LT(strength.mean, 150e6);
  }
}

TEST(PaperCompressionLong, CalibratedCohesionGivesThePrintedModulusAndStrength) {
  for (const double size : {2e-3, 3e-3}) {
    Sample modulus, strength;
    compress_five(1, "calibrated", rock_of(calibrated_cohesion), size, modulus, strength);
    EXPECT_NEAR(modulus.mean, printed_modulus, 0.03 * printed_modulus);
    // fitted with elements of 2 mm; larger ones scatter more and lie higher
    EXPECT_NEAR(strength.mean, printed_strength, (size == 2e-3 ? 0.03 : 0.10) * printed_strength);
  }
}

TEST(PaperCompressionLong, TableOneAsWeibullScalesWithoutFrictionGivesThePrintedStrengthUnfitted) {
  for (const double size : {2e-3, 3e-3}) {
    Sample modulus, strength;
    compress_five(2, "weibull-scale", weibull_scale_reading({}), size, modulus, strength);
    EXPECT_NEAR(modulus.mean, printed_modulus, 0.03 * printed_modulus);
    // the mean of five specimens that scatter by 5 MPa is known to 2.2 MPa
    EXPECT_NEAR(strength.mean, printed_strength, 0.06 * printed_strength);
  }
}

TEST(PaperCompressionLong, SoakingLowersTheModulusByTheDissolvedShare) {
  const Assembly block = specimen(2e-3);
  double modulus = 0;
  for (const double d_c : {0.0, 0.05, 0.1, 0.15, 0.2, 0.25, 0.3, 0.35}) {
    PlatenTest soaked;
    soaked.chemical_damage = d_c;
    const PlatenResult r = load_between_platens(Exec(), block, rock_of(calibrated_cohesion), soaked);
    if (d_c == 0) modulus = r.modulus;
    record_curve("soaking_curves", d_c, r);
    record("soaking", {{"d_c", d_c}, {"modulus", r.modulus}, {"strength", r.strength}, {"strain", r.peak_strain}});
    EXPECT_NEAR(r.modulus, (1 - d_c) * modulus, 0.005 * modulus);
  }
}

TEST(PaperCompressionLong, StrengthHardlyDependsOnThePlatensSpeed) {
  const Assembly block = specimen(3e-3);
  std::vector<double> strength;
  for (const double speed : {0.125, 0.25, 0.5, 1.0}) {
    PlatenTest test;
    test.speed = speed;
    const PlatenResult r = load_between_platens(Exec(), block, rock_of(calibrated_cohesion), test);
    strength.push_back(r.strength);
    record("platen_speed", {{"speed", speed}, {"modulus", r.modulus}, {"strength", r.strength}});
  }
  // inertia of the breaking bonds: at 0.5 m/s less than the scatter of a specimen (5.5 %), and falling with the speed
  EXPECT_NEAR(strength[2], strength[0], 0.05 * strength[0]);
  EXPECT_NEAR(strength[1], strength[0], 0.025 * strength[0]);
}

TEST(PaperCompressionLong, TensileStrengthsStandBesideTheCompressiveOne) {
  for (const double cohesion : {95e6, calibrated_cohesion}) {
    std::vector<double> direct, splitting;
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
      PlatenTest pull;
      pull.speed = -0.1;
      direct.push_back(load_between_platens(Exec(), specimen(3e-3, seed), rock_of(cohesion, seed), pull).strength);
      PlatenTest split;
      split.specimen = Specimen::disc;
      split.speed = 0.1;
      const Assembly disc = generate_disc(diameter, flat_width, elements(2e-3, seed));
      splitting.push_back(load_between_platens(Exec(), disc, rock_of(cohesion, seed), split).strength);
    }
    const Sample t = sample_of(direct), b = sample_of(splitting);
    record("tensile_strengths", {{"cohesion", cohesion},
                                 {"direct", t.mean},
                                 {"direct_deviation", t.deviation},
                                 {"brazilian", b.mean},
                                 {"brazilian_deviation", b.deviation}});
    EXPECT_NEAR(t.mean, 10.5e6, 0.1 * 10.5e6);  // 0.70 of the bonds' mean strength of 15 MPa
    EXPECT_GT(b.mean, 0.7 * t.mean);
    EXPECT_LT(b.mean, 1.5 * t.mean);
  }
}

TEST(PaperCompressionLong, ConfinementStrengthensTheRock) {
  const Assembly block = specimen(3e-3);
  double last = 0;
  for (const double confinement : {0.0, 5e6, 10e6, 20e6}) {
    PlatenTest test;
    test.confinement = confinement;
    const PlatenResult r = load_between_platens(Exec(), block, rock_of(calibrated_cohesion), test);
    record("triaxial", {{"confinement", confinement},
                        {"strength", r.strength},
                        {"modulus", r.modulus},
                        {"tension", r.bonds_at_end.failed_in_tension},
                        {"shear", r.bonds_at_end.failed_in_shear}});
    record_curve("triaxial_curves", confinement, r);
    EXPECT_GT(r.strength, last + (confinement > 0 ? 5e6 : 0));  // more than the confinement itself
    last = r.strength;
  }
}

}  // namespace
