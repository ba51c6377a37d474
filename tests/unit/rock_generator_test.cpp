// The generated rock: tiles exactly, has no needles, is the same for a seed, and contains its notches.
#include "io/rock_generator.hpp"

#include "base/require.hpp"
#include "io/assembly_quality.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace vug {
namespace {

using ::testing::HasSubstr;

constexpr double length_x = 0.1, length_y = 0.07;

RockSection uniform_rock(std::uint64_t seed) {
  RockSection rock;
  rock.element_size = 0.002;
  rock.seed = seed;
  return rock;
}

RockSection rock_with_hole_and_notches(std::uint64_t seed) {
  RockSection rock = uniform_rock(seed);
  rock.hole = InjectionHole{{0, 0.033}, {0.006, 0.037}};
  rock.notches.push_back({{0.006, 0.035}, {0.016, 0.0352}});
  rock.notches.push_back({{0.04, 0.02}, {0.06, 0.05}});
  return rock;
}

std::map<std::array<int, 2>, int> edge_uses(const Assembly& assembly) {
  std::map<std::array<int, 2>, int> uses;
  for (const auto& t : assembly.triangles)
    for (int k = 0; k < 3; ++k) ++uses[{std::min(t[k], t[(k + 1) % 3]), std::max(t[k], t[(k + 1) % 3])}];
  return uses;
}

double length_of_cracks(const Assembly& assembly) {
  double length = 0;
  for (const auto& [a, b] : assembly.initial_cracks)
    length += std::hypot(assembly.vertices[a][0] - assembly.vertices[b][0],
                         assembly.vertices[a][1] - assembly.vertices[b][1]);
  return length;
}

// FNV-1a over the bits of everything in the assembly.
std::uint64_t bits(const Assembly& assembly) {
  std::uint64_t hash = 0xcbf29ce484222325u;
  const auto add = [&hash](const void* data, std::size_t size) {
    for (std::size_t i = 0; i < size; ++i) hash = (hash ^ static_cast<const unsigned char*>(data)[i]) * 0x100000001b3u;
  };
  for (const auto& v : assembly.vertices) add(v.data(), sizeof(v));
  for (const auto& t : assembly.triangles) add(t.data(), sizeof(t));
  for (const auto& c : assembly.initial_cracks) add(c.data(), sizeof(c));
  return hash;
}

TEST(RockGenerator, TilesTheRectangleExactly) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const auto quality = assembly_quality(generate_rock(length_x, length_y, uniform_rock(seed)));
    // a sum of 4000 areas, each rounded to 1e-16 of itself
    EXPECT_NEAR(quality.area / (length_x * length_y), 1, 1e-13);
    EXPECT_EQ(quality.overused_edges, 0);
    EXPECT_EQ(quality.inverted_triangles, 0);
    EXPECT_EQ(quality.islands, 1);
  }
}

TEST(RockGenerator, LeavesTheHoleEmpty) {
  const auto assembly = generate_rock(length_x, length_y, rock_with_hole_and_notches(3));
  EXPECT_NEAR(assembly_quality(assembly).area, length_x * length_y - 0.006 * 0.004, 1e-15);
  for (const auto& v : assembly.vertices)
    EXPECT_FALSE(v[0] < 0.006 - 1e-9 && v[1] > 0.033 + 1e-9 && v[1] < 0.037 - 1e-9) << v[0] << ' ' << v[1];
}

TEST(RockGenerator, KeepsAnglesAndAreasInBounds) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const auto quality = assembly_quality(generate_rock(length_x, length_y, rock_with_hole_and_notches(seed)));
    EXPECT_GE(quality.min_angle, 20);
    EXPECT_GE(quality.min_area_share, 0.2);
    EXPECT_NEAR(quality.mean_edge / 0.002, 1, 0.02) << "element_size is the mean edge";
  }
}

TEST(RockGenerator, SharesEveryInnerEdgeByTwoTriangles) {
  const auto assembly = generate_rock(length_x, length_y, rock_with_hole_and_notches(1));
  const auto on_rim = [](const std::array<double, 2>& p) {
    const bool side = p[0] == 0 || p[1] == 0 || p[0] == length_x || p[1] == length_y;
    return side || (p[0] <= 0.006 && p[1] >= 0.033 && p[1] <= 0.037);
  };
  for (const auto& [edge, uses] : edge_uses(assembly)) {
    EXPECT_LE(uses, 2);
    if (uses == 1) {
      EXPECT_TRUE(on_rim(assembly.vertices[edge[0]]) && on_rim(assembly.vertices[edge[1]]));
    }
  }
}

TEST(RockGenerator, ContainsTheNotchesAsChainsOfEdges) {
  const auto assembly = generate_rock(length_x, length_y, rock_with_hole_and_notches(7));
  const auto uses = edge_uses(assembly);
  for (const auto& crack : assembly.initial_cracks) {
    EXPECT_LT(crack[0], crack[1]);
    ASSERT_TRUE(uses.contains(crack));
    EXPECT_EQ(uses.at(crack), 2) << "rock on both sides of a crack";
  }
  EXPECT_NEAR(length_of_cracks(assembly), std::hypot(0.01, 0.0002) + std::hypot(0.02, 0.03), 1e-12);
}

