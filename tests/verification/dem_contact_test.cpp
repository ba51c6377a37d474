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

constexpr double slotted = 0.01, slot_edge = slotted / 20;

/// A square with a slot of parallel faces in its middle, in a mesh with doubled vertices: nine edges wide, or, `open`,
/// to the left side.
Assembly slotted_block(double gap, bool open = false) {
  constexpr int n = 20, middle = n / 2;
  const int first = open ? 0 : 6, last = 14;
  Assembly out;
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i <= n; ++i) {
      const bool on_face = j == middle && i >= first && i <= last;
      out.vertices.push_back({i * slot_edge, j * slot_edge - (on_face ? gap / 2 : 0)});
    }
  for (int i = first; i <= last; ++i) out.vertices.push_back({i * slot_edge, middle * slot_edge + gap / 2});
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      const auto name = [&](int column, int row) {
        return j == middle && row == middle && column >= first && column <= last ? (n + 1) * (n + 1) + column - first
                                                                                 : row * (n + 1) + column;
      };
      const int a = name(i, j), b = name(i + 1, j), c = name(i + 1, j + 1), d = name(i, j + 1);
      if ((i + j) % 2 == 1) {
        out.triangles.push_back({a, b, c});
        out.triangles.push_back({a, c, d});
      } else {
        out.triangles.push_back({a, b, d});
        out.triangles.push_back({b, c, d});
      }
    }
  return out;
}

Mechanics pressed_slot(double gap, double stress) {
  MechanicsParameters strong;
  strong.bond.normal_strength = strong.bond.cohesion = 1e10;
  Loads loads;
  loads.support[static_cast<std::size_t>(RockSide::bottom)] = Support::roller;
  loads.support[static_cast<std::size_t>(RockSide::left)] = Support::roller;
  loads.traction[static_cast<std::size_t>(RockSide::top)] = {0, -stress};
  return {slotted_block(gap), strong, loads};
}

/// Mean displacement along y of the corners that meet at a vertex.
double raised(const Particles& p, int vertex) {
  const auto u = host_copy(p.u), rotation = host_copy(p.rotation);
  const auto corner = host_copy(p.corner);
  const auto name = host_copy(p.vertex);
  double sum = 0;
  int corners = 0;
  for (int i = 0; i < p.count; ++i)
    for (int c = 0; c < 3; ++c) {
      if (name(i, c) != vertex) continue;
      sum += u(i, 1) + Rotation{rotation(i, 0), rotation(i, 1)}.move({corner(i, c, 0), corner(i, c, 1)}).y;
      ++corners;
    }
  return sum / corners;
}

/// How far the faces of the slot have come towards each other in its middle.
double closure(const Mechanics& slot) {
  return raised(slot.particles(), 10 * 21 + 10) - raised(slot.particles(), 21 * 21 + 10 - 6);
}

/// Its faces meet before a bond has failed: no further than the springs of their contacts give way to all of the
/// stress, two corners to an edge at least.
TEST(Slot, ClosesUntilItsFacesMeet) {
  const double gap = 1e-5;
  Mechanics open = pressed_slot(gap, 20e6);
  EXPECT_TRUE(open.preload_statically(Exec())) << "faces that come near without touching leave the solver alone";
  const double little = closure(open);
  EXPECT_LT(little, gap);
  EXPECT_GT(7.5 * little, 5 * gap) << "what elasticity alone would make of the stress below";
  for (const bool statically : {true, false}) {
    Mechanics shut = pressed_slot(gap, 150e6);
    if (!statically || !shut.preload_statically(Exec())) shut.preload(Exec(), 2e-5);
    EXPECT_EQ(shut.bond_counts().failed(), 0);
    const double give = 150e6 * slot_edge / (2 * shut.parameters().contact.normal_stiffness);
    EXPECT_GT(closure(shut), gap);
    EXPECT_LT(closure(shut), gap + give) << (statically ? "solved" : "waited");
  }
}

/// Faces too far apart for the search to list them, until the only increment has put them into each other.
TEST(Slot, IsNotSolvedForWhereItsFacesMeetUnseen) {
  Mechanics wide = pressed_slot(1.3e-4, 400e6);
  EXPECT_GT(1.3e-4, wide.contacts().skin);
  EXPECT_FALSE(wide.preload_statically(Exec()));
}

/// Whether contacts are awake although no bond has failed.
bool awake_from_the_start(const Assembly& assembly) {
  return host_copy(Mechanics(assembly, {}, {}).bonds().events)(bond_has_failed) != 0;
}

TEST(Outline, WakesContactsWhereRockFacesItself) {
  const double l = 1e-3;
  EXPECT_FALSE(awake_from_the_start(test::block(0.02, 0.01, l, 0.2)));
  EXPECT_FALSE(awake_from_the_start(test::pair_of_triangles(l))) << "a rhombus";
  EXPECT_FALSE(awake_from_the_start({{{0, 0}, {l, 0}, {0.5 * l, l}}, {{0, 1, 2}}, {}}));
  Assembly disc;
  for (int k = 0; k < 12; ++k) {
    const double angle = 2 * std::numbers::pi * k / 12;
    disc.vertices.push_back({l * std::cos(angle), l * std::sin(angle)});
    disc.triangles.push_back({12, k, (k + 1) % 12});
  }
  disc.vertices.push_back({0, 0});
  EXPECT_FALSE(awake_from_the_start(disc));
  disc.triangles.pop_back();
  EXPECT_TRUE(awake_from_the_start(disc)) << "a mouth";
  for (const bool open : {false, true})
    for (const double gap : {0.0, 1e-5}) EXPECT_TRUE(awake_from_the_start(slotted_block(gap, open))) << gap;
  EXPECT_TRUE(awake_from_the_start({{{0, 0}, {l, 0}, {0, l}, {0, l}, {l, 0}, {l, l}}, {{0, 1, 2}, {3, 4, 5}}, {}}))
      << "two pieces that fill their bounding box";
  EXPECT_TRUE(awake_from_the_start({{{0, 0}, {l, 0}, {0, l}, {-l, 0}, {0, -l}}, {{0, 1, 2}, {0, 3, 4}}, {}}))
      << "two pieces that touch at a corner";
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
