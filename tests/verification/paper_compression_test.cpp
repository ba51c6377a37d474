// The paper's uniaxial compression (section 3.5.2): modulus, strength, soaking, speed and confinement.
#include "dem/paper_reading.hpp"
#include "support/specimens.hpp"

#include <gtest/gtest.h>

#include <string>
#include <utility>

namespace {

using namespace vug;
using namespace vug::test;

constexpr double printed_modulus = 27.8e9, printed_strength = 91.1e6;  // paper section 3.5.2

/// Five specimens of other elements and other bonds; `number` orders the profiles in the records.
void compress_five(int number, const char* profile, MechanicsParameters parameters, double size, Spread& modulus,
                   Spread& strength) {
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
  modulus = spread_of(moduli), strength = spread_of(strengths);
}

TEST(PaperCompressionLong, TableOneGivesThePrintedModulusAndAboveThePrintedStrength) {
  for (const double size : {2e-3, 3e-3}) {
    Spread modulus, strength;
    compress_five(0, "paper-literal", table_one(), size, modulus, strength);
    EXPECT_NEAR(modulus.mean, printed_modulus, 0.03 * printed_modulus);
    // what Table 1 gives, measured on two other kinds of mesh: 123 to 146 MPa; the printed 91.1 MPa it does not give
    EXPECT_GT(strength.mean, 120e6);
    EXPECT_LT(strength.mean, 150e6);
  }
}

TEST(PaperCompressionLong, CalibratedCohesionGivesThePrintedModulusAndStrength) {
  for (const double size : {2e-3, 3e-3}) {
    Spread modulus, strength;
    compress_five(1, "calibrated", rock_of(calibrated_cohesion), size, modulus, strength);
    EXPECT_NEAR(modulus.mean, printed_modulus, 0.03 * printed_modulus);
    EXPECT_NEAR(strength.mean, printed_strength, 0.03 * printed_strength);
  }
}

TEST(PaperCompressionLong, TableOneAsWeibullScalesWithoutFrictionGivesThePrintedStrengthUnfitted) {
  for (const double size : {2e-3, 3e-3}) {
    Spread modulus, strength;
    compress_five(2, "weibull-scale", weibull_scale_reading(table_one()), size, modulus, strength);
    EXPECT_NEAR(modulus.mean, printed_modulus, 0.03 * printed_modulus);
    // the mean of five specimens that scatter by 5 MPa is known to 2.2 MPa
    EXPECT_NEAR(strength.mean, printed_strength, 0.06 * printed_strength);
  }
}

TEST(PaperCompressionLong, SoakingLowersTheModulusByTheDissolvedShare) {
  const Assembly block = specimen(2e-3);
  for (const auto& [profile, cohesion] : {std::pair{"paper-literal", 95e6}, {"calibrated", calibrated_cohesion}}) {
    double modulus = 0;
    for (const double d_c : {0.0, 0.05, 0.1, 0.15, 0.2, 0.25, 0.3, 0.35}) {
      PlatenTest soaked;
      soaked.chemical_damage = d_c;
      const PlatenResult r = load_between_platens(Exec(), block, rock_of(cohesion), soaked);
      if (d_c == 0) modulus = r.modulus;
      record_curve((std::string("soaking_curves_") + profile).c_str(), d_c, r);
      record("soaking", {{"profile", std::string(profile)},
                         {"d_c", d_c},
                         {"modulus", r.modulus},
                         {"strength", r.strength},
                         {"strain", r.peak_strain}});
      EXPECT_NEAR(r.modulus, (1 - d_c) * modulus, 0.005 * modulus) << profile;
    }
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

TEST(ServoConfinementLong, BreaksTheRockAtTheStrengthThatAMembraneDoes) {
  std::vector<double> ratios;
  for (const double confinement : {5e6, 10e6, 20e6}) {
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
      const Assembly block = specimen(3e-3, seed);
      PlatenTest test;
      test.confinement = confinement;
      const PlatenResult membrane = load_between_platens(Exec(), block, rock_of(calibrated_cohesion, seed), test);
      test.flanks = Support::servo;
      const PlatenResult servo = load_between_platens(Exec(), block, rock_of(calibrated_cohesion, seed), test);
      double before = 0, after = 0;  // largest errors of the confinement
      for (std::size_t i = 0; i < servo.strain.size(); ++i) {
        double& worst = servo.strain[i] < 0.5 * servo.peak_strain ? before : after;
        worst = std::max(worst, std::abs(servo.confinement[i] - confinement));
      }
      ratios.push_back(servo.strength / membrane.strength);
      record("servo_strength", {{"confinement", confinement},
                                {"seed", static_cast<int>(seed)},
                                {"membrane", membrane.strength},
                                {"servo", servo.strength},
                                {"elastic_error", before},
                                {"failure_error", after}});
      if (seed == 1) {
        for (std::size_t i = 0; i < servo.strain.size(); i += std::max<std::size_t>(1, servo.strain.size() / 150))
          record("servo_curves", {{"parameter", confinement},
                                  {"strain", servo.strain[i]},
                                  {"stress", servo.stress[i]},
                                  {"confinement", servo.confinement[i]}});
      }
      EXPECT_LT(before, 0.12e6);  // v / G, 0.066 MPa, and the waves of the start
      EXPECT_LT(after, 10e6);     // what bursts out at 3 m/s pushes the platens with 8 MPa
      EXPECT_NEAR(ratios.back(), 1, 0.12) << confinement << ' ' << seed;  // twice a specimen's scatter
    }
  }
  EXPECT_NEAR(spread_of(ratios).mean, 1, 0.06);  // a platen holds flakes back that a membrane lets go
}

}  // namespace