TEST(RockGenerator, GivesTheSameBitsForASeedAndOthersForAnother) {
  const auto first = bits(generate_rock(length_x, length_y, rock_with_hole_and_notches(11)));
  EXPECT_EQ(first, bits(generate_rock(length_x, length_y, rock_with_hole_and_notches(11))));
  EXPECT_NE(first, bits(generate_rock(length_x, length_y, rock_with_hole_and_notches(12))));
}

TEST(RockGenerator, GradesFromTheHoleOutwards) {
  auto rock = rock_with_hole_and_notches(1);
  rock.grading = 4;
  const auto assembly = generate_rock(length_x, length_y, rock);
  double near = 0, far = 0;
  int near_count = 0, far_count = 0;
  for (const auto& [edge, uses] : edge_uses(assembly)) {
    const auto& p = assembly.vertices[edge[0]];
    const auto& q = assembly.vertices[edge[1]];
    const double length = std::hypot(q[0] - p[0], q[1] - p[1]);
    if (std::hypot(p[0] - 0.006, p[1] - 0.035) < 0.008) near += length, ++near_count;
    if (p[0] > 0.092) far += length, ++far_count;
  }
  // the means lie a little inside the two extremes, which are 4 apart
  EXPECT_GT(far / far_count, 2.8 * near / near_count);
  EXPECT_LT(far / far_count, 4 * near / near_count);
  EXPECT_NEAR(assembly_quality(assembly).mean_edge / 0.002, 1, 0.02);
}

TEST(RockGenerator, LeadsANotchUpToTheHoleItAlmostTouches) {
  auto rock = uniform_rock(5);
  rock.hole = InjectionHole{{0, 0.033}, {0.006, 0.037}};
  rock.notches.push_back({{0.0062, 0.035}, {0.02, 0.035}});
  const auto assembly = generate_rock(length_x, length_y, rock);
  const bool touches = std::any_of(assembly.initial_cracks.begin(), assembly.initial_cracks.end(), [&](const auto& c) {
    return assembly.vertices[c[0]][0] == 0.006 || assembly.vertices[c[1]][0] == 0.006;
  });
  EXPECT_TRUE(touches);
}

/// A parting between two layers is a notch as well: along the whole joint, beyond it and along a part of it.
TEST(RockGenerator, OpensNotchesOnTheOutlineOfAMaterial) {
  for (const double begin : {0.0, 0.02, 0.05}) {
    auto rock = uniform_rock(4);
    rock.borders = {Rectangle{{0.03, 0}, {0.08, 0.03}}};
    rock.notches.push_back({{begin, 0.03}, {0.06, 0.03}});
    EXPECT_NEAR(length_of_cracks(generate_rock(length_x, length_y, rock)), 0.06 - begin, 1e-12) << begin;
  }
}

TEST(RockGenerator, DrawsOnlyTheEndsOfARowOfPointsToASide) {
  auto rock = uniform_rock(4);
  const std::array<double, 2> first{0.02, 0.0008}, low{0.04, 0.0009}, last{0.05, 0.02};
  rock.notches = {{first, {0.02, 0.02}}, {{0.02, 0.02}, low}, {low, last}};
  const auto assembly = generate_rock(length_x, length_y, rock);
  const double rows = 0.02 + std::hypot(0.02, 0.02 - low[1]) + std::hypot(0.01, 0.02 - low[1]);
  EXPECT_NEAR(length_of_cracks(assembly), rows, 1e-12);
}

/// At the rim of the hole and shorter than half an element, along a side, and along the hole.
TEST(RockGenerator, RefusesANotchOfWhichNothingIsLeft) {
  const std::vector<Notch> gone{{{0.006, 0.035}, {0.0069, 0.035}},
                                {{0.02, 0.0008}, {0.05, 0.0008}},
                                {{0.02, 0}, {0.05, 0}},
                                {{0.001, 0.0379}, {0.005, 0.0379}}};
  for (const Notch& notch : gone) {
    auto rock = rock_with_hole_and_notches(4);
    rock.notches.push_back(notch);
    rock.notches.back().entry = 2;
    try {
      generate_rock(length_x, length_y, rock);
      ADD_FAILURE() << "accepted";
    } catch (const InputError& e) {
      EXPECT_THAT(e.what(), HasSubstr("rock.notches.2: nothing is left of it"));
    }
  }
}

TEST(RockGenerator, MeshesCrossingNotchesAndHolesInCornersAndInside) {
  auto rock = uniform_rock(2);
  rock.notches = {{{0.02, 0.02}, {0.06, 0.05}}, {{0.02, 0.05}, {0.06, 0.02}}};
  EXPECT_EQ(assembly_quality(generate_rock(length_x, length_y, rock)).islands, 1);
  rock.hole = InjectionHole{{0, 0}, {0.01, 0.01}};
  EXPECT_NEAR(assembly_quality(generate_rock(length_x, length_y, rock)).area, 0.007 - 1e-4, 1e-15);
  rock.hole = InjectionHole{{0.07, 0.03}, {0.08, 0.04}};
  EXPECT_NEAR(assembly_quality(generate_rock(length_x, length_y, rock)).area, 0.007 - 1e-4, 1e-15);
}

