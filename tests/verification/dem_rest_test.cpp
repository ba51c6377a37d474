// Rock that rests sleeps, costs nothing and wakes when it is pushed.
#include "dem_support.hpp"
#include "support/overheard.hpp"
#include "support/record.hpp"

#include <gtest/gtest.h>

#include <cstring>
#include <map>
#include <string>
#include <type_traits>

namespace {

using namespace vug;
using vug::test::host_copy;

constexpr double tolerance = 1e-3;

MechanicsParameters damped(double rest_tolerance) {
  MechanicsParameters p;
  p.local_damping = 0.7;
  p.rest_tolerance = rest_tolerance;
  return p;
}

Loads clamped() {
  Loads loads;
  loads.support = {Support::roller, Support::roller, Support::roller, Support::roller};
  return loads;
}

Mechanics square(double rest_tolerance) {
  return {test::block(0.04, 0.04, 2e-3, 0.2), damped(rest_tolerance), clamped()};
}

/// Force that breaks a bond, N per m: what the tolerance is a share of.
double breaking_force(const Mechanics& rock) {
  const auto length = host_copy(rock.bonds().length);
  double sum = 0;
  for (int k = 0; k < rock.bonds().count; ++k) sum += length(k);
  return rock.parameters().bond.normal_strength * sum / rock.bonds().count;
}

int particle_at(const Particles& p, double x, double y) {
  const auto x0 = host_copy(p.x0);
  int nearest = 0;
  const auto distance = [&](int i) { return std::hypot(x0(i, 0) - x, x0(i, 1) - y); };
  for (int i = 1; i < p.count; ++i)
    if (distance(i) < distance(nearest)) nearest = i;
  return nearest;
}

/// Until all of it sleeps; returns the steps that took.
int settle(Mechanics& rock, int longest = 20000) {
  const double dt = 0.5 * rock.critical_step();
  int steps = 0;
  do {
    rock.advance(Exec(), dt, 1);
    ++steps;
  } while (rock.awake_share() > 0 && steps < longest);
  return steps;
}

int launches = 0;
const test::Overheard* overheard = nullptr;
void launched(const char* label, std::uint32_t device, std::uint64_t* id) {
  ++launches;
  overheard->launched(label, device, id);
}

TEST(RestingRock, BearsTheStressOfClampedHeating) {
  const double dT = 20, alpha = 8e-6, size = 0.04;
  Mechanics rock = square(tolerance);
  settle(rock);
  ASSERT_EQ(rock.awake_share(), 0);
  Kokkos::deep_copy(rock.particles().temperature_change, dT);
  rock.advance(Exec(), 0.5 * rock.critical_step(), 17);
  EXPECT_EQ(rock.awake_share(), 1) << "heating wakes it";
  const int steps = settle(rock);
  EXPECT_EQ(rock.awake_share(), 0);
  const double expected = 24.03e9 / 0.659 * alpha * dT * size;
  test::record("resting_rock", {{"left", rock.reaction(RockSide::left).x / size},
                                {"exact", expected / size},
                                {"steps", static_cast<double>(steps)}});
  // as in the test without sleep: platens hold centroids, a third of a row inside
  EXPECT_NEAR(rock.reaction(RockSide::left).x, expected, 0.01 * expected);
}

/// Uniform warmth sets every bond under the same pressure before anything has moved. At top and bottom triangles are
/// whole but for the corners, so that centroids face each other and no bond is sheared.
TEST(RestingRock, IsHeldByTheForcesOfNowWhileItSleeps) {
  const double alpha = 8e-6, size = 0.04;
  Mechanics rock(test::block(size, size, 2e-3, 0), damped(0.1), clamped());
  settle(rock);
  const double dt = 0.5 * rock.critical_step();
  for (const double dT : {0.25, 0.5}) {
    Kokkos::deep_copy(rock.particles().temperature_change, dT);
    rock.advance(Exec(), dt, steps_between_looks + 1);
    ASSERT_EQ(rock.awake_share(), 0);
    const double expected = 24.03e9 / 0.659 * alpha * dT * size;
    EXPECT_NEAR(rock.reaction(RockSide::bottom).y, expected, 0.015 * expected);
    EXPECT_NEAR(rock.reaction(RockSide::top).y, -expected, 0.015 * expected);
  }
  // what pushes it from outside is held, too, although the rock itself is the same
  const double before = rock.reaction(RockSide::bottom).y, push = 1e-3 * before;
  const int at = particle_at(rock.particles(), 0.02, 0);
  ASSERT_EQ(host_copy(rock.particles().held)(at) & 2, 2);
  const auto force = host_copy(rock.particles().force);
  force(at, 1) = -push;
  Kokkos::deep_copy(rock.particles().force, force);
  rock.advance(Exec(), dt, steps_between_looks + 1, RockIs::the_same);
  ASSERT_EQ(rock.awake_share(), 0);
  EXPECT_NEAR(rock.reaction(RockSide::bottom).y - before, push, 1e-9 * push);
}

TEST(RestingRock, IsHeldByTheSameForcesAfterARestart) {
  Mechanics whole = square(0.1), resumed = square(0.1);
  settle(whole);
  const double dt = 0.5 * whole.critical_step();
  const auto warm = [&](Mechanics& rock, double dT) {
    Kokkos::deep_copy(rock.particles().temperature_change, dT);
    rock.advance(Exec(), dt, 11);  // looks come at 16
  };
  for (int k = 1; k <= 5; ++k) warm(whole, 0.1 * k);
  resumed.visit_state([&](const char* name, const auto& view, auto...) {
    whole.visit_state([&](const char* other, const auto& from, auto...) {
      if constexpr (std::is_same_v<std::decay_t<decltype(view)>, std::decay_t<decltype(from)>>)
        if (std::string(name) == other) Kokkos::deep_copy(view, from);
    });
  });
  resumed.set_time(whole.time());
  resumed.set_steps(whole.steps());
  resumed.set_all_due(whole.all_due());
  for (int k = 6; k <= 15; ++k) {
    const Vec2 a = whole.reaction(RockSide::left), b = resumed.reaction(RockSide::left);
    EXPECT_EQ(a.x, b.x) << k;
    EXPECT_EQ(a.y, b.y) << k;
    EXPECT_GT(a.x, 0);
    warm(whole, 0.1 * k);
    warm(resumed, 0.1 * k);
  }
}

TEST(RestingRock, LiesWhereRockThatNeverSleepsDoes) {
  Mechanics sleeps = square(tolerance), wakes = square(0);
  for (Mechanics* rock : {&sleeps, &wakes}) {
    const Particles& p = rock->particles();
    const auto force = host_copy(p.force);
    force(p.count / 2, 0) = 0.5 * breaking_force(*rock);
    Kokkos::deep_copy(p.force, force);
    rock->advance(Exec(), 0.5 * rock->critical_step(), 4000);
  }
  ASSERT_EQ(sleeps.awake_share(), 0);
  const auto a = host_copy(sleeps.particles().u), b = host_copy(wakes.particles().u);
  double largest = 0, difference = 0;
  for (int i = 0; i < sleeps.particles().count; ++i)
    for (int axis = 0; axis < 2; ++axis) {
      largest = std::max(largest, std::abs(b(i, axis)));
      difference = std::max(difference, std::abs(a(i, axis) - b(i, axis)));
    }
  // each particle may lack a thousandth of the breaking force, the push is half of it
  EXPECT_GT(largest, 0);
  EXPECT_LT(difference, 2 * tolerance / 0.5 * largest);
}

TEST(RestingRock, WakesWhereItIsPushedAndNowhereElse) {
  Mechanics rock = {test::block(0.16, 0.01, 2e-3, 0.2), damped(tolerance), clamped()};
  settle(rock);
  const Particles& p = rock.particles();
  const int near = particle_at(p, 0.15, 0.005), far = particle_at(p, 0.01, 0.005);
  const auto force = host_copy(p.force);
  force(near, 0) = tolerance * breaking_force(rock);  // ten times what wakes rock without a load
  Kokkos::deep_copy(p.force, force);
  rock.advance(Exec(), 0.5 * rock.critical_step(), 17);
  EXPECT_GT(rock.awake_share(), 0);
  EXPECT_LT(rock.awake_share(), 0.5);
  settle(rock);
  EXPECT_EQ(rock.awake_share(), 0);
  EXPECT_EQ(host_copy(p.u)(far, 0), 0) << "far away nothing has moved";
  EXPECT_GT(host_copy(p.u)(near, 0), 0);
}

/// A bond that sleeps has the load that it had, so that looks need not compute it while the rock stays the same.
TEST(RestingRock, SleepsAlikeWhereLooksPassItOver) {
  const auto block = [] { return Mechanics(test::block(0.16, 0.01, 2e-3, 0.2), damped(tolerance), clamped()); };
  Mechanics seen = block(), passed_over = block();
  const double dt = 0.5 * seen.critical_step();
  const int pushed = particle_at(seen.particles(), 0.15, 0.005);
  double least = 1, most = 0;
  for (int phase = 0; phase < 6; ++phase) {
    for (Mechanics* rock : {&seen, &passed_over}) {
      const auto force = host_copy(rock->particles().force);
      force(pushed, 0) = phase % 2 == 0 ? 0 : (1 + phase) * tolerance * breaking_force(*rock);
      Kokkos::deep_copy(rock->particles().force, force);
    }
    for (int n = 0; n < 40; ++n) {
      seen.advance(Exec(), dt, 17, RockIs::changed);
      passed_over.advance(Exec(), dt, 17, RockIs::the_same);
      least = std::min(least, passed_over.awake_share());
      most = std::max(most, passed_over.awake_share());
      ASSERT_EQ(seen.awake_share(), passed_over.awake_share());
    }
    const auto u = host_copy(seen.particles().u), other_u = host_copy(passed_over.particles().u);
    for (int i = 0; i < seen.particles().count; ++i)
      for (int axis = 0; axis < 2; ++axis) ASSERT_EQ(u(i, axis), other_u(i, axis)) << "phase " << phase;
    const auto load = host_copy(seen.bonds().load), other_load = host_copy(passed_over.bonds().load);
    for (int k = 0; k < seen.bonds().count; ++k)
      for (int c = 0; c < 4; ++c) ASSERT_EQ(load(k, c), other_load(k, c)) << "phase " << phase;
  }
  EXPECT_EQ(least, 0);
  EXPECT_GT(most, 0);
}

TEST(RestingRock, LaunchesNothingBetweenLooks) {
  Mechanics rock = square(tolerance);
  settle(rock);
  const double dt = 0.5 * rock.critical_step();
  while (rock.steps() % 16 != 1 || rock.steps() % 50 > 30) rock.advance(Exec(), dt, 1);
  const test::Overheard others;
  overheard = &others;
  using namespace Kokkos::Tools::Experimental;
  launches = 0;
  set_begin_parallel_for_callback(launched);
  set_begin_parallel_reduce_callback(launched);
  set_push_region_callback([](const char* label) {  // a recording
    ++launches;
    overheard->region_began(label);
  });
  rock.advance(Exec(), dt, 15, RockIs::the_same);
  const int between = launches;
  rock.advance(Exec(), dt, 1);
  // a GPU would have to wait for the number of those awake: it launches a recording, which finds nothing to do
  EXPECT_EQ(between, runs_on_host ? 0 : 1);
  EXPECT_GT(launches, 0) << "the look itself";
  EXPECT_EQ(rock.awake_share(), 0);
}

TEST(RestingRock, MovesAlikeHoweverManyLatticeStepsItIsOwedAtOnce) {
  Mechanics at_once = square(tolerance), in_turn = square(tolerance);
  const double dt = 0.5 * at_once.critical_step();
  for (Mechanics* rock : {&at_once, &in_turn}) Kokkos::deep_copy(rock->particles().temperature_change, 20);
  for (const int times : {1, 16, 3, 7}) {
    at_once.advance(Exec(), dt, 5, RockIs::changed, times);
    for (int t = 0; t < times; ++t) in_turn.advance(Exec(), dt, 5, t == 0 ? RockIs::changed : RockIs::the_same);
  }
  EXPECT_EQ(at_once.steps(), in_turn.steps());
  EXPECT_EQ(at_once.time(), in_turn.time());
  const auto u = host_copy(at_once.particles().u), other_u = host_copy(in_turn.particles().u);
  const auto v = host_copy(at_once.particles().v), other_v = host_copy(in_turn.particles().v);
  for (int i = 0; i < at_once.particles().count; ++i)
    for (int axis = 0; axis < 2; ++axis) {
      ASSERT_EQ(u(i, axis), other_u(i, axis)) << i;
      ASSERT_EQ(v(i, axis), other_v(i, axis)) << i;
    }
}

TEST(RestingRock, IsNoOtherRockWhileItIsAwake) {
  Mechanics watched = square(1e-14), plain = square(0);
  for (Mechanics* rock : {&watched, &plain}) {
    Kokkos::deep_copy(rock->particles().temperature_change, 20);
    rock->advance(Exec(), 0.5 * rock->critical_step(), 100);
  }
  EXPECT_EQ(watched.awake_share(), 1);
  const auto a = host_copy(watched.particles().u), b = host_copy(plain.particles().u);
  EXPECT_EQ(std::memcmp(a.data(), b.data(), a.span() * sizeof(double)), 0);
}

/// Switches are those of groups, whose size must not depend on what computes them: a processor's checkpoint goes on on
/// a GPU, and the other way.
TEST(RestingRock, HasAsManySwitchesInACheckpointWhateverBackEndWritesIt) {
  const Mechanics rock = square(tolerance);
  const std::size_t bonds = rock.bonds().count, particles = rock.particles().count;
  ASSERT_GT(bonds, 64u);
  std::map<std::string, std::size_t> switches;
  rock.visit_state([&](const std::string& name, const auto& view, auto...) { switches[name] = view.size(); });
  EXPECT_EQ(switches.at("awake"), (particles + 63) / 64);
  EXPECT_EQ(switches.at("bonds_awake"), (bonds + 7) / 8);
  EXPECT_EQ(switches.at("bonds_due"), (bonds + 7) / 8);
}

TEST(RestingRock, NeverSleepsUnderAServoOrALedger) {
  Loads pressed = clamped();
  pressed.support[static_cast<std::size_t>(RockSide::right)] = Support::servo;
  Mechanics servo(test::block(0.02, 0.02, 2e-3, 0.2), damped(tolerance), pressed);
  MechanicsParameters accounted = damped(tolerance);
  accounted.energy_ledger = true;
  Mechanics ledger(test::block(0.02, 0.02, 2e-3, 0.2), accounted, clamped());
  for (Mechanics* rock : {&servo, &ledger}) {
    rock->advance(Exec(), 0.5 * rock->critical_step(), 200);
    EXPECT_EQ(rock->awake_share(), 1);
  }
}

}  // namespace
