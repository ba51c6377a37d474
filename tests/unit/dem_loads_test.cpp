// What pushes and holds the rock at its sides, and how it comes to rest under that.
#include "base/require.hpp"
#include "dem/materials.hpp"
#include "dem_support.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace {

using namespace vug;
using vug::test::host_copy;
using vug::test::nearly_free;

constexpr double l = 2e-3;  // m

const Assembly lone = test::right_triangle(l);

/// A support at one point of a side holds the triangle there; the rest of the side is free.
TEST(PointSupport, HoldsATriangleAgainstItsWeight) {
  for (const bool held : {false, true}) {
    Loads loads;
    loads.gravity = {0, -9.81};
    if (held) loads.parts.push_back({RockSide::bottom, l / 3, l / 3, Support::fixed, {}, 0, {}, false});
    Mechanics rock(lone, nearly_free(), loads);
    rock.advance(Exec(), 1e-7, 10);
    const double fallen = -9.81 * 1e-14 * 10 * 11 / 2;
    EXPECT_NEAR(host_copy(rock.particles().u)(0, 1), held ? 0 : fallen, 1e-9 * std::abs(fallen)) << held;
  }
}

/// A support holds the triangle of whose edge it has more than half in all, however it is cut; of parts that overlap
/// the later one counts, also where one of them is a point.
TEST(SupportedPart, HoldsAnEdgeOfWhichItHasMoreThanHalf) {
  const auto part = [](double from, double to, Support support) {
    return SidePart{RockSide::left, from * l, to * l, support, {}, 0, {}, false};
  };
  const auto falls = [](Support side, std::vector<SidePart> parts) {
    Loads loads;
    loads.gravity = {0, -9.81};
    loads.support[static_cast<std::size_t>(RockSide::left)] = side;
    loads.parts = std::move(parts);
    try {
      Mechanics rock(lone, nearly_free(), loads);
      rock.advance(Exec(), 1e-7, 10);
      return host_copy(rock.particles().u)(0, 1) != 0;
    } catch (const InputError&) {  // a support that holds nothing
      return true;
    }
  };
  const auto fixed = Support::fixed, none = Support::free;
  EXPECT_FALSE(falls(fixed, {part(0.45, 0.55, none)})) << "one in the middle";
  EXPECT_TRUE(falls(fixed, {part(0.2, 0.4, none), part(0.5, 0.9, none)}));
  EXPECT_FALSE(falls(none, {part(0, 0.5, fixed), part(0.5, 1, fixed)})) << "two that meet";
  EXPECT_FALSE(falls(none, {part(0.1, 0.3, fixed), part(0.5, 0.9, fixed)}));
  EXPECT_TRUE(falls(none, {part(0.1, 0.3, fixed), part(0.6, 0.8, fixed)}));
  SidePart moving = part(0.5, 0.9, fixed);
  moving.velocity[1] = [](double) { return 0.0; };
  EXPECT_TRUE(falls(none, {part(0.1, 0.4, fixed), moving})) << "one that moves is another support";
  EXPECT_TRUE(falls(none, {part(0, 0.7, fixed), part(0.3, 0.7, none)})) << "a later one cuts it";
  EXPECT_FALSE(falls(none, {part(0.5, 0.5, none), part(0, 1, fixed)})) << "a point under a later part";
  EXPECT_TRUE(falls(none, {part(0, 1, fixed), part(0.5, 0.5, none)}));
}

/// A load on a part of an edge acts at the middle of that part.
TEST(LoadOnAPart, HasItsForceAndItsLeverArm) {
  const double dt = 1e-9, pressure = 3e6, m = 2500 * l * l / 2;
  for (const auto& [from, to] : {std::pair{0.0, 0.4 * l}, {0.5 * l, 0.9 * l}}) {
    Loads loads;
    SidePart part{RockSide::left, from, to, Support::free, {}, 0, {}, false};
    part.traction[0] = [pressure](double) { return pressure; };
    loads.parts.push_back(part);
    Mechanics rock(lone, nearly_free(), loads);
    rock.advance(Exec(), dt, 1);
    const double force = pressure * (to - from), arm_y = 0.5 * (from + to) - l / 3;
    EXPECT_NEAR(host_copy(rock.particles().v)(0, 0) / (dt * force / m), 1, 1e-9) << from;
    EXPECT_NEAR(host_copy(rock.particles().spin)(0) / (dt * -arm_y * force / (m * l * l / 9)), 1, 1e-9) << from;
  }
}