TEST(RockGenerator, RefusesWhatCannotBeMeshed) {
  auto rock = uniform_rock(1);
  rock.element_size = 0.05;
  EXPECT_THROW(generate_rock(length_x, length_y, rock), InputError);
  rock = uniform_rock(1);
  rock.notches = {{{0.02, 0.02}, {0.06, 0.05}}, {{0.02, 0.0201}, {0.06, 0.0501}}};  // a twentieth of an element apart
  try {
    generate_rock(length_x, length_y, rock);
    FAIL() << "accepted";
  } catch (const InputError& e) {
    EXPECT_THAT(e.what(), HasSubstr("notches"));
  }
}

TEST(RockGenerator, CutsHolesOfAnyForm) {
  RockSection rock = uniform_rock(3);
  const Disc inside{{0.03, 0.035}, 0.01}, at_the_side{{0.1, 0.05}, 0.008};
  const Polygon wedge{{{0.05, 0}, {0.055, 0.02}, {0.06, 0}}};
  rock.holes = {inside, at_the_side, wedge, Rectangle{{0.07, 0.06}, {0.08, 0.075}}};
  const Assembly assembly = generate_rock(length_x, length_y, rock);
  const auto quality = assembly_quality(assembly);
  // of a circle of n corners n / 2 sin(2 pi / n) r^2; n = 32 and 24 sides of 2 mm, which are not quite alike
  const double discs = 16 * std::sin(M_PI / 16) * 1e-4 + 0.5 * 12 * std::sin(M_PI / 12) * 0.64e-4;
  EXPECT_NEAR(quality.area, length_x * length_y - discs - 0.5 * 0.01 * 0.02 - 0.01 * 0.01, 1e-3 * 5e-4);
  EXPECT_GE(quality.min_angle, 20);
  int rim = 0;
  for (const auto& [x, y] : assembly.vertices) {
    const double r = std::hypot(x - 0.03, y - 0.035);
    EXPECT_GE(r, 0.01 * (1 - 1e-12));
    rim += r < 0.01 * (1 + 1e-12);
  }
  EXPECT_EQ(rim, 32);
}

TEST(RockGenerator, FollowsTheBordersOfMaterials) {
  RockSection rock = uniform_rock(4);
  rock.borders = {Rectangle{{0, 0.0231}, {0.1, 0.0417}}};
  const Assembly assembly = generate_rock(length_x, length_y, rock);
  for (const auto& t : assembly.triangles) {
    std::set<bool> above;
    for (const int v : t)
      if (std::abs(assembly.vertices[v][1] - 0.0231) > 1e-9) above.insert(assembly.vertices[v][1] > 0.0231);
    EXPECT_EQ(above.size(), 1u);
  }
  EXPECT_TRUE(assembly.initial_cracks.empty());
}

TEST(DiscGenerator, FillsTheFlattenedCircleWithUsableTriangles) {
  constexpr double diameter = 0.05, flat = 0.174, pi = 3.14159265358979;
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const Assembly disc = generate_disc(diameter, flat, uniform_rock(seed));
    const auto quality = assembly_quality(disc);
    const double half = std::asin(flat), r = diameter / 2;
    // the circle less two segments; chords of 2 mm leave out (2 / 25)^2 / 6 = 1e-3 of a sector
    const double area = pi * r * r - r * r * (2 * half - std::sin(2 * half));
    EXPECT_NEAR(quality.area / area, 1, 2e-3);
    EXPECT_NEAR(quality.mean_edge, 0.002, 0.05 * 0.002);
    EXPECT_GE(quality.min_angle, 20);
    EXPECT_EQ(quality.islands, 1);
    for (const auto& [x, y] : disc.vertices) EXPECT_LE(std::hypot(x - r, y - r * std::cos(half)), r * (1 + 1e-12));
    double flats[2] = {0, 0};  // length of the boundary at the two platens
    for (const auto& [edge, uses] : edge_uses(disc)) {
      const auto &a = disc.vertices[edge[0]], &b = disc.vertices[edge[1]];
      if (uses == 1 && a[1] == b[1] && a[1] < 1e-9) flats[0] += std::abs(a[0] - b[0]);
      if (uses == 1 && a[1] == b[1] && a[1] > 0.049) flats[1] += std::abs(a[0] - b[0]);
    }
    EXPECT_NEAR(flats[0], flat * diameter, 1e-12);
    EXPECT_NEAR(flats[1], flat * diameter, 1e-12);
  }
  EXPECT_EQ(bits(generate_disc(diameter, flat, uniform_rock(3))), bits(generate_disc(diameter, flat, uniform_rock(3))));
  EXPECT_THROW(generate_disc(0.005, flat, uniform_rock(1)), InputError);
}

}  // namespace
}  // namespace vug
