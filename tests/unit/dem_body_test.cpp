// A triangle or two against formulas by hand: critical step, stress, loads and supports, a crack that was there.
#include "dem/gauges.hpp"
#include "dem/materials.hpp"
#include "dem/mean_stress.hpp"
#include "dem_support.hpp"
#include "kernels/base/require.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace {

using namespace vug;
using vug::test::host_copy;

constexpr double l = 2e-3;  // m

/// A right triangle with legs l at the origin: I = m l^2 / 9, its far corners at sqrt(5)/3 l from the centroid.
const Assembly lone{{{0, 0}, {l, 0}, {0, l}}, {{0, 1, 2}}, {}};

/// Two bonded triangles with an edge of l in common, turned by an angle.
Assembly turned_pair(double angle) {
  Assembly pair = test::pair_of_triangles(l);
  for (auto& [x, y] : pair.vertices) {
    const double before = x;
    x = std::cos(angle) * x - std::sin(angle) * y;
    y = std::sin(angle) * before + std::cos(angle) * y;
  }
  return pair;
}

MechanicsParameters nearly_free() {
  MechanicsParameters p;
  p.contact.normal_stiffness = p.contact.tangential_stiffness = 1e-3;
  p.contact.normal_damping = p.contact.tangential_damping = 0;
  p.bond.damping = 0;
  p.bond.weibull_shape = 0;
  return p;
}

/// 2 / omega of the leapfrog, (2 / omega) (sqrt(1 + z^2) - z) with a dashpot of z = c / (m omega).
double step_of(double stiffness, double mass, double dashpot = 0) {
  const double omega = std::sqrt(stiffness / mass), z = dashpot / (mass * omega);
  return 2 / omega * (std::sqrt(1 + z * z) - z);
}

/// Springs and dashpots of a contact have a mirror image at the other triangle, that of the rock beyond has none.
TEST(CriticalStep, OfALoneTriangleIsThatOfItsSpring) {
  const double m = 2500 * l * l / 2;
  const auto step = [](const MechanicsParameters& parameters, const Loads& loads = {}) {
    return Mechanics(lone, parameters, loads).critical_step();
  };
  MechanicsParameters p = nearly_free();
  p.contact.normal_stiffness = 3e9;
  EXPECT_NEAR(step(p) / step_of(2 * 3e9, m), 1, 1e-6);
  p.contact.normal_damping = 2e3;
  EXPECT_NEAR(step(p) / step_of(2 * 3e9, m, 2e3), 1, 1e-6);
  p = nearly_free();
  p.contact.tangential_stiffness = 3e9;  // moves it and, at the far corner, turns it: 1 + |r|^2 m / I = 6
  EXPECT_NEAR(step(p) / step_of(2 * 6 * 3e9, m), 1, 1e-6);
  p.contact.tangential_damping = 2e3;
  EXPECT_NEAR(step(p) / step_of(2 * 6 * 3e9, m, 6 * 2e3), 1, 1e-6);
  for (const RockSide side : {RockSide::left, RockSide::bottom}) {
    Loads loads;
    loads.stiffness[static_cast<std::size_t>(side)] = 1e12;  // Pa/m on an edge of l
    EXPECT_NEAR(step(nearly_free(), loads) / step_of(1e12 * l, m), 1, 1e-6) << static_cast<int>(side);
  }
}

/// The bond acts at the Gauss points of its edge, +- l / (2 sqrt 3) from its middle, l / (2 sqrt 3) from the centroid.
TEST(CriticalStep, OfABondedPairIsThatOfItsBond) {
  const double m = 2500 * l * l * std::sqrt(3.0) / 4, arm = l / (2 * std::sqrt(3.0)), rho = l / std::sqrt(12.0);
  const double length = 0.659 * l / std::sqrt(3.0);
  for (const double softened : {1.0, 1e-3})  // the normal spring prevails, or the tangential one
    for (const double d_c : {0.0, 0.4}) {
      MechanicsParameters p = nearly_free();
      p.bond.normal_modulus *= softened;
      const double k_n = (1 - d_c) * p.bond.normal_modulus * l / length;
      const double k_t = (1 - d_c) * p.bond.tangential_modulus * l / length;
      // of (u_n), and of (u_t, rho angle) with the lever arm of the normal springs along the edge
      const auto largest = [&](double n, double t) {
        const double b = t * arm / rho, c = (n + t) * arm * arm / (rho * rho);
        return std::max(n, 0.5 * (t + c) + std::hypot(0.5 * (t - c), b));
      };
      for (const double angle : {0.0, 0.5}) {
        p.bond.damping = angle == 0 ? 0 : 3e-6;  // of the sound bond
        const double dashpot = p.bond.damping * largest(p.bond.normal_modulus * l, p.bond.tangential_modulus * l);
        const Mechanics rock(turned_pair(angle), p, {});
        Kokkos::deep_copy(rock.bonds().d_c, d_c);
        EXPECT_NEAR(rock.critical_step() / step_of(2 * largest(k_n, k_t), m, dashpot), 1, 1e-6)
            << softened << d_c << angle;
      }
    }
}

