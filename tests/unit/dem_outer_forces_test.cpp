// Stress of triangles at the sides of the rock: what pushes or holds an edge counts like the bonds of the other edges.
#include "dem/mean_stress.hpp"
#include "dem_support.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <set>

namespace {

using namespace vug;
using vug::test::elastic;
using vug::test::host_copy;

constexpr double width = 0.02, height = 0.03, edge = 2e-3;
constexpr auto right = static_cast<std::size_t>(RockSide::right), top = static_cast<std::size_t>(RockSide::top),
               left = static_cast<std::size_t>(RockSide::left), bottom = static_cast<std::size_t>(RockSide::bottom);

/// On rollers at left and bottom, with these stresses on the other two sides.
Loads on_rollers(double xx = 0, double yy = 0) {
  Loads loads;
  loads.support[left] = loads.support[bottom] = Support::roller;
  loads.traction[right] = {xx, 0};
  loads.traction[top] = {0, yy};
  return loads;
}

/// A block at rest under these stresses; `jitter` of its triangles.
Mechanics pressed(double xx, double yy, double jitter) {
  Mechanics rock(test::block(width, height, edge, jitter), elastic(), on_rollers(xx, yy));
  EXPECT_TRUE(rock.preload_statically(Exec()));
  return rock;
}

Stress stress_of_all(const Mechanics& rock, bool with_sides = true) {
  std::vector<int> all(static_cast<std::size_t>(rock.particles().count));
  std::iota(all.begin(), all.end(), 0);
  return mean_stress(rock.particles(), rock.bonds(), all, with_sides ? rock.outer_moments() : ForceMoments{});
}

/// Mean over a body at rest: the sum of x (x) F over what acts on its outline, over its area. Rollers at x = 0 and
/// y = 0 add nothing to it along their normals, wherever on the side they press.
TEST(OuterForces, MakeTheMeanStressOfABlockThatOfItsSides) {
  const Mechanics rock = pressed(-5e6, -7.5e6, 0.2);
  const Stress stress = stress_of_all(rock), bonds = stress_of_all(rock, false);
  EXPECT_NEAR(stress.xx, -5e6, 1e-8 * 5e6);
  EXPECT_NEAR(stress.yy, -7.5e6, 1e-8 * 7.5e6);
  EXPECT_GT(bonds.xx, 0.97 * -5e6);  // what was missing
  EXPECT_GT(bonds.yy, 0.98 * -7.5e6);
}

/// The same where a side is held, moved by a servo or backed by rock beyond: then it is the reaction or the spring.
TEST(OuterForces, AreThoseOfSupportsAndOfTheRockBeyond) {
  Loads loads = on_rollers(0, -4e6);
  loads.support[top] = Support::servo;
  loads.stiffness[right] = 5e11;
  Mechanics rock(test::block(width, height, edge, 0.2), elastic(0.7), loads);
  Kokkos::deep_copy(rock.particles().temperature_change, 30.0);
  rock.advance(Exec(), 0.3 * rock.critical_step(), 15000);
  const Stress stress = stress_of_all(rock);
  const double spring = -rock.reaction(RockSide::left).x / height, servo = rock.reaction(RockSide::top).y / width;
  ASSERT_LT(spring, -1.9e6);
  ASSERT_NEAR(servo, -4e6, 1e-3 * 4e6);
  EXPECT_NEAR(stress.xx, spring, 1e-5 * std::abs(spring));
  EXPECT_NEAR(stress.yy, servo, 1e-5 * std::abs(servo));
}

/// A block that is held at one side and pushed along the opposite one: the mean shear stress is that of the push, sum
/// y t_x over the sides (found within 7e-7), though what keeps the held triangles from turning is in none of their
/// forces.
TEST(OuterForces, AndTheCoupleOfASupportMakeTheMeanShearStress) {
  for (const auto& [held, pushed] : {std::pair{bottom, top}, {top, bottom}, {left, right}, {right, left}}) {
    Loads loads;
    loads.support[held] = Support::fixed;
    loads.traction[pushed] = {2e6 * (pushed % 2 == 0 ? 0 : 1), 2e6 * (pushed % 2 == 0 ? 1 : 0)};
    Mechanics rock(test::block(width, height, edge, 0.2), elastic(), loads);
    ASSERT_TRUE(rock.preload_statically(Exec()));
    const double sign = pushed == top || pushed == right ? 1 : -1;
    EXPECT_NEAR(stress_of_all(rock).xy, sign * 2e6, 2e-6 * 2e6) << held;
  }
}

/// A triangle at a loaded side bears the stress of the side, not a third of it.
TEST(OuterForces, GiveTrianglesAtASideTheStressOfTheBlock) {
  const Mechanics rock = pressed(-6e6, -6e6, 0);
  const auto stress = host_copy(stress_of_triangles(Exec(), rock.particles(), rock.bonds(), rock.outer_moments()));
  const auto bonds = host_copy(stress_of_triangles(Exec(), rock.particles(), rock.bonds()));
  double worst = 0, least = -6e6;
  for (const BoundaryEdge& at : rock.boundary()) {
    const int axis = at.side % 2;
    worst = std::max(worst, std::abs(stress(at.particle, axis) + 6e6));
    least = std::max(least, bonds(at.particle, axis));
  }
  std::printf("    worst %.4f of 6 MPa, of bonds alone %.4f\n", worst / 6e6, 1 + least / 6e6);
  EXPECT_LT(worst, 0.04 * 6e6);
  EXPECT_GT(least, -0.4 * 6e6);
}

TEST(OuterForces, FollowLoadsThatChangeAndLeaveOutWhatIsGone) {
  Loads loads = on_rollers();
  SidePart part;
  part.side = RockSide::right;
  part.from = 0.2 * height;
  part.to = 0.7 * height;
  part.traction = {[](double time) { return -1e6 * (1 + time); }, [](double) { return 2e6; }};
  part.changes = true;
  loads.parts = {part};
  const Assembly block = test::block(width, height, edge, 0.2);
  Mechanics rock(block, elastic(), loads);
  const OuterForces outer(block, rock.boundary(), loads, rock.particles());
  const auto x0 = host_copy(rock.particles().x0);
  const auto sum = [&](double time) {
    const auto m = host_copy(outer.moments(rock.particles(), time));
    Stress all;
    for (int i = 0; i < rock.particles().count; ++i) all.xx += m(i, 0), all.yy += m(i, 1), all.xy += m(i, 2);
    return all;
  };
  // sum of (X - x0) (x) F over the pieces, from the outline alone
  double xx = 0, yy = 0, xy = 0;
  std::set<int> pushed;
  for (const BoundaryEdge& at : rock.boundary()) {
    if (at.side != static_cast<int>(RockSide::right)) continue;
    const double a = std::min(block.vertices[at.vertex[0]][1], block.vertices[at.vertex[1]][1]);
    const double b = std::max(block.vertices[at.vertex[0]][1], block.vertices[at.vertex[1]][1]);
    const double low = std::max(a, part.from), high = std::min(b, part.to);
    if (!(low < high)) continue;
    pushed.insert(at.particle);
    const double r_x = width - x0(at.particle, 0), r_y = 0.5 * (low + high) - x0(at.particle, 1), l = high - low;
    xx += r_x * l * -1e6;
    yy += r_y * l * 2e6;
    xy += 0.5 * l * (r_x * 2e6 + r_y * -1e6);
  }
  ASSERT_GT(pushed.size(), 4);
  EXPECT_NEAR(sum(0).xx, xx, 1e-9 * std::abs(xx));
  EXPECT_NEAR(sum(0).yy, yy, 1e-9 * std::abs(xx));
  EXPECT_NEAR(sum(0).xy, xy, 1e-9 * std::abs(xx));
  EXPECT_NEAR(sum(3).xx, 4 * xx, 4e-9 * std::abs(xx));
  const auto fraction = host_copy(rock.particles().solid_fraction);
  for (const int i : pushed) fraction(i) = 0;
  Kokkos::deep_copy(rock.particles().solid_fraction, fraction);
  EXPECT_EQ(sum(3).xx, 0);
  EXPECT_EQ(sum(3).xy, 0);
}

}  // namespace
