// Fragments: rock that nothing holds and that the fluid drives out of its place on the lattice.
#include "coupling/events.hpp"
#include "dem_support.hpp"
#include "support/coupled_run.hpp"
#include "support/nodes_of_groups.hpp"
#include "support/pickled_rock.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace vug {
namespace {

using test::pickled_rock;
using test::replaced;

/// A corner of the block is thrown off at 100 m/s, far slower than sound.
const std::vector<std::string> thrown{
    "mechanics.initial_velocity=[{ type = \"disc\", centre = [0.02, 0.014], radius = 0.0025, velocity = [80, 60] }]",
    "mechanics.bond.normal_strength=1e3",
    "mechanics.bond.cohesion=1e3",
    "mechanics.bond.fracture_energy_I=1e-3",  // fails within micrometres
    "mechanics.bond.fracture_energy_II=1e-3",
    "mechanics.fragments=let_go"};

TEST(Fragment, IsLetGoWhenItHasLeftItsPlaceAndTakesItsMomentumAlong) {
  test::CoupledRun run(pickled_rock, thrown);
  const Particles& particles = run.rock().particles();
  const auto mass = test::host_copy(particles.mass);
  const auto momentum = [&] {  // of what still moves
    const auto v = test::host_copy(particles.v);
    const auto fraction = test::host_copy(particles.solid_fraction);
    std::array<double, 2> sum{0, 0};
    for (int i = 0; i < particles.count; ++i)
      for (const int axis : {0, 1}) sum[axis] += mass(i) * std::max(0.2, fraction(i)) * v(i, axis);
    return sum;
  };
  const auto start = momentum();
  EXPECT_GT(start[0], 0);
  run.steps(2);  // 0.5 mm
  EXPECT_EQ(run.now("triangles_let_go_1"), 0);
  run.steps(60);
  const auto fraction = test::host_copy(particles.solid_fraction);
  const auto u = test::host_copy(particles.u);
  int gone = 0;
  for (int i = 0; i < particles.count; ++i) {
    const double moved = std::hypot(u(i, 0), u(i, 1)), half = 0.5 * std::sqrt(mass(i) / 2500);
    if (fraction(i) > 0) {
      EXPECT_LT(moved, 1.1 * half) << i;
    }
    if (fraction(i) == 0) {
      EXPECT_GT(moved, 0.9 * half) << i;
      EXPECT_LT(moved, half + 0.5e-3) << i;  // and there it stays: two steps of 0.25 mm on
      ++gone;
    }
  }
  EXPECT_GE(gone, 1);
  EXPECT_LE(gone, 4);
  EXPECT_EQ(run.now("triangles_let_go_1"), gone);
  EXPECT_EQ(run.now("triangles_dissolved_1"), gone);
  const auto now = momentum();
  EXPECT_NEAR((now[0] + run.now("dissolved_rock_momentum_x_N_s_per_m")) / start[0], 1, 1e-3);
  EXPECT_NEAR((now[1] + run.now("dissolved_rock_momentum_y_N_s_per_m")) / start[1], 1, 1e-3);
  EXPECT_LT(run.worst_balance(), 1e-12);
}

/// Also a triangle of which the lattice has not one solid node, all of its own being pathways.
TEST(Fragment, IsNoneWhereRockMovesALittle) {
  test::CoupledRun run(
      replaced(pickled_rock, "element_size = 3e-3\nporosity = 0", "element_size = 1e-3\nporosity = 0.5"),
      {"mechanics.initial_velocity=[{ type = \"rectangle\", from = [0, 0], to = [0.02, 0.014], velocity = [1, 1] }]",
       "mechanics.fragments=let_go"});
  const auto volume = test::host_copy(run.parts().geometry.volume);
  int without_solid = 0;
  for (const auto& nodes : test::nodes_of_groups(run.parts().rock->nodes_of_particle)) {
    double solid = 0;
    for (const int node : nodes) solid += volume(node);
    without_solid += solid == 0;
  }
  ASSERT_GT(without_solid, 0);
  run.steps(10);  // 25 micrometres
  EXPECT_EQ(run.now("triangles_let_go_1"), 0);
}

/// Bonds hold the rock together, or a moving side some of it: neither is a fragment, however far it has gone.
TEST(Fragment, IsNoneWhereSomethingHoldsIt) {
  const std::string all = "mechanics.initial_velocity=[{ type = \"rectangle\", from = [0, 0], to = [0.02, 0.014], ";
  auto whole = thrown;
  whole[0] = all + "velocity = [80, 60] }]";
  whole[1] = "mechanics.bond.normal_strength=1e13";
  whole[2] = "mechanics.bond.cohesion=1e13";
  test::CoupledRun strong(pickled_rock, whole);
  strong.steps(30);  // 7.5 mm
  EXPECT_EQ(strong.rock().bond_counts().failed_in_tension + strong.rock().bond_counts().failed_in_shear, 0);
  EXPECT_EQ(strong.now("triangles_let_go_1"), 0);
  EXPECT_EQ(strong.now("triangles_dissolved_1"), 0);

  auto carried = thrown;
  carried[0] = "boundary.right.traction={ support = \"fixed\", velocity = [100, 0] }";
  test::CoupledRun torn(pickled_rock, carried);
  torn.steps(30);
  const Bonds& bonds = torn.rock().bonds();
  const auto state = test::host_copy(bonds.state);
  const auto row = test::host_copy(bonds.row), entry = test::host_copy(bonds.entry);
  const auto held = test::host_copy(torn.rock().particles().held);
  const auto fraction = test::host_copy(torn.rock().particles().solid_fraction);
  const auto u = test::host_copy(torn.rock().particles().u);
  int bare = 0;  // held by the side alone
  for (int i = 0; i < torn.rock().particles().count; ++i) {
    if (held(i) == 0) continue;
    EXPECT_GT(u(i, 0), 5e-3);
    EXPECT_GT(fraction(i), 0.05) << i;
    bool alone = true;
    for (int e = row(i); e < row(i + 1); ++e) alone = alone && has_failed(state(entry(e) / 2));
    bare += alone;
  }
  EXPECT_GT(bare, 0);
}

/// Two triangles in the corner at the right and the top that one bond still joins fly off at `velocity`, m/s.
struct ThrownPair {
  explicit ThrownPair(std::array<double, 2> velocity) : run(pickled_rock, {"mechanics.fragments=let_go"}) {
    const Particles& particles = run.rock().particles();
    const Bonds& bonds = run.rock().bonds();
    const auto x0 = test::host_copy(particles.x0);
    const auto pair = test::host_copy(bonds.pair);
    for (int i = 1; i < particles.count; ++i)
      if (x0(i, 0) + x0(i, 1) > x0(one, 0) + x0(one, 1)) one = i;
    for (int b = 0; b < bonds.count; ++b) {
      const bool own = pair(b, 0) == one || pair(b, 1) == one;
      if (own && joint < 0) joint = b, other = pair(b, 0) == one ? pair(b, 1) : pair(b, 0);
    }
    const auto own = [&](int i) { return i == one || i == other; };
    test::edit(bonds.state, [&](const auto& state) {
      for (int b = 0; b < bonds.count; ++b)
        if (own(pair(b, 0)) != own(pair(b, 1))) state(b) = BondState::failed_in_tension;
    });
    test::edit(bonds.joint, [&](const auto& faces) {
      for (int b = 0; b < bonds.count; ++b)
        if (own(pair(b, 0)) != own(pair(b, 1))) faces(b) = faces_apart;
    });
    test::edit(particles.v, [&](const auto& v) {
      for (const int i : {one, other})
        for (const int axis : {0, 1}) v(i, axis) = velocity[axis];
    });
    const auto mass = test::host_copy(particles.mass);
    for (const int axis : {0, 1}) momentum[axis] = (mass(one) + mass(other)) * velocity[axis];
  }
  /// How far the farther one of the two is, over half its size.
  double away() const {
    const auto u = test::host_copy(run.rock().particles().u);
    const auto mass = test::host_copy(run.rock().particles().mass);
    double farthest = 0;
    for (const int i : {one, other})
      farthest = std::max(farthest, std::hypot(u(i, 0), u(i, 1)) / (0.5 * std::sqrt(mass(i) / 2500)));
    return farthest;
  }
  bool joined() const { return !has_failed(test::host_copy(run.rock().bonds().state)(joint)); }

