// Bodies that were never bonded: collision, friction, and whether every pair that touches is found.
#include "dem/closest_point.hpp"
#include "dem/edges.hpp"
#include "dem_support.hpp"

#include <gtest/gtest.h>

#include <numbers>
#include <set>

namespace {

using namespace vug;
using vug::test::host_copy;

/// Spring and dashpot that never pull (Schwager & Poeschel, Granular Matter 9 (2007) 465): the bodies part when the
/// force is zero, before the spring has its length again.
double restitution(double stiffness, double damping, double mass) {
  const double beta = damping / (2 * mass), omega = std::sqrt(stiffness / mass - beta * beta);
  return std::exp(-beta / omega * (std::numbers::pi - std::atan(2 * beta * omega / (omega * omega - beta * beta))));
}

TEST(Collision, HasTheRestitutionOfItsDashpot) {
  // a corner flies head-on at the middle of an edge; equilateral, so that no spin is made
  const double l = 2e-3, height = l * std::sqrt(3.0) / 2, gap = 1e-5;
  const Assembly assembly{{{0, 0}, {0, l}, {-height, l / 2}, {gap, l / 2}, {gap + height, 0}, {gap + height, l}},
                          {{0, 1, 2}, {3, 4, 5}},
                          {}};
  // the corner is rounded: it must fly a little further than the gap
  for (const double damping : {0.0, 1.17e3, 5e3}) {
    MechanicsParameters parameters;
    parameters.contact.normal_damping = damping;
    Mechanics rock(assembly, parameters, {});
    const auto v = host_copy(rock.particles().v);
    v(0, 0) = 1, v(1, 0) = -1;
    Kokkos::deep_copy(rock.particles().v, v);
    const double dt = 0.01 * rock.critical_step();
    rock.advance(Exec(), dt, static_cast<int>(3e-4 / dt));
    const auto after = host_copy(rock.particles().v);
    const double mass = host_copy(rock.particles().mass)(0);
    // the step resolves the contact's half period by 200 steps: end of contact known to one of them
    EXPECT_NEAR((after(1, 0) - after(0, 0)) / 2, restitution(3.73e10, damping, mass / 2), 2e-3);
    EXPECT_NEAR(after(0, 0) + after(1, 0), 0, 1e-12);
    // 0.80 by the design formula of a dashpot that may pull; one that may not returns a little more
    if (damping == 1.17e3) {
      EXPECT_NEAR((after(1, 0) - after(0, 0)) / 2, 0.80, 0.03);
    }
  }
}

/// Two points of triangles that face each other at one vertex. The right one is held; behind it is a crack, so that
/// bonds do not keep the two apart.
class TwoPoints {
 public:
  TwoPoints() : rock_(assembly(), undamped(), {}) {
    const auto held = host_copy(rock_.particles().held);
    held(0) = held(1) = 7;
    Kokkos::deep_copy(rock_.particles().held, held);
  }
  double radius() const { return rock_.particles().radius; }
  /// Angular frequency on the two springs, one for each of the two corners.
  double frequency() const { return std::sqrt(2 * undamped().contact.normal_stiffness / mass()); }
  void place(double x) { set(rock_.particles().u, x); }
  void throw_right(double speed) { set(rock_.particles().v, speed); }
  double x() const { return host_copy(rock_.particles().u)(2, 0); }
  double velocity() const { return host_copy(rock_.particles().v)(2, 0); }
  /// Advances by `time`; the furthest place to the right.
  double furthest(double time) {
    const double dt = 0.01 / frequency();
    double most = x();
    for (int step = 0; step < time / dt; ++step) {
      rock_.advance(Exec(), dt, 1);
      most = std::max(most, x());
    }
    return most;
  }

