// A triangle or two against formulas by hand: critical step, stress, growth, a crack that was there.
#include "dem/gauges.hpp"
#include "dem/materials.hpp"
#include "dem/mean_stress.hpp"
#include "dem_support.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace {

using namespace vug;
using vug::test::host_copy;
using vug::test::nearly_free;

constexpr double l = 2e-3;  // m

/// I = m l^2 / 9, its far corners at sqrt(5)/3 l from the centroid.
const Assembly lone = test::right_triangle(l);

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