  test::CoupledRun run;
  int one = 0, other = -1, joint = -1;
  std::array<double, 2> momentum{};
};

/// The bond between them holds: neither would ever go on its own.
TEST(Fragment, OfTwoTrianglesGoesAsAWhole) {
  ThrownPair pair({80, 60});
  while (pair.away() < 1) {
    ASSERT_TRUE(pair.joined());
    EXPECT_EQ(pair.run.now("triangles_let_go_1"), 0);
    pair.run.steps(1);
  }
  EXPECT_LT(pair.away(), 1.5);
  pair.run.steps(1);
  EXPECT_EQ(pair.run.now("triangles_let_go_1"), 2) << "both at once";
  EXPECT_EQ(pair.run.now("triangles_dissolved_1"), 2);
  const auto fraction = test::host_copy(pair.run.rock().particles().solid_fraction);
  EXPECT_EQ(fraction(pair.one), 0);
  EXPECT_EQ(fraction(pair.other), 0);
  // with all that they had; what little the rock behind them has kept is that of dashpots
  EXPECT_NEAR(pair.run.now("dissolved_rock_momentum_x_N_s_per_m") / pair.momentum[0], 1, 1e-3);
  EXPECT_NEAR(pair.run.now("dissolved_rock_momentum_y_N_s_per_m") / pair.momentum[1], 1, 1e-3);
  EXPECT_LT(pair.run.worst_balance(), 1e-12);
  pair.run.steps(50);
  EXPECT_EQ(pair.run.now("triangles_let_go_1"), 2);
}

/// Lines about what has flown off, in a run of the thrown corner.
int told(const std::string& fragments, const std::string& words) {
  auto set = thrown;
  set.back() = "mechanics.fragments=" + fragments;
  Simulation simulation(parse_scene(pickled_rock, "case.toml", set));
  simulation.begin();
  Events events(simulation);
  int count = 0;
  for (int step = 0; step < 62; ++step) {
    simulation.step();
    simulation.guard();
    for (const std::string& line : events.look(simulation)) count += line.find(words) != std::string::npos;
  }
  return count;
}

TEST(Fragment, IsToldOf) {
  const std::string away = "warning: rock is more than half a triangle from where the lattice has it: ";
  EXPECT_EQ(told("let_go", " been let go"), 1);
  EXPECT_EQ(told("let_go", away), 0);
  EXPECT_EQ(told("end_run", " been let go"), 0);
  EXPECT_EQ(told("end_run", away), 1);
}

TEST(Fragment, FliesOnWithoutThatWhileItsSolidStaysInAnyCase) {
  auto kept = thrown;
  kept.back() = "mechanics.fragments=end_run";
  test::CoupledRun run(pickled_rock, kept), let_go(pickled_rock, thrown);
  run.steps(62);
  let_go.steps(62);
  const auto u = test::host_copy(run.rock().particles().u);
  double farthest = 0;
  for (int i = 0; i < run.rock().particles().count; ++i) farthest = std::max(farthest, std::hypot(u(i, 0), u(i, 1)));
  EXPECT_GT(farthest, 0.01);
  EXPECT_THROW(run.now("triangles_let_go_1"), std::invalid_argument);
  EXPECT_GT(run.now("nodes_dissolved_1"), 0);
  EXPECT_EQ(run.nodes("node_type"), let_go.nodes("node_type"));
  EXPECT_EQ(run.nodes("dissolved_fraction"), let_go.nodes("dissolved_fraction"));
}

}  // namespace
}  // namespace vug