 private:
  static Assembly assembly() {
    const double l = 2e-3, half = l / std::sqrt(3.0);  // corners of 60 degrees
    return {{{0, 0}, {l, -half}, {l, half}, {2 * l, 0}, {-l, half}, {-l, -half}},
            {{0, 1, 2}, {1, 3, 2}, {0, 4, 5}},
            {{1, 2}}};
  }
  static MechanicsParameters undamped() {
    MechanicsParameters parameters;
    parameters.contact.normal_damping = 0;
    return parameters;
  }
  double mass() const { return host_copy(rock_.particles().mass)(2); }
  static void set(const VectorField<double>& field, double x) {
    const auto values = host_copy(field);
    values(2, 0) = x;
    Kokkos::deep_copy(field, values);
  }
  Mechanics rock_;
};

TEST(Overlap, ThatWasThereBeforeTheContactDoesNotPushUntilTheTwoHaveParted) {
  TwoPoints points;
  const double r = points.radius(), touching = 4 * r - 2 * r;  // corners lie R / sin(30 degrees) behind the vertex
  points.place(touching + r);
  points.furthest(1e-6);
  EXPECT_EQ(points.velocity(), 0);
  EXPECT_EQ(points.x(), touching + r);
  const double speed = 1, depth = speed / points.frequency();
  ASSERT_LT(depth, 0.1 * r);
  points.throw_right(speed);
  EXPECT_NEAR(points.furthest(2 * r / speed), touching + r + depth, 0.01 * depth);
  EXPECT_NEAR(points.velocity(), -speed, 1e-3 * speed);
  ASSERT_LT(points.x(), touching);
  points.throw_right(speed);
  EXPECT_NEAR(points.furthest(2 * r / speed), touching + depth, 0.01 * depth);
}

/// A wedge-shaped block (two bonded triangles) on a fixed base, pushed by gravity g at a slope.
class Slope {
 public:
  Slope() : rock_(assembly(), parameters(), base_fixed()), dt_(0.1 * rock_.critical_step()) {
    pull(0);
    rock_.advance(Exec(), dt_, static_cast<int>(2e-4 / dt_));  // settle on the level
  }
  void pull(double angle) {
    const auto force = host_copy(rock_.particles().force);
    const auto mass = host_copy(rock_.particles().mass);
    for (const int i : {2, 3}) {
      force(i, 0) = mass(i) * g * std::sin(angle);
      force(i, 1) = -mass(i) * g * std::cos(angle);
    }
    Kokkos::deep_copy(rock_.particles().force, force);
  }
  /// Mean velocity of the block along the slope, m/s.
  double velocity() const {
    const auto v = host_copy(rock_.particles().v);
    return 0.5 * (v(2, 0) + v(3, 0));
  }
  void run(double time) { rock_.advance(Exec(), dt_, static_cast<int>(std::lround(time / dt_))); }

  static constexpr double g = 9.81;

