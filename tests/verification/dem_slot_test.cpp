// Rock that faces itself touches before a bond has failed: slots that close, outlines that are not convex.
#include "dem_support.hpp"

#include <gtest/gtest.h>

#include <numbers>

namespace {

using namespace vug;
using vug::test::host_copy;

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

}  // namespace
