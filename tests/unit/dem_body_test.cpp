// A triangle or two against formulas by hand: the critical step, the stress of a triangle, a crack that was there.
#include "dem/mean_stress.hpp"
#include "dem_support.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

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
      // (u_n), and (u_t, rho angle) with the lever arm of the normal springs along the edge
      const double a = k_t, b = k_t * arm / rho, c = (k_n + k_t) * arm * arm / (rho * rho);
      const double largest = std::max(k_n, 0.5 * (a + c) + std::hypot(0.5 * (a - c), b));
      for (const double angle : {0.0, 0.5}) {
        const Mechanics rock(turned_pair(angle), p, {});
        Kokkos::deep_copy(rock.bonds().d_c, d_c);
        EXPECT_NEAR(rock.critical_step() / step_of(2 * largest, m), 1, 1e-6) << softened << d_c << angle;
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

}  // namespace