/// Dashpots answer to the platen's speed at once: a servo that took them for springs would swing ever wider where they
/// are strong or steps are short.
TEST(Servo, HoldsItsPressureAgainstDashpotsOfAnyStrength) {
  const double pressure = 4e6, side = 0.02;
  Loads loads;
  loads.support[static_cast<std::size_t>(RockSide::left)] = Support::roller;
  loads.support[static_cast<std::size_t>(RockSide::bottom)] = Support::roller;
  loads.support[static_cast<std::size_t>(RockSide::top)] = Support::servo;
  loads.traction[static_cast<std::size_t>(RockSide::top)] = {0, -pressure};
  struct Setting {
    double damping, step;  // s/m, of the critical step
    int steps;
  };
  for (const auto& [damping, step, steps] : {Setting{4.6e-6, 0.3, 3000}, Setting{4.6e-6, 0.01, 20000},
                                             Setting{4.6e-5, 0.3, 6000}, Setting{4.6e-4, 0.3, 20000}}) {
    MechanicsParameters parameters = test::elastic(0.7);
    parameters.bond.damping = damping;
    Mechanics rock(test::block(side, side, 4e-3, 0.2), parameters, loads);
    rock.advance(Exec(), step * rock.critical_step(), steps);
    const double error = -rock.reaction(RockSide::top).y / side / pressure - 1;
    std::printf("    eta %g s/m, %g of the critical step: off by %.2g\n", damping, step, error);
    EXPECT_LT(std::abs(error), 2e-4) << damping << " " << step;
  }
}

/// A ramp of a hundred steps, then three looks in a row, a fifth of the ramp apart, that find the rock at rest.
TEST(Preload, CountsItsSteps) {
  Mechanics rock(lone, nearly_free(), {});
  const PreloadReport report = rock.preload(Exec(), 100 * 0.3 * rock.critical_step());
  EXPECT_TRUE(report.settled);
  EXPECT_EQ(report.steps, 160);
}

/// 40 m of rock that sound takes 12 ms to cross: the stress is there, whatever ramp was asked for.
TEST(Preload, OfLargeRockEndsAtRestAfterAnyRamp) {
  Loads loads;
  loads.support[static_cast<std::size_t>(RockSide::left)] = Support::roller;
  loads.support[static_cast<std::size_t>(RockSide::bottom)] = Support::roller;
  loads.traction[static_cast<std::size_t>(RockSide::top)] = {0, -6e6};
  for (const double ramp : {0.0, 150e-6}) {
    Mechanics rock(test::block(40, 20, 4, 0.2), test::elastic(), loads);
    const PreloadReport report = rock.preload(Exec(), ramp);
    EXPECT_TRUE(report.settled) << ramp;
    EXPECT_NEAR(rock.reaction(RockSide::bottom).y, 6e6 * 40, 1e-4 * 6e6 * 40) << ramp;
    EXPECT_EQ(unrest_of(report), "");
  }
}

/// Rock that rests all the time: the ramp and three fifths of it, of two crossings of sound where less was asked for.
TEST(Preload, RisesOverTwoCrossingsAtLeast) {
  const Assembly block = test::block(0.02, 0.04, 2e-3, 0.2);
  const double crossing = sound_crossing({}, block);
  for (const double asked : {0.0, 1.0, 5.0}) {
    Mechanics rock(block, {}, {});
    const PreloadReport report = rock.preload(Exec(), asked * crossing);
    EXPECT_TRUE(report.settled);
    EXPECT_NEAR(report.crossings, 1.6 * std::max(asked, 2.0), 0.03) << asked;
  }
}

