// Rock at the edge of what can be asked of it: the motion stays finite, or a StabilityError says that it does not.
#include "base/require.hpp"
#include "dem/laboratory.hpp"
#include "dem/soundness.hpp"
#include "dem_support.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <numeric>
#include <string>
#include <vector>

namespace {

using namespace vug;
using vug::test::host_copy;

Loads pressed(double speed) {
  Loads loads;
  loads.support[static_cast<std::size_t>(RockSide::bottom)] = Support::roller;
  loads.support[static_cast<std::size_t>(RockSide::top)] = Support::roller;
  loads.velocity[static_cast<std::size_t>(RockSide::top)] = {0, -speed};
  return loads;
}

TEST(Extremes, StiffnessesOfAnyRatioStayStableAtTheirOwnStep) {
  for (const double ratio : {1e-6, 1e-3, 1e3}) {
    MechanicsParameters parameters;
    parameters.bond.tangential_modulus = ratio * parameters.bond.normal_modulus;
    parameters.contact.normal_stiffness = ratio * 3.73e10;
    parameters.contact.tangential_stiffness = 3.73e10;
    parameters.bond.cohesion = 20e6;
    Mechanics rock(test::block(0.02, 0.02, 2e-3, 0.25), parameters, pressed(5));
    rock.advance(Exec(), 0.3 * rock.critical_step(), 5000);
    EXPECT_EQ(what_is_unsound(Exec(), rock), "") << ratio;
  }
}

TEST(Extremes, SliversSetTheStepAndNothingElse) {
  // the interior vertices of one row pushed down to a tenth of the row below: angles of a few degrees
  constexpr double size = 0.02, height = size / 12;
  Assembly slivers = test::block(size, size, 2e-3, 0);
  for (auto& [x, y] : slivers.vertices)
    if (std::abs(y - 6 * height) < 1e-9 && x > 1e-9 && x < size - 1e-9) y -= 0.9 * height;
  MechanicsParameters parameters;
  parameters.bond.cohesion = 20e6;
  Mechanics rock(slivers, parameters, pressed(2));
  const Mechanics plain(test::block(0.02, 0.02, 2e-3, 0), parameters, pressed(2));
  EXPECT_LT(rock.critical_step(), 0.7 * plain.critical_step());
  rock.advance(Exec(), 0.3 * rock.critical_step(), 5000);
  EXPECT_EQ(what_is_unsound(Exec(), rock), "");
}

TEST(Extremes, WithoutAnyDampingEnergyIsKept) {
  MechanicsParameters parameters;
  parameters.bond.normal_strength = parameters.bond.cohesion = 1e15;
  parameters.bond.damping = parameters.contact.normal_damping = 0;
  parameters.energy_ledger = true;
  Mechanics rock(test::block(0.01, 0.02, 2e-3, 0.25), parameters, pressed(1));
  const double dt = 0.3 * rock.critical_step();
  rock.advance(Exec(), dt, 20000);
  const Energies e = rock.energies(Exec());
  EXPECT_EQ(e.fracture, 0);
  // the leapfrog's own energy is kept but for the turning of frames within a step, 1e-9 of the work at this step
  EXPECT_LT(std::abs(e.damping), 1e-12 * e.work);
  EXPECT_LT(std::abs(e.imbalance()), 1e-7 * e.work);
}

TEST(Extremes, FullUnloadingLeavesElasticRockAtRest) {
  MechanicsParameters parameters;
  parameters.bond.normal_strength = parameters.bond.cohesion = 1e15;
  parameters.local_damping = 0.3;
  Mechanics rock(test::block(0.01, 0.02, 2e-3, 0.25), parameters, pressed(1));
  const double dt = 0.3 * rock.critical_step();
  rock.advance(Exec(), dt, 2000);
  rock.set_platen_velocity(RockSide::top, {0, 1});
  rock.advance(Exec(), dt, 2000);
  rock.set_platen_velocity(RockSide::top, {0, 0});
  const double loaded = parameters.bond.normal_modulus * 1e-6;
  rock.advance(Exec(), dt, 20000);
  const auto stress = host_copy(rock.bonds().stress);
  for (int k = 0; k < rock.bonds().count; ++k) EXPECT_LT(std::abs(stress(k, 0)), loaded);
  EXPECT_EQ(rock.bond_counts().damaged + rock.bond_counts().failed(), 0);
}

TEST(Extremes, AlmostDissolvedRockIsSoftAndDissolvedRockFallsApart) {
  MechanicsParameters parameters;
  Mechanics soft(test::block(0.01, 0.02, 2e-3, 0.25), parameters, pressed(2));
  Kokkos::deep_copy(soft.bonds().d_c, 0.949);
  soft.advance(Exec(), 0.3 * soft.critical_step(), 5000);
  EXPECT_EQ(what_is_unsound(Exec(), soft), "");
  EXPECT_EQ(soft.bond_counts().dissolved, 0);
  Mechanics gone(test::block(0.01, 0.02, 2e-3, 0.25), parameters, pressed(2));
  Kokkos::deep_copy(gone.bonds().d_c, 1.0);
  gone.advance(Exec(), 0.3 * gone.critical_step(), 5000);
  EXPECT_EQ(what_is_unsound(Exec(), gone), "");
  EXPECT_EQ(gone.bond_counts().dissolved, gone.bonds().count);
}

TEST(Extremes, BondsWithoutStrengthBreakAtTheFirstTension) {
  MechanicsParameters parameters;
  parameters.bond.normal_strength = parameters.bond.cohesion = 0;
  Mechanics rock(test::block(0.01, 0.02, 2e-3, 0.25), parameters, pressed(-1));
  rock.advance(Exec(), 0.3 * rock.critical_step(), 5000);
  EXPECT_EQ(what_is_unsound(Exec(), rock), "");
  EXPECT_GT(rock.bond_counts().failed(), 5);  // across the block's five elements: then it is in two pieces
}

TEST(Extremes, TenThousandBondsThatFailAtOnceReleaseWhatTheyHeld) {
  // squeezed by confining platens, then dissolved in one step: every bond fails, the faces still press
  MechanicsParameters parameters;
  parameters.bond.normal_strength = parameters.bond.cohesion = 1e15;
  Loads loads = pressed(1);
  loads.support[static_cast<std::size_t>(RockSide::left)] = Support::roller;
  loads.support[static_cast<std::size_t>(RockSide::right)] = Support::roller;
  Mechanics rock(test::block(0.1, 0.14, 2e-3, 0.2), parameters, loads);
  ASSERT_GT(rock.bonds().count, 10000);
  const double dt = 0.3 * rock.critical_step();
  rock.advance(Exec(), dt, 500);
  Kokkos::deep_copy(rock.bonds().d_c, 0.96);
  rock.advance(Exec(), dt, 500);
  EXPECT_EQ(rock.bond_counts().failed(), rock.bonds().count);
  EXPECT_EQ(what_is_unsound(Exec(), rock), "");
}

/// The bonds between the upper half of a block and its lower half fail; the triangles of the upper half.
std::vector<int> part_across(const Mechanics& rock, double height) {
  const auto x0 = host_copy(rock.particles().x0);
  const auto pair = host_copy(rock.bonds().pair);
  const auto state = host_copy(rock.bonds().state);
  const auto above = [&](int i) { return x0(i, 1) > height; };
  for (int k = 0; k < rock.bonds().count; ++k)
    if (above(pair(k, 0)) != above(pair(k, 1))) state(k) = BondState::failed_in_tension;
  Kokkos::deep_copy(rock.bonds().state, state);
  std::vector<int> upper;
  for (int i = 0; i < rock.particles().count; ++i)
    if (above(i)) upper.push_back(i);
  return upper;
}

TEST(Extremes, PiecesThatRunAwayAsOneAreNoMatterOfTheStep) {
  Loads loads;
  loads.support[static_cast<std::size_t>(RockSide::bottom)] = Support::fixed;
  Mechanics rock(test::block(0.01, 0.02, 2e-3, 0.25), {}, loads);
  const auto said = [&](bool in_fluid = false) { return what_is_unsound(Exec(), rock, in_fluid); };
  const auto has = [](const std::string& words) { return testing::HasSubstr(words); };
  const std::vector<int> upper = part_across(rock, 0.01);
  rock.set_velocity(upper, {0, 5000});
  const std::string piece = "of a piece of " + std::to_string(upper.size()) + " triangles that neither bonds nor";
  EXPECT_THAT(said(), testing::AllOf(has(piece), has("thrown it off"), testing::Not(has("sub-steps"))));
  EXPECT_THAT(said(true), testing::AllOf(has(piece), has("the fluid drives it")));
  // half of it against the other half: no load does that
  const std::vector<int> half(upper.begin(), upper.begin() + static_cast<long>(upper.size() / 2));
  rock.set_velocity(half, {0, -5000});
  EXPECT_THAT(said(), has("more sub-steps"));
  // what a support holds cannot fly off as a whole
  rock.set_velocity(upper, {0, 0});
  std::vector<int> lower;
  const auto held = host_copy(rock.particles().held);
  for (int i = 0; i < rock.particles().count; ++i)
    if (std::find(upper.begin(), upper.end(), i) == upper.end() && held(i) == 0) lower.push_back(i);
  rock.set_velocity(lower, {0, 5000});
  EXPECT_THAT(said(), has("more sub-steps"));
  Mechanics free(test::block(0.01, 0.02, 2e-3, 0.25), {}, {});
  std::vector<int> all(static_cast<std::size_t>(free.particles().count));
  std::iota(all.begin(), all.end(), 0);
  free.set_velocity(all, {4000, 0});
  EXPECT_THAT(what_is_unsound(Exec(), free), has("no support holds the rock"));
}

TEST(Extremes, MotionThatIsNotANumberOrRunsAwayStops) {
  Mechanics rock(test::block(0.01, 0.02, 2e-3, 0.25), {}, {});
  EXPECT_NO_THROW(require_sound(Exec(), rock));
  const auto v = host_copy(rock.particles().v);
  v(5, 1) = std::numeric_limits<double>::quiet_NaN();
  Kokkos::deep_copy(rock.particles().v, v);
  EXPECT_THROW(require_sound(Exec(), rock), StabilityError);
  EXPECT_NE(what_is_unsound(Exec(), rock).find("the motion of particle 5 is not a finite number"), std::string::npos);
  v(5, 1) = 1e5;
  Kokkos::deep_copy(rock.particles().v, v);
  EXPECT_THROW(require_sound(Exec(), rock), StabilityError);
  EXPECT_NE(what_is_unsound(Exec(), rock).find("more sub-steps"), std::string::npos);
  const auto says = [&](const char* words, bool in_fluid = false) {
    return what_is_unsound(Exec(), rock, in_fluid).find(words) != std::string::npos;
  };
  // a fragment that nothing holds is no matter of the step
  const auto pair = host_copy(rock.bonds().pair);
  const auto state = host_copy(rock.bonds().state);
  for (int k = 0; k < rock.bonds().count; ++k)
    if (pair(k, 0) == 5 || pair(k, 1) == 5) state(k) = BondState::dissolved;
  Kokkos::deep_copy(rock.bonds().state, state);
  EXPECT_TRUE(says("fragment"));
  EXPECT_FALSE(says("fluid"));
  EXPECT_TRUE(says("a fragment that no bond holds: the fluid drives it", true));
  const auto held = host_copy(rock.particles().held);
  held(5) = 1;
  Kokkos::deep_copy(rock.particles().held, held);
  EXPECT_TRUE(says("a support holds it"));
  EXPECT_FALSE(says("fragment"));
  held(5) = 0;
  Kokkos::deep_copy(rock.particles().held, held);
  // one that only turns, at its radius of gyration
  v(5, 1) = 0;
  Kokkos::deep_copy(rock.particles().v, v);
  const auto spin = host_copy(rock.particles().spin);
  spin(5) = -2e4 / std::sqrt(host_copy(rock.particles().inertia)(5) / host_copy(rock.particles().mass)(5));
  Kokkos::deep_copy(rock.particles().spin, spin);
  EXPECT_TRUE(says("particle 5 moves at 2e+04 m/s"));
  EXPECT_NEAR(rock.runaway(Exec(), 3000).speed, 2e4, 1e-8);
  // a step beyond the critical one makes energy from nothing
  PlatenTest unstable;
  unstable.step_fraction = 3;
  MechanicsParameters strong;
  strong.bond.normal_strength = strong.bond.cohesion = 1e15;
  EXPECT_THROW(load_between_platens(Exec(), test::block(0.01, 0.02, 2e-3, 0.25), strong, unstable), StabilityError);
}

}  // namespace