 private:
  static Assembly assembly() {
    return {{{0, -5e-3}, {2e-2, -5e-3}, {2e-2, 0}, {0, 0}, {8e-3, 0}, {1.2e-2, 0}, {1.2e-2, 1e-3}, {8e-3, 1e-3}},
            {{0, 1, 2}, {0, 2, 3}, {4, 5, 6}, {4, 6, 7}},
            {}};
  }
  static MechanicsParameters parameters() {
    MechanicsParameters p;
    p.contact.tangential_damping = 1e3;  // so that sticking comes to rest
    return p;
  }
  static Loads base_fixed() {
    Loads loads;
    loads.support[static_cast<std::size_t>(RockSide::bottom)] = Support::fixed;
    loads.support[static_cast<std::size_t>(RockSide::left)] = Support::fixed;
    return loads;
  }
  Mechanics rock_;
  double dt_;
};

TEST(BlockOnASlope, SticksBelowTheFrictionAngleAndSlidesAboveIt) {
  const double friction = 0.30, time = 1e-3;
  const auto velocity_at = [&](double slope) {
    Slope block;
    constexpr int tilts = 100;  // slowly: a sudden tilt would load the springs twice
    for (int k = 1; k <= tilts; ++k) {
      block.pull(slope * k / tilts);
      block.run(5e-6);
    }
    block.run(time);
    return block.velocity();
  };
  const double above = std::atan(friction * 1.001);
  const double expected = Slope::g * (std::sin(above) - friction * std::cos(above)) * time;  // 2.8e-6 m/s
  EXPECT_LT(std::abs(velocity_at(std::atan(friction * 0.999))), 0.02 * expected);
  // the last of the hundred tilts lies above the friction angle for a tenth of its share: 1 % of the time
  EXPECT_NEAR(velocity_at(above), expected, 0.05 * expected);
}

TEST(BlockOnASlope, SlidesWithTheAccelerationOfCoulomb) {
  const double slope = 25 * Kokkos::numbers::pi / 180;
  Slope block;
  block.pull(slope);
  block.run(1e-4);
  const double before = block.velocity();
  block.run(4e-4);
  const double acceleration = (block.velocity() - before) / 4e-4;
  const double expected = Slope::g * (std::sin(slope) - 0.30 * std::cos(slope));
  EXPECT_NEAR(acceleration, expected, 1e-3 * expected);
}

TEST(NeighbourGrid, FindsExactlyThePairsThatASearchOverAllFinds) {
  Assembly assembly = test::block(0.02, 0.02, 2e-3, 0.25);
  Mechanics rock(assembly, {}, {});
  const Particles& p = rock.particles();
  const double dt = 0.3 * rock.critical_step();
  Kokkos::deep_copy(rock.bonds().d_c, 1.0);  // everything falls apart
  const auto v = host_copy(p.v), x0 = host_copy(p.x0);
  for (int i = 0; i < p.count; ++i) {  // stirred: particles pass each other
    v(i, 0) = 20 * std::sin(1e3 * x0(i, 1)) + i % 3;
    v(i, 1) = -20 * (x0(i, 1) - 0.01) / 0.01;
  }
  Kokkos::deep_copy(p.v, v);
  rock.advance(Exec(), dt, 600);
  const auto joint = host_copy(rock.bonds().joint);
  const auto pair = host_copy(rock.bonds().pair);
  std::set<std::pair<int, int>> joined, listed;
  for (int k = 0; k < rock.bonds().count; ++k) {
    if (joint(k) == faces_joined) joined.insert(std::minmax(pair(k, 0), pair(k, 1)));
  }
  EXPECT_LT(joined.size(), static_cast<std::size_t>(rock.bonds().count));  // some have parted
  const Contacts& contacts = rock.contacts();
  const auto status = host_copy(contacts.status), first_all = host_copy(contacts.row);
  const auto first = host_copy(contacts.first);
  const auto other = host_copy(contacts.other);
  const int g = status(contacts_generation);
  for (int i = 0; i < p.count; ++i) {
    for (int k = first(i, g); k < first(i + 1, g); ++k) listed.insert({i, other(k, g)});
  }
  EXPECT_EQ(status(contacts_lost), 0);
  EXPECT_EQ(first_all(p.count), 2 * static_cast<int>(listed.size()));
  const auto u = host_copy(p.u), rotation = host_copy(p.rotation);
  const auto eroded = host_copy(p.eroded);
  std::vector<Triangle> outline(static_cast<std::size_t>(p.count));
  for (int i = 0; i < p.count; ++i) {
    for (int c = 0; c < 3; ++c) {
      const Rotation turn{rotation(i, 0), rotation(i, 1)};
      outline[static_cast<std::size_t>(i)].corner[c] =
          Vec2{x0(i, 0) + u(i, 0), x0(i, 1) + u(i, 1)} + turn.turn({eroded(i, c, 0), eroded(i, c, 1)});
    }
  }
  int touching = 0;
  for (int i = 0; i < p.count; ++i) {
    for (int j = i + 1; j < p.count; ++j) {
      const Triangle &a = outline[static_cast<std::size_t>(i)], &b = outline[static_cast<std::size_t>(j)];
      double distance = 1;
      for (int c = 0; c < 3; ++c) {
        distance = std::min(
            {distance, closest_on_triangle(a, b.corner[c]).distance, closest_on_triangle(b, a.corner[c]).distance});
      }
      if (distance > 2 * p.radius || joined.count({i, j})) continue;
      ++touching;
      EXPECT_TRUE(listed.count({i, j})) << i << " " << j << " at " << distance;
    }
  }
  EXPECT_GT(touching, 5);
}

TEST(Rubble, FallsOnAFloorAndStaysWhole) {
  // a pile of loose triangles with friction and dashpots loses its energy and its particles stay apart
  Assembly assembly = test::block(0.02, 0.01, 2e-3, 0.2);
  for (const Edge& edge : find_edges(assembly))
    if (edge.triangle[1] >= 0) assembly.initial_cracks.push_back(edge.vertex);
  Loads loads;
  loads.support[static_cast<std::size_t>(RockSide::bottom)] = Support::fixed;
  loads.gravity = {0, -2e4};
  MechanicsParameters parameters;
  parameters.contact.tangential_damping = 1e3;
  Mechanics rock(assembly, parameters, loads);
  const double dt = 0.3 * rock.critical_step();
  rock.advance(Exec(), dt, 20000);
  EXPECT_EQ(rock.runaway(Exec(), 30).particle, -1);
  const auto u = host_copy(rock.particles().u), x0 = host_copy(rock.particles().x0);
  const auto mass = host_copy(rock.particles().mass);
  const auto v = host_copy(rock.particles().v);
  double weight = 0, kinetic = 0;
  int on_floor = 0;
  for (int i = 0; i < rock.particles().count; ++i) {
    weight += mass(i) * 2e4;
    const double x = x0(i, 0) + u(i, 0), y = x0(i, 1) + u(i, 1);
    if (x < 0 || x > 0.02) continue;  // what rolls off the side falls
    EXPECT_GT(y, 0) << "particle " << i << " is below the floor";
    EXPECT_LT(y, 0.011) << "particle " << i << " has left the pile";
    ++on_floor;
    kinetic += 0.5 * mass(i) * (v(i, 0) * v(i, 0) + v(i, 1) * v(i, 1));
  }
  EXPECT_GT(on_floor, 0.8 * rock.particles().count);
  // of the pile, a hundredth of what a fall from its top would give
  EXPECT_LT(kinetic, 0.01 * weight * 0.01);
}

}  // namespace