/// The bond's force over the edge, F = l (sigma n + tau t), makes the stress sym(r F) / A, r from the centroid to the
/// middle of the edge, in both triangles.
TEST(MeanStress, IsThatOfTheForceAcrossTheOnlyEdge) {
  const double angle = 0.4, opening = -3e-8, sliding = 2e-8, length = 0.659 * l / std::sqrt(3.0);
  Mechanics rock(turned_pair(angle), nearly_free(), {});
  const Vec2 n{std::cos(angle), std::sin(angle)}, t{-n.y, n.x};
  const Vec2 u = opening * n + sliding * t;
  test::place(rock.particles(), 1, u.x, u.y);
  rock.advance(Exec(), 1e-12, 1);
  const double sigma = 24.03e9 * opening / length, tau = 10.68e9 * sliding / length;
  const Vec2 force = l * (sigma * n + tau * t), r = l / (2 * std::sqrt(3.0)) * n;
  const double area = l * l * std::sqrt(3.0) / 4;
  const double xx = r.x * force.x / area, yy = r.y * force.y / area;
  const double xy = 0.5 * (r.x * force.y + r.y * force.x) / area;
  const auto each = host_copy(stress_of_triangles(Exec(), rock.particles(), rock.bonds()));
  const Stress both = mean_stress(rock.particles(), rock.bonds(), {0, 1});
  for (int i = 0; i < 2; ++i) {
    EXPECT_NEAR(each(i, 0) / xx, 1, 1e-6);
    EXPECT_NEAR(each(i, 1) / yy, 1, 1e-6);
    EXPECT_NEAR(each(i, 2) / xy, 1, 1e-6);
  }
  EXPECT_NEAR(both.xx / xx, 1, 1e-6);
  EXPECT_NEAR(both.yy / yy, 1, 1e-6);
  EXPECT_NEAR(both.xy / xy, 1, 1e-6);
}

/// An edge that was cracked from the start bears nothing at either of its ends when it opens.
TEST(InitialCrack, BearsNoTensionAtEitherEnd) {
  Assembly pair = test::pair_of_triangles(l);
  pair.initial_cracks = {{0, 1}};
  Mechanics rock(pair, nearly_free(), {});
  const auto damage = host_copy(rock.bonds().point_damage);
  EXPECT_EQ(damage(0, 0), 1);
  EXPECT_EQ(damage(0, 1), 1);
  EXPECT_EQ(host_copy(rock.bonds().d_m)(0), 1);
  test::place(rock.particles(), 1, 1e-8, 0, 1e-6);
  rock.advance(Exec(), 1e-12, 1);
  const auto load = host_copy(rock.bonds().load);
  EXPECT_EQ(load(0, 0), 0);
  EXPECT_EQ(load(0, 1), 0);
}

/// Of the ends of a cracked edge the furthest along a direction; where none lies beyond, the place it is asked from.
TEST(CrackTip, IsTheEndOfTheCrackedEdge) {
  const double angle = 0.4;
  Assembly pair = turned_pair(angle);
  pair.initial_cracks = {{0, 1}};
  const Mechanics rock(pair, nearly_free(), {});
  const Vec2 n{std::cos(angle), std::sin(angle)}, t{-n.y, n.x};
  const auto tip = [&](Vec2 from, Vec2 direction) {
    return furthest_crack_tip(Exec(), rock.particles(), rock.bonds(), from, direction);
  };
  EXPECT_NEAR(norm(tip(0.1 * l * t, t) - l * t), 0, 1e-12 * l);
  EXPECT_NEAR(norm(tip(0.1 * l * t, -1.0 * t)), 0, 1e-12 * l);
  EXPECT_NEAR(norm(tip(2 * l * t, t) - 2 * l * t), 0, 1e-12 * l);
}

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
        EXPECT_EQ(said, "") << name << k;
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

