// Static equilibrium by a direct solver: against the balance of forces, and against waiting until waves have died away.
#include "dem/edges.hpp"
#include "dem_support.hpp"
#include "support/tectonic_loads.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace {

using namespace vug;
using vug::test::host_copy;
using vug::test::tectonic;

constexpr double width = 0.05, height = 0.035;

/// A crooked crack from the left side to the middle.
Assembly cracked_block() {
  Assembly assembly = test::block(width, height, 2.5e-3, 0.2);
  for (const Edge& edge : find_edges(assembly)) {
    if (edge.triangle[1] < 0) continue;
    const auto &p = assembly.vertices[edge.vertex[0]], &q = assembly.vertices[edge.vertex[1]];
    const double x = 0.5 * (p[0] + q[0]), y = 0.5 * (p[1] + q[1]) - 0.3 * x;
    if (x < 0.5 * width && std::abs(y - 0.4 * height) < 0.9e-3) assembly.initial_cracks.push_back(edge.vertex);
  }
  return assembly;
}

/// Largest difference of the displacements and of the rotations, over the largest ones.
std::array<double, 2> difference(const Mechanics& a, const Mechanics& b) {
  const auto ua = host_copy(a.particles().u), ub = host_copy(b.particles().u);
  const auto ta = host_copy(a.particles().angle), tb = host_copy(b.particles().angle);
  std::array<double, 2> off{0, 0}, largest{0, 0};
  for (int i = 0; i < a.particles().count; ++i) {
    for (int axis = 0; axis < 2; ++axis) {
      off[0] = std::max(off[0], std::abs(ua(i, axis) - ub(i, axis)));
      largest[0] = std::max(largest[0], std::abs(ub(i, axis)));
    }
    off[1] = std::max(off[1], std::abs(ta(i) - tb(i)));
    largest[1] = std::max(largest[1], std::abs(tb(i)));
  }
  return {off[0] / largest[0], off[1] / largest[1]};
}

/// The explicit way, until nothing moves in the digits compared.
Mechanics waited(const Assembly& assembly, const MechanicsParameters& given, const Loads& loads, double ramp = 2e-4) {
  MechanicsParameters parameters = given;
  parameters.local_damping = 0.7;
  Mechanics rock(assembly, parameters, loads);
  rock.preload(Exec(), ramp);
  rock.advance(Exec(), 0.3 * rock.critical_step(), 3000);
  return rock;
}

TEST(StaticEquilibrium, IsWhereWaitingLeads) {
  Loads loads = tectonic();
  loads.gravity = {0, -9.81e3};  // a thousandfold, so that it shows beside the tractions
  const Assembly assembly = test::block(width, height, 2.5e-3, 0.2);
  Mechanics solved(assembly, {}, loads);
  ASSERT_TRUE(solved.preload_statically(Exec()));
  const Mechanics rested = waited(assembly, {}, loads);
  const auto [shift, turn] = difference(solved, rested);
  EXPECT_LT(shift, 1e-6);
  EXPECT_LT(turn, 1e-6);
}

TEST(StaticEquilibrium, OfRockWithASmoothCrackIsWhereWaitingLeads) {
  const Assembly assembly = cracked_block();
  ASSERT_GT(assembly.initial_cracks.size(), 6u);
  MechanicsParameters parameters;
  parameters.contact.friction = 0;
  Mechanics solved(assembly, parameters, tectonic());
  ASSERT_TRUE(solved.preload_statically(Exec()));
  const auto [shift, turn] = difference(solved, waited(assembly, parameters, tectonic()));
  EXPECT_LT(shift, 1e-6);
  EXPECT_LT(turn, 1e-6);
}

/// A crack with friction rests in many states, and the waves of a ramp decide in which: the slower it is, the nearer.
TEST(StaticEquilibrium, OfRockWithARoughCrackIsWhereSlowRampsLead) {
  const Assembly assembly = cracked_block();
  Mechanics solved(assembly, {}, tectonic());
  ASSERT_TRUE(solved.preload_statically(Exec()));
  const double fast = difference(solved, waited(assembly, {}, tectonic(), 2e-4))[0];
  const double slow = difference(solved, waited(assembly, {}, tectonic(), 6e-4))[0];
  EXPECT_LT(fast, 4e-3);
  EXPECT_LT(slow, 0.45 * fast);
}

TEST(StaticEquilibrium, StaysAtRestAndBalancesItsLoads) {
  Loads loads = tectonic();
  loads.stiffness[static_cast<std::size_t>(RockSide::right)] = 1e12;  // takes no part in a preload
  Mechanics rock(cracked_block(), {}, loads);
  ASSERT_TRUE(rock.preload_statically(Exec()));
  EXPECT_EQ(rock.steps(), 0);
  EXPECT_NEAR(rock.reaction(RockSide::left).x, 5e6 * height, 1e-8 * 5e6 * height);  // at once
  rock.advance(Exec(), 0.3 * rock.critical_step(), 1000);
  EXPECT_LT(rock.energies(Exec()).kinetic, 1e-18 * rock.energies(Exec()).elastic);
  EXPECT_NEAR(rock.reaction(RockSide::left).x, 5e6 * height, 1e-8 * 5e6 * height);
  EXPECT_NEAR(rock.reaction(RockSide::bottom).y, 7.5e6 * width, 1e-8 * 7.5e6 * width);
}

TEST(StaticEquilibrium, LeavesTheRockAloneWhereThereIsNone) {
  Loads free = tectonic();  // nothing holds it
  free.support = {};
  Loads strong = tectonic();  // bonds break
  strong.traction[static_cast<std::size_t>(RockSide::top)] = {0, 40e6};
  for (const Loads& loads : {free, strong}) {
    Mechanics rock(cracked_block(), {}, loads);
    EXPECT_FALSE(rock.preload_statically(Exec()));
    const auto u = host_copy(rock.particles().u);
    for (int i = 0; i < rock.particles().count; ++i) {
      EXPECT_EQ(u(i, 0), 0);
      EXPECT_EQ(u(i, 1), 0);
    }
    EXPECT_EQ(rock.bond_counts().damaged, 0);
  }
}

}  // namespace
