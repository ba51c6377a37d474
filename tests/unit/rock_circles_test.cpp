// Generated rock where circles cross its sides, notches and each other: it has a corner at each crossing, no triangle
// lies across an outline, and what cannot be meshed is refused with its place.
#include "base/require.hpp"
#include "io/assembly_quality.hpp"
#include "io/rock_generator.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <string>
#include <vector>

namespace vug {
namespace {

using std::numbers::pi;
using testing::AllOf;
using testing::HasSubstr;

using Point = std::array<double, 2>;

constexpr double length_x = 0.1, length_y = 0.07, element = 0.002;

RockSection rock_of(std::uint64_t seed) {
  RockSection rock;
  rock.element_size = element;
  rock.seed = seed;
  return rock;
}

double distance(const Point& a, const Point& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1]);
}

/// Sides that an arc of so many radians gets: none longer than 1.25 elements, and at least eight in a turn.
double sides_of(double radius, double arc) {
  return std::ceil(std::max(radius * arc / element - 0.25, 8 * arc / (2 * pi)) - 1e-9);
}

/// Area of the triangles from the centre of a circle to the even sides of an arc.
double fan(double radius, double arc) {
  const double n = sides_of(radius, arc);
  return n * radius * radius / 2 * std::sin(arc / n);
}

/// Vertices on a circle; none may be inside.
int on_rim(const Assembly& assembly, const Disc& disc) {
  int rim = 0;
  for (const Point& v : assembly.vertices) {
    const double r = distance(v, disc.centre);
    EXPECT_GE(r, disc.radius * (1 - 1e-12)) << v[0] << ' ' << v[1];
    rim += r < disc.radius * (1 + 1e-12);
  }
  return rim;
}

void expect_corner(const Assembly& assembly, const Point& corner) {
  const bool there = std::any_of(assembly.vertices.begin(), assembly.vertices.end(),
                                 [&](const Point& v) { return distance(v, corner) < 1e-15; });
  EXPECT_TRUE(there) << corner[0] << ' ' << corner[1];
}

/// Arcs are divided evenly but for 1e-3 of a side, which changes an area by the square of that.
constexpr double uneven = 1e-6;

/// Centres inside and outside the rock, so that the angle between the side and the circle is 30 to 150 degrees.
TEST(RockCircles, CutASideWhereTheyCrossIt) {
  std::uint64_t seed = 0;
  for (double degrees = 30; degrees <= 150; degrees += 12) {
    const double radius = 0.0083 + 1e-4 * degrees / 3, beyond = radius * std::cos(degrees * pi / 180);
    const Disc disc{{length_x + beyond, 0.031}, radius};
    RockSection rock = rock_of(++seed);
    rock.holes = {disc};
    const Assembly assembly = generate_rock(length_x, length_y, rock);
    const auto quality = assembly_quality(assembly);
    const double half = std::acos(beyond / radius), height = radius * std::sin(half);
    EXPECT_NEAR(length_x * length_y - quality.area, fan(radius, 2 * half) - beyond * height, uneven * radius * radius)
        << degrees;
    EXPECT_EQ(on_rim(assembly, disc), sides_of(radius, 2 * half) + 1);
    for (const double y : {0.031 - height, 0.031 + height}) expect_corner(assembly, {length_x, y});
    EXPECT_GE(quality.min_angle, 20) << degrees;
    EXPECT_EQ(quality.islands, 1);
  }
}