/// A warm rock that nothing holds grows by alpha dT about any point: a gauge must not only see centroids part.
TEST(Gauge, SeesATriangleGrow) {
  const double alpha = 8e-6, dT = 20, turned = 0.3;
  MechanicsParameters parameters;
  parameters.thermal_expansion = alpha;
  Mechanics rock(lone, parameters, {});
  const Particles& p = rock.particles();
  Kokkos::deep_copy(p.temperature_change, dT);
  const auto at = [&](Vec2 arm) { return displacement_of(Exec(), p, parameters.thermal_expansion, {0, arm}); };
  const Vec2 a{-l / 4, l / 8}, b{l / 5, -l / 6};
  const Vec2 apart = at(b) - at(a);
  EXPECT_NEAR(apart.x, alpha * dT * (b - a).x, 1e-12 * alpha * dT * l);
  EXPECT_NEAR(apart.y, alpha * dT * (b - a).y, 1e-12 * alpha * dT * l);
  test::place(p, 0, 2e-5, -3e-5, turned);
  const double grown = 1 + alpha * dT, cos = std::cos(turned), sin = std::sin(turned);
  EXPECT_NEAR(at(b).x, 2e-5 + grown * (cos * b.x - sin * b.y) - b.x, 1e-12 * l);
  EXPECT_NEAR(at(b).y, -3e-5 + grown * (sin * b.x + cos * b.y) - b.y, 1e-12 * l);
}

/// Points of one triangle, and points further apart, in rock that grows freely: everywhere the strain is alpha dT.
TEST(Gauge, SeesTheFreeStrainOfHeatAtAnyDistance) {
  const double alpha = 8e-6, dT = 20, strain = alpha * dT;
  MechanicsParameters parameters;
  parameters.thermal_expansion = alpha;
  Mechanics rock(test::block(0.01, 0.01, 1e-3, 0.2), parameters, {});
  const Particles& p = rock.particles();
  Kokkos::deep_copy(p.temperature_change, dT);
  const auto x0 = host_copy(p.x0), u = host_copy(p.u);
  for (int i = 0; i < p.count; ++i)
    for (int axis = 0; axis < 2; ++axis) u(i, axis) = strain * x0(i, axis);
  Kokkos::deep_copy(p.u, u);
  const double dt = 0.3 * rock.critical_step();
  rock.advance(Exec(), dt, 1);
  const auto v = host_copy(p.v);
  for (int i = 0; i < p.count; ++i) ASSERT_LT(std::hypot(v(i, 0), v(i, 1)), 1e-9 * strain * 1e-3 / dt) << "at rest";
  for (const int i : {0, p.count / 2, p.count - 1}) {
    const Vec2 arm{1e-4, -2e-4};
    const Vec2 moved = displacement_of(Exec(), p, alpha, {i, arm});
    EXPECT_NEAR(moved.x, strain * (x0(i, 0) + arm.x), 1e-9 * strain * 0.01);
    EXPECT_NEAR(moved.y, strain * (x0(i, 1) + arm.y), 1e-9 * strain * 0.01);
  }
}

/// Each by its own material's expansion.
TEST(Gauge, SeesTrianglesOfTwoMaterialsGrow) {
  MechanicsParameters parameters;
  parameters.thermal_expansion = 5e-6;
  parameters.materials = {{2500, 2e-5, parameters.bond}};
  Assembly pair = test::pair_of_triangles(l);
  pair.region = {0, 1};
  Mechanics rock(pair, parameters, {});
  const Particles& p = rock.particles();
  Kokkos::deep_copy(p.temperature_change, 30.0);
  rock.advance(Exec(), 1e-9, 0);
  const double growth[] = {30 * 5e-6, 30 * 2e-5};
  for (int i = 0; i < 2; ++i) {
    const Vec2 moved = displacement_of(Exec(), p, rock.parameters().thermal_expansion, {i, {l / 7, l / 9}});
    EXPECT_NEAR(moved.x, growth[i] * l / 7, 1e-12 * growth[i] * l);
    EXPECT_NEAR(moved.y, growth[i] * l / 9, 1e-12 * growth[i] * l);
  }
}

}  // namespace
