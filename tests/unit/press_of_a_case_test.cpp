// How a case loads its specimen: the platens' speed, confinement and sampling, and the temperatures of a quench.
#include "coupling/specimen.hpp"
#include "unit/laboratory_case.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

namespace vug {
namespace {

using test::laboratory;
using test::platens_of;

TEST(PlatenTestOfACase, PressesPullsAndSplits) {
  EXPECT_EQ(platens_of(laboratory("compression", {"laboratory.platen_speed=0.3"})).speed, 0.3);
  EXPECT_EQ(platens_of(laboratory("tension", {"laboratory.platen_speed=0.3"})).speed, -0.3);
}

/// Stiff rock that is weak: where a wave of its strength moves it slower than 14 (19) times the usual speed.
TEST(PlatenTestOfACase, IsSlowAndFineForWeakRock) {
  const std::vector<std::string> weak{"mechanics.bond.cohesion=10e6", "mechanics.bond.normal_strength=2e6"};
  EXPECT_EQ(platens_of(laboratory("compression")).speed, 0.5);
  EXPECT_EQ(platens_of(laboratory("tension")).speed, -0.1);
  EXPECT_EQ(platens_of(laboratory("tension")).sample_strain, 1e-5);
  const Scene pressed = laboratory("compression", weak), pulled = laboratory("tension", weak);
  const double modulus = pressed.mechanics->parameters.bond.normal_modulus, impedance = std::sqrt(modulus * 2500);
  EXPECT_DOUBLE_EQ(platens_of(pressed).speed, 10e6 / impedance / 14);
  EXPECT_DOUBLE_EQ(platens_of(pressed).sample_strain, 10e6 / modulus / 60);
  EXPECT_DOUBLE_EQ(platens_of(pulled).speed, -2e6 / impedance / 19);
  EXPECT_DOUBLE_EQ(platens_of(pulled).sample_strain, 2e6 / modulus / 60);
}

TEST(PlatenTestOfACase, PullsWeakRockAsStrongAsMoreSlowly) {
  const std::vector<std::string> weak{"mechanics.bond.cohesion=10e6", "mechanics.bond.normal_strength=2e6",
                                      "mechanics.bond.fracture_energy_I=0.36", "mechanics.bond.fracture_energy_II=0.7",
                                      "laboratory.largest_strain=1e-3"};
  for (const char* test : {"compression", "tension"}) {
    const Scene scene = laboratory(test, weak);
    const Assembly specimen = build_specimen(scene);
    const PlatenTest usual = platen_test(scene, specimen);
    const auto mean_strength = [&](double speed) {
      PlatenTest pressed = usual;
      pressed.speed = speed;
      MechanicsParameters rock = scene.mechanics->parameters;
      double sum = 0;
      for (rock.bond.seed = 1; rock.bond.seed <= 8; ++rock.bond.seed)
        sum += load_between_platens(Exec(), specimen, rock, pressed).strength;
      return sum / 8;
    };
    EXPECT_NEAR(mean_strength(usual.speed) / mean_strength(usual.speed / 4), 1, 0.04) << test;
  }
}

TEST(PlatenTestOfACase, SoaksAndConfinesAsItSays) {
  const PlatenTest plain = platens_of(laboratory("compression"));
  EXPECT_EQ(plain.confinement, 0);
  EXPECT_EQ(plain.chemical_damage, 0);
  EXPECT_EQ(plain.flanks, Support::free);
  const std::vector<std::string> held{"laboratory.confinement=10 MPa", "laboratory.chemical_damage=0.3",
                                      "mechanics.preload_time=2e-4", "mechanics.preload_damping=0.6"};
  const PlatenTest membrane = platens_of(laboratory("compression", held));
  EXPECT_EQ(membrane.confinement, 10e6);
  EXPECT_EQ(membrane.chemical_damage, 0.3);
  EXPECT_EQ(membrane.flanks, Support::free);
  EXPECT_EQ(membrane.confining_time, 2e-4);
  EXPECT_EQ(membrane.confining_damping, 0.6);
  const auto servo = platens_of(laboratory("compression", {held[0], "laboratory.confinement_by=servo"}));
  EXPECT_EQ(servo.flanks, Support::servo);
}

TEST(PlatenTestOfACase, WarmsByItsChangeInItsDuration) {
  const PlatenTest test =
      platens_of(laboratory("heating", {"laboratory.temperature_change=50", "laboratory.duration=2e-3"}));
  EXPECT_EQ(test.speed, 0);
  EXPECT_DOUBLE_EQ(test.heating_rate, 25e3);      // 50 K in 2 ms
  EXPECT_DOUBLE_EQ(test.largest_strain, 400e-6);  // alpha dT
}

TEST(QuenchTestOfACase, IsThatOfItsKeys) {
  const QuenchTest test = quench_test(
      laboratory("quench", {"laboratory.temperature_change=50", "laboratory.duration=2e-3", "laboratory.biot=3",
                            "laboratory.diffusion_length=4e-3", "laboratory.samples=70",
                            "laboratory.chemical_damage=0.3", "mechanics.critical_fraction=0.2"}));
  EXPECT_EQ(test.drop, 50);
  EXPECT_EQ(test.duration, 2e-3);
  EXPECT_EQ(test.biot, 3);
  EXPECT_EQ(test.final_length, 4e-3);
  EXPECT_EQ(test.samples, 70);
  EXPECT_EQ(test.chemical_damage, 0.3);
  EXPECT_EQ(test.step_fraction, 0.2);
}

}  // namespace
}  // namespace vug