TEST(RockCircles, CrossEachOther) {
  std::uint64_t seed = 0;
  for (double degrees = 30; degrees <= 150; degrees += 12) {  // between the circles
    const double r = 0.0091, s = 0.0064, apart = std::sqrt(r * r + s * s + 2 * r * s * std::cos(degrees * pi / 180));
    const double turn = 0.3 * degrees, cosine = std::cos(turn), sine = std::sin(turn);
    const Disc a{{0.05, 0.035}, r}, b{{0.05 + apart * cosine, 0.035 + apart * sine}, s};
    RockSection rock = rock_of(++seed);
    rock.holes = {a, b};
    const Assembly assembly = generate_rock(length_x, length_y, rock);
    const auto quality = assembly_quality(assembly);
    const double foot = (apart * apart + r * r - s * s) / (2 * apart), half = std::sqrt(r * r - foot * foot);
    const double outer_a = 2 * pi - 2 * std::acos(foot / r), outer_b = 2 * pi - 2 * std::acos((apart - foot) / s);
    EXPECT_NEAR(length_x * length_y - quality.area, fan(r, outer_a) + fan(s, outer_b) + apart * half, uneven * r * r)
        << degrees;
    EXPECT_EQ(on_rim(assembly, a), sides_of(r, outer_a) + 1);
    EXPECT_EQ(on_rim(assembly, b), sides_of(s, outer_b) + 1);
    for (const double side : {-half, half})
      EXPECT_TRUE(std::any_of(assembly.vertices.begin(), assembly.vertices.end(), [&](const Point& v) {
        return distance(v, {0.05 + foot * cosine - side * sine, 0.035 + foot * sine + side * cosine}) < 1e-12;
      }));
    EXPECT_GE(quality.min_angle, 20) << degrees;
  }
}

/// A disc that lies across the top, with a notch through it: triangles are inside or outside, and the notch is whole.
TEST(RockCircles, OfMaterialsAreCrossedBySidesAndNotches) {
  const double radius = 0.012, below = 0.005;
  const Disc disc{{0.05, length_y - below}, radius};
  RockSection rock = rock_of(4);
  rock.borders = {disc};
  rock.notches = {{{0.03, 0.059}, {0.07, 0.062}}};
  const Assembly assembly = generate_rock(length_x, length_y, rock);
  double inside = 0;
  for (const auto& t : assembly.triangles) {
    int within = 0, outside = 0;
    for (const int v : t) {
      const double r = distance(assembly.vertices[v], disc.centre);
      within += r < radius * (1 - 1e-12);
      outside += r > radius * (1 + 1e-12);
    }
    EXPECT_TRUE(within == 0 || outside == 0);
    Point centre{0, 0};
    for (const int v : t)
      for (int axis = 0; axis < 2; ++axis) centre[axis] += assembly.vertices[v][axis] / 3;
    if (distance(centre, disc.centre) > radius) continue;
    const auto &a = assembly.vertices[t[0]], &b = assembly.vertices[t[1]], &c = assembly.vertices[t[2]];
    inside += ((b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1])) / 2;
  }
  // the arcs between the crossings with the top and the notch, from right to left
  const double along = std::hypot(0.04, 0.003), depth = (0.04 * (disc.centre[1] - 0.059) - 0.003 * 0.02) / along;
  const double tilt = std::atan2(0.003, 0.04), half_notch = std::acos(depth / radius);
  const double top = std::acos(below / radius), to_notch = pi / 2 - half_notch;  // from the axis of each
  const double right = to_notch - tilt + (pi / 2 - top), left = to_notch + tilt + (pi / 2 - top);
  EXPECT_NEAR(inside,
              fan(radius, 2 * half_notch) + fan(radius, right) + fan(radius, left) + below * radius * std::sin(top),
              uneven * radius * radius);
  double crack = 0;
  for (const auto& [a, b] : assembly.initial_cracks) crack += distance(assembly.vertices[a], assembly.vertices[b]);
  EXPECT_NEAR(crack, along, 1e-12);
  EXPECT_GE(assembly_quality(assembly).min_angle, 20);
}