/// By hand: 12 mm at sqrt(24.03e9 / (0.659 * 2500 * (1 + nu))), nu = 0.2384; four times the mass, half the speed.
TEST(Preload, CountsCrossingsOfSound) {
  const Assembly block = test::block(0.012, 0.006, 2e-3, 0.2);
  MechanicsParameters parameters;
  EXPECT_NEAR(sound_crossing(parameters, block), 0.012 / 3432.1, 1e-3 * 0.012 / 3432.1);
  parameters.mass_scaling = 4;
  EXPECT_NEAR(sound_crossing(parameters, block), 0.024 / 3432.1, 1e-3 * 0.024 / 3432.1);
}

TEST(Preload, SaysOfRockThatFallsThatItDidNotComeToRest) {
  Loads loads;
  loads.gravity = {0, -9.81};
  Mechanics rock(test::block(0.01, 0.01, 2e-3, 0.2), {}, loads);
  EXPECT_FALSE(rock.ramped());
  const PreloadReport report = rock.preload(Exec(), 0);
  EXPECT_FALSE(report.settled);
  EXPECT_GE(report.crossings, 500);
  EXPECT_NE(unrest_of(report).find("the preload did not come to rest: after "), std::string::npos);
  ASSERT_TRUE(rock.ramped());
  EXPECT_EQ(rock.ramped()->steps, report.steps);
}

/// What the rock says about loads; nothing where it takes them. The triangle has edges on its left and at its bottom.
std::string refusal(const Loads& loads) {
  try {
    const Mechanics rock(lone, nearly_free(), loads);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(Loads, OfASideWithoutAnEdgeAreRefused) {
  EXPECT_EQ(refusal({}), "");
  for (const auto side : {RockSide::right, RockSide::top, RockSide::left, RockSide::bottom}) {
    const auto s = static_cast<std::size_t>(side);
    std::array<Loads, 4> each;
    each[0].traction[s] = {0, -1e6};
    each[1].support[s] = Support::roller;
    each[2].stiffness[s] = 1e12;
    each[3].support[s] = Support::servo;
    for (std::size_t k = 0; k < each.size(); ++k) {
      const std::string said = refusal(each[k]), name = each[k].name[s];
      if (side == RockSide::left || side == RockSide::bottom)
        EXPECT_EQ(said, k < 3 ? "" : name + ": a servo needs a bond between the triangles it holds and others") << k;
      else
        EXPECT_EQ(said.find(name + ": the rock has no edge on this side to " + (k % 2 == 0 ? "push" : "hold")), 0u)
            << said << k;
    }
  }
}

TEST(Loads, OfAPartThatMeetsNoEdgeAreRefused) {
  const auto part = [](RockSide side, double from, double to, Support support, double pressure = 0) {
    SidePart one{side, from, to, support, {}, 0, {}, false, "part"};
    one.traction[0] = [pressure](double) { return pressure; };
    return one;
  };
  const auto with = [](std::vector<SidePart> parts) {
    Loads loads;
    loads.parts = std::move(parts);
    return refusal(loads);
  };
  const auto left = RockSide::left;
  EXPECT_EQ(with({part(left, 0.5 * l, 0.9 * l, Support::free, 1e6)}), "");
  EXPECT_EQ(with({part(left, 0.3 * l, 0.9 * l, Support::roller)}), "");
  EXPECT_EQ(with({part(left, 0.5 * l, 0.5 * l, Support::pin)}), "");
  EXPECT_EQ(with({part(RockSide::top, 0, l, Support::free)}), "") << "asks for nothing";
  EXPECT_NE(with({part(left, 1.1 * l, 2 * l, Support::free, 1e6)}).find("no edge between its ends to push"),
            std::string::npos);
  for (const SidePart& lost : {part(left, 0.1 * l, 0.5 * l, Support::roller), part(left, 2 * l, 3 * l, Support::fixed),
                               part(RockSide::right, 0.5 * l, 0.5 * l, Support::pin)})
    EXPECT_EQ(with({lost}).find("part: the rock has no edge between its ends to hold"), 0u) << with({lost});
  EXPECT_EQ(with({part(left, 0, l, Support::roller), part(left, 0, l, Support::free, 1e6)}), "") << "hidden by another";
  EXPECT_NE(with({part(left, 0, l, Support::roller), part(left, 0, 0.6 * l, Support::free, 1e6)}), "")
      << "what is left of the first holds nothing";
}

}  // namespace
