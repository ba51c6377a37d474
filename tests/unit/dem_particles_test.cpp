#include "base/require.hpp"
#include "dem/mechanics.hpp"
#include "dem_support.hpp"
#include "host/interruption.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <csignal>

namespace {

using namespace vug;
using vug::test::host_copy;

TEST(SpheroTriangle, HasTheMassAndInertiaOfItsSharpTriangle) {
  const double l = 2e-3;
  const Triangle t{{{0, 0}, {l, 0}, {l / 2, l * std::sqrt(3.0) / 2}}};
  EXPECT_NEAR(t.area(), l * l * std::sqrt(3.0) / 4, 1e-15 * l * l);
  EXPECT_NEAR(t.gyration_squared(), l * l / 12, 1e-15 * l * l);  // equilateral: I = m l^2 / 12
  EXPECT_NEAR(t.inradius(), l / (2 * std::sqrt(3.0)), 1e-15 * l);
}

TEST(SpheroTriangle, ErodedEdgesLieOneRadiusInside) {
  const Triangle t{{{0, 0}, {3e-3, 0}, {1e-3, 2e-3}}};
  const double radius = 0.2e-3;
  const Triangle inner{{t.eroded_corner(0, radius), t.eroded_corner(1, radius), t.eroded_corner(2, radius)}};
  for (int k = 0; k < 3; ++k) {
    const Vec2 edge = t.corner[(k + 1) % 3] - t.corner[k];
    for (const int c : {k, (k + 1) % 3}) {
      EXPECT_NEAR(cross(edge, inner.corner[c] - t.corner[k]) / norm(edge), radius, 1e-12 * radius);
    }
  }
}

/// An eroded outline has the shape of its triangle, smaller by the radius over the inradius.
TEST(SpheroTriangle, IsAsRoundAsItIsTold) {
  const double l = 2e-3, inradius = l / (2 * std::sqrt(3.0));
  MechanicsParameters parameters;
  for (const double factor : {0.1, 0.4}) {
    parameters.contact.radius_factor = factor;
    const Particles p = make_particles(test::pair_of_triangles(l), parameters);
    EXPECT_NEAR(p.radius, factor * inradius, 1e-12 * inradius);
    const auto eroded = host_copy(p.eroded);
    EXPECT_NEAR(std::hypot(eroded(1, 2, 0), eroded(1, 2, 1)), (1 - factor) * 2 * inradius, 1e-12 * inradius);
  }
}

TEST(Rotation, KeepsTheDigitsOfTinyAngles) {
  const Rotation q = Rotation::by(1e-9);
  EXPECT_DOUBLE_EQ(q.cos_minus_1, -0.5e-18);
  EXPECT_DOUBLE_EQ(q.sin, 1e-9);
}

TEST(Rotation, AgreesWithTheLibraryAtAnyAngle) {
  for (double angle = -20; angle < 20; angle += 0.0137) {
    const Rotation q = Rotation::by(angle);
    const double last_digit = 4e-15;  // the distance of neighbouring doubles at the largest angle
    EXPECT_NEAR(q.sin, std::sin(angle), last_digit) << angle;
    EXPECT_NEAR(1 + q.cos_minus_1, std::cos(angle), last_digit) << angle;
  }
}

/// A dead load keeps its direction and its place on the triangle: its torque is that of the lever arm turned along.
TEST(DeadLoad, TurnsATriangleByTheLeverArmThatTurnsWithIt) {
  const double l = 2e-3, dt = 1e-9;
  Loads loads;
  loads.traction[static_cast<int>(RockSide::left)] = {3e6, -1e6};  // Pa, on the edge of length l
  for (const double angle : {0.0, 0.7, -2.0}) {
    Mechanics rock({{{0, 0}, {l, 0}, {0, l}}, {{0, 1, 2}}, {}}, {}, loads);
    test::place(rock.particles(), 0, 0, 0, angle);
    rock.advance(Exec(), dt, 1);
    const double arm_x = -l / 3, arm_y = l / 2 - l / 3;  // from the centroid to the middle of the edge
    const double x = std::cos(angle) * arm_x - std::sin(angle) * arm_y;
    const double y = std::sin(angle) * arm_x + std::cos(angle) * arm_y;
    const double torque = l * (x * -1e6 - y * 3e6);                          // N m per m
    const double inertia = host_copy(rock.particles().mass)(0) * l * l / 9;  // of a right isosceles triangle
    EXPECT_NEAR(host_copy(rock.particles().spin)(0) / (dt * torque / inertia), 1, 1e-9) << angle;
  }
}

TEST(Bonds, KnowTheirEdgeFromBothSides) {
  const double l = 2e-3;
  const Assembly assembly = test::pair_of_triangles(l);
  const Particles particles = make_particles(assembly, {});
  const Bonds bonds = make_bonds(assembly, particles, {});
  ASSERT_EQ(bonds.count, 1);
  EXPECT_NEAR(host_copy(bonds.length)(0), l, 1e-18);
  EXPECT_NEAR(host_copy(bonds.spacing)(0), l / std::sqrt(3.0), 1e-15 * l);
  EXPECT_NEAR(host_copy(bonds.normal)(0, 0), 1, 1e-15);
  const auto arm = host_copy(bonds.arm);
  const auto x0 = host_copy(particles.x0);
  for (int s = 0; s < 2; ++s) {
    for (int axis = 0; axis < 2; ++axis) {
      EXPECT_NEAR(x0(0, axis) + arm(0, s, 0, axis), x0(1, axis) + arm(0, s, 1, axis), 1e-18);
    }
  }
}

TEST(Bonds, RefuseAnAssemblyThatIsNoTriangulation) {
  Assembly clockwise{{{0, 0}, {1, 0}, {0, 1}}, {{0, 2, 1}}, {}};
  EXPECT_THROW(make_particles(clockwise, {}), InputError);
  Assembly missing{{{0, 0}, {1, 0}, {0, 1}}, {{0, 1, 3}}, {}};
  EXPECT_THROW(make_particles(missing, {}), InputError);
  Assembly overlapping{{{0, 0}, {1, 0}, {0, 1}, {1, 1}}, {{0, 1, 2}, {0, 1, 3}}, {}};
  EXPECT_THROW(make_bonds(overlapping, make_particles(overlapping, {}), {}), InputError);
  Assembly crack_outside = test::pair_of_triangles(1);
  crack_outside.initial_cracks = {{0, 2}};
  EXPECT_THROW(make_bonds(crack_outside, make_particles(crack_outside, {}), {}), InputError);
}

TEST(Loads, FindTheFourSidesOfABlock) {
  const Assembly assembly = test::block(0.03, 0.02, 2e-3, 0.2);
  std::array<double, 4> length{};
  for (const BoundaryEdge& edge : find_boundary(assembly)) {
    ASSERT_GE(edge.side, 0);
    const auto &p = assembly.vertices[static_cast<std::size_t>(edge.vertex[0])],
               &q = assembly.vertices[static_cast<std::size_t>(edge.vertex[1])];
    length[static_cast<std::size_t>(edge.side)] += std::hypot(q[0] - p[0], q[1] - p[1]);
  }
  EXPECT_NEAR(length[0], 0.02, 1e-12);
  EXPECT_NEAR(length[1], 0.03, 1e-12);
  EXPECT_NEAR(length[2], 0.02, 1e-12);
  EXPECT_NEAR(length[3], 0.03, 1e-12);
}

TEST(MechanicsParameters, OutsideTheirRangeAreRefusedByName) {
  MechanicsParameters p;
  p.bond.normal_modulus = -1;
  EXPECT_THROW(Mechanics(test::pair_of_triangles(1e-3), p, {}), InputError);
  p = {};
  p.mass_scaling = 0.5;
  EXPECT_THROW(Mechanics(test::pair_of_triangles(1e-3), p, {}), InputError);
}

/// A long series of sub-steps looks at requests to stop; one that soon ends does so first, and the run is saved.
TEST(SubSteps, OfALongSeriesEndWhenTheRunIsToStop) {
  Mechanics rock(test::right_triangle(2e-3), test::nearly_free(), Loads{});
  const double dt = 0.1 * rock.critical_step();
  request_stop(SIGTERM);
  EXPECT_NO_THROW(rock.advance(Exec(), dt, 1000));
  EXPECT_NO_THROW(rock.advance(Exec(), dt, 150000));
  EXPECT_EQ(rock.steps(), 151000);
  EXPECT_THROW(rock.advance(Exec(), dt, 2000000000), Interrupted);
  request_stop(0);
  EXPECT_LT(rock.steps(), 300000);
}

}  // namespace
