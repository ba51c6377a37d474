// Elasticity of bonded rock: E and nu against the bonds that should give them, and layers against laminate theory.
#include "dem/elasticity.hpp"

#include "support/mean_strain.hpp"
#include "support/specimens.hpp"

#include <gtest/gtest.h>

namespace {

using namespace vug;
using namespace vug::test;

/// A block on rollers at the left and the bottom, at rest under a stress on its right or its top.
Mechanics pressed(const Assembly& block, const MechanicsParameters& parameters, RockSide side, double stress) {
  Loads loads;
  loads.support[static_cast<std::size_t>(RockSide::left)] = Support::roller;
  loads.support[static_cast<std::size_t>(RockSide::bottom)] = Support::roller;
  loads.traction[static_cast<std::size_t>(side)] =
      side == RockSide::right ? std::array{stress, 0.0} : std::array{0.0, stress};
  Mechanics rock(block, parameters, loads);
  EXPECT_TRUE(rock.preload_statically(Exec()));
  return rock;
}

TEST(Elasticity, OfGeneratedRockIsThatGiven) {
  const Assembly block = generate_rock(0.06, 0.06, elements(1.5e-3));
  for (const double nu : {0.0, 0.1, 0.2, 0.238, 0.3, 0.4}) {
    MechanicsParameters parameters = unbreakable();
    const Elasticity given{40e9, nu};
    parameters.bond = with_elasticity(parameters.bond, given);
    EXPECT_NEAR(elasticity_of(parameters.bond).poisson_ratio, nu, 1e-12);
    EXPECT_NEAR(elasticity_of(parameters.bond).young_modulus, 40e9, 1);
    const Mechanics rock = pressed(block, parameters, RockSide::top, 1e6);
    const double young = 1e6 / mean_strain(rock, 1), poisson = -mean_strain(rock, 0) / mean_strain(rock, 1);
    record("elasticity", {{"nu", nu}, {"young", young / 40e9}, {"poisson", poisson}});
    std::printf("    nu %.3f: E %.4f of that given, nu %.4f\n", nu, young / 40e9, poisson);
    EXPECT_NEAR(young, 40e9, 0.02 * 40e9);
    EXPECT_NEAR(poisson, nu, 0.015);
  }
}

}  // namespace