/// A notch from inside a round hole begins at its rim, and one that ends just short of it goes on to the rim.
TEST(RockCircles, AreMetByNotchesAtTheRim) {
  const Disc disc{{0.03, 0.035}, 0.0085};
  for (const double begin : {0.004, 0.0085, 0.0092}) {  // from the centre
    RockSection rock = rock_of(9);
    rock.holes = {disc};
    const Point along{std::cos(0.37), std::sin(0.37)};
    const auto at = [&](double r) { return Point{0.03 + r * along[0], 0.035 + r * along[1]}; };
    rock.notches = {{at(begin), at(0.02)}};
    const Assembly assembly = generate_rock(length_x, length_y, rock);
    double crack = 0;
    for (const auto& [a, b] : assembly.initial_cracks) crack += distance(assembly.vertices[a], assembly.vertices[b]);
    EXPECT_NEAR(crack, 0.02 - 0.0085, 1e-12) << begin;
    EXPECT_EQ(on_rim(assembly, disc), sides_of(0.0085, 2 * pi)) << begin;
    EXPECT_GE(assembly_quality(assembly).min_angle, 20) << begin;
  }
}

/// The message of a refusal.
std::string refusal(const RockSection& rock) {
  try {
    generate_rock(length_x, length_y, rock);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(RockRefusals, NameThePlaceAndTheShapesThere) {
  RockSection rock = rock_of(3);
  rock.holes = {Disc{{0.02, 0.02}, 0.006}, Disc{{0.05, 0.0598}, 0.01}};  // 0.2 mm below the top
  const std::string told = refusal(rock);
  EXPECT_THAT(told,
              AllOf(HasSubstr("degrees, at least 20 is needed"), HasSubstr("the top side"), HasSubstr("rock.holes.1"),
                    HasSubstr("; move them apart"), HasSubstr("rock.element_size (now 0.002 m)")));
  Point place{};
  const auto at = told.find("at x = ");
  ASSERT_NE(at, std::string::npos);
  ASSERT_EQ(std::sscanf(told.c_str() + at, "at x = %lf m, y = %lf m", &place[0], &place[1]), 2);
  EXPECT_LT(distance(place, {0.05, length_y}), element);
  EXPECT_THAT(told, testing::Not(HasSubstr("rock.holes.0")));
  rock = rock_of(3);
  rock.notches = {{{0.02, 0.02}, {0.06, 0.05}, 3, {}, 0}, {{0.02, 0.02}, {0.06, 0.053}, 3, {}, 1}};  // 2.6 degrees
  EXPECT_THAT(refusal(rock), AllOf(HasSubstr("rock.notches.0"), HasSubstr("rock.notches.1"), HasSubstr("wider angle")));
  rock = rock_of(3);
  rock.holes = {Disc{{0.03, 0.03}, 0.0002}};
  EXPECT_THAT(refusal(rock), HasSubstr("at rock.holes.0; make its narrow parts and sharp corners wider"));
  rock.holes = {Rectangle{{0.05, -0.01}, {0.06, 0.08}}};
  EXPECT_THAT(refusal(rock), HasSubstr("the shapes cut the rock into 2 pieces, one at x = "));
  rock.holes = {Rectangle{{-0.05, -0.01}, {0.2, 0.08}}};
  EXPECT_THAT(refusal(rock), HasSubstr("the rock has no triangles; make the holes smaller"));
}

/// A corner of a rectangle looks out of a disc by a quarter of an element. The message names smaller elements, and with
/// these there is a mesh; in a corner of 2.6 degrees none are small enough.
TEST(RockRefusals, NameElementsThatAreSmallEnough) {
  RockSection rock = rock_of(3);
  rock.holes = {Rectangle{{0.02, 0.02}, {0.05, 0.0402}}, Disc{{0.048, 0.034}, 0.006}};
  const std::string told = refusal(rock), before = "lower rock.element_size (now 0.002 m) to ";
  const auto at = told.find(before);
  ASSERT_NE(at, std::string::npos) << told;
  rock.element_size = std::stod(told.substr(at + before.size()));
  EXPECT_LT(rock.element_size, element);
  EXPECT_EQ(refusal(rock), "");
  rock = rock_of(3);
  rock.notches = {{{0.02, 0.02}, {0.06, 0.05}, 3, {}, 0}, {{0.02, 0.02}, {0.06, 0.053}, 3, {}, 1}};
  EXPECT_THAT(refusal(rock), HasSubstr("lower rock.element_size (now 0.002 m) below 0.0007 m"));
}

}  // namespace
}  // namespace vug
