// Loads in the corners of the rock: each face bears what presses the side that it faces, and nothing else.
#include "dem_support.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace {

using namespace vug;
using vug::test::host_copy;
using vug::test::nearly_free;

constexpr double width = 0.02, height = 0.01;  // m

/// A rectangle with a small right triangle, of legs s, in each of its corners.
Assembly with_small_corners(double s) {
  return {{{s, 0},
           {width - s, 0},
           {width, s},
           {width, height - s},
           {width - s, height},
           {s, height},
           {0, height - s},
           {0, s},
           {width, 0},
           {width, height},
           {0, height},
           {0, 0},
           {width / 2, height / 2}},
          {{12, 0, 1},
           {12, 1, 2},
           {12, 2, 3},
           {12, 3, 4},
           {12, 4, 5},
           {12, 5, 6},
           {12, 6, 7},
           {12, 7, 0},
           {1, 8, 2},
           {3, 9, 4},
           {5, 10, 6},
           {7, 11, 0}},
          {}};
}

/// Force of all loads, and their moment about the origin, per m of thickness.
struct Resultant {
  double x = 0, y = 0, moment = 0;
  Resultant(const Assembly& assembly, const Loads& loads) {
    const Particles particles = make_particles(assembly, nearly_free());
    const BoundaryLoads applied = apply_loads(assembly, find_boundary(assembly), loads, particles);
    const auto force = host_copy(applied.force), about_centroid = host_copy(applied.moment);
    const auto x0 = host_copy(particles.x0);
    for (int i = 0; i < particles.count; ++i) {
      x += force(i, 0);
      y += force(i, 1);
      moment += x0(i, 0) * force(i, 1) - x0(i, 1) * force(i, 0) + about_centroid(i, 0);
    }
  }
};

/// Legs within the tolerance of both sides of a corner, and far beyond it.
constexpr double legs[] = {1e-12, 5e-9, 1e-3};

TEST(CornersOfTheRock, TakeThePressureOfEachSideOnItsLength) {
  constexpr double normal = 3e6, shear = 1e6;  // Pa
  for (const double s : legs)
    for (const RockSide side : {RockSide::right, RockSide::top, RockSide::left, RockSide::bottom})
      for (const bool as_part : {false, true}) {
        const auto n = static_cast<std::size_t>(side);
        const bool upright = n % 2 == 0;
        const std::array<double, 2> stress = upright ? std::array{normal, shear} : std::array{shear, normal};
        Loads loads;
        if (as_part) {
          SidePart part{side, -1, 1, Support::free, {}, 0, {}, false};
          for (std::size_t axis = 0; axis < 2; ++axis) part.traction[axis] = [=](double) { return stress[axis]; };
          loads.parts.push_back(part);
        } else {
          loads.traction[n] = stress;
        }
        const Resultant sum(with_small_corners(s), loads);
        const double length = upright ? height : width;
        EXPECT_NEAR(sum.x / (stress[0] * length), 1, 1e-14) << s << " side " << n << as_part;
        EXPECT_NEAR(sum.y / (stress[1] * length), 1, 1e-14) << s << " side " << n << as_part;
      }
}

TEST(CornersOfTheRock, LeaveUniformPressureInBalance) {
  constexpr double pressure = 5e6;
  Loads loads;
  loads.traction = {{{-pressure, 0}, {0, -pressure}, {pressure, 0}, {0, pressure}}};
  for (const double s : legs) {
    const Resultant sum(with_small_corners(s), loads);
    EXPECT_NEAR(sum.x, 0, 1e-13 * pressure * height) << s;
    EXPECT_NEAR(sum.y, 0, 1e-13 * pressure * width) << s;
    EXPECT_NEAR(sum.moment, 0, 1e-13 * pressure * width * height) << s;
  }
}

/// The bottom rim is off its line by rounding: its length along the side counts, not that of the zigzag.
TEST(CornersOfTheRock, CountLengthsAlongTheSide) {
  const Assembly rough{
      {{0, 0}, {width / 2, 1e-8}, {width, 0}, {width, height}, {0, height}}, {{0, 1, 4}, {1, 3, 4}, {1, 2, 3}}, {}};
  Loads loads;
  loads.traction[static_cast<std::size_t>(RockSide::bottom)] = {0, 2e6};
  EXPECT_NEAR(Resultant(rough, loads).y / (2e6 * width), 1, 1e-15);
}

/// A corner that is cut off within the tolerance of both sides belongs to the side that the cut faces more.
TEST(CornersOfTheRock, BelongToTheSideThatTheyFaceMore) {
  const double s = 1e-9;
  for (const auto& [across, down, side] : {std::tuple{s, 3 * s, RockSide::right}, {3 * s, s, RockSide::top}}) {
    const Assembly cut{{{0, 0}, {width, 0}, {width, height - down}, {width - across, height}, {0, height}},
                       {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}},
                       {}};
    for (const BoundaryEdge& edge : find_boundary(cut))
      if (edge.vertex == std::array{2, 3}) {
        EXPECT_EQ(edge.side, static_cast<int>(side));
      }
  }
}

/// A sliver along the right side, parted from the rest: its other face looks into the rock, however close it is.
TEST(CornersOfTheRock, HaveNoFacesThatLookInwards) {
  const double thin = 1e-9;
  const Assembly parted{{{0, 0}, {width - thin, 0}, {0, height}, {width - thin, 0}, {width, 0}, {width - thin, height}},
                        {{0, 1, 2}, {3, 4, 5}},
                        {}};
  for (const BoundaryEdge& edge : find_boundary(parted))
    if (edge.vertex == std::array{5, 3}) {
      EXPECT_EQ(edge.side, -1);
    } else if (edge.vertex == std::array{4, 5}) {
      EXPECT_EQ(edge.side, static_cast<int>(RockSide::right));
    }
}

/// A triangle in the corner of two glued platens moves with each along its normal, in whatever order they are given.
TEST(CornersOfTheRock, MoveWithTheSideWhoseNormalItIs) {
  const Assembly lone = test::right_triangle(2e-3);  // its corner is between left and bottom
  const auto left = static_cast<std::size_t>(RockSide::left), bottom = static_cast<std::size_t>(RockSide::bottom);
  for (const std::array<int, 3>& order : {std::array{0, 1, 2}, {1, 2, 0}, {2, 0, 1}}) {
    Assembly turned = lone;
    turned.triangles = {order};
    Loads steady, timed;
    steady.support[left] = steady.support[bottom] = Support::fixed;
    steady.velocity[left] = {3, 4};
    steady.velocity[bottom] = {5, 6};
    for (const auto& [side, vx, vy] : {std::tuple{RockSide::left, 3.0, 4.0}, {RockSide::bottom, 5.0, 6.0}}) {
      SidePart part{side, -1, 1, Support::fixed, {}, 0, {}, false};
      part.velocity = {[v = vx](double) { return v; }, [v = vy](double) { return v; }};
      timed.parts.push_back(part);
    }
    for (const Loads& loads : {steady, timed}) {
      Mechanics rock(turned, nearly_free(), loads);
      rock.advance(Exec(), 1e-9, 1);
      const auto v = host_copy(rock.particles().v);
      EXPECT_EQ(v(0, 0), 3) << order[0] << (loads.parts.empty() ? " steady" : " timed");
      EXPECT_EQ(v(0, 1), 6) << order[0] << (loads.parts.empty() ? " steady" : " timed");
    }
  }
}

}  // namespace
