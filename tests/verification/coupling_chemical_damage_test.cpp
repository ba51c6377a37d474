// Dissolution to mass and chemical damage: what the lattice dissolves, triangle by triangle and bond by bond.
#include "dem/dissolved_rock.hpp"
#include "dem_support.hpp"
#include "support/coupled_run.hpp"
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

/// Twice the signed area of a, b, c.
double area2(const std::array<double, 2>& a, const std::array<double, 2>& b, const std::array<double, 2>& c) {
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

TEST(DissolvedTriangle, LosesItsMassAndItsBondsTheirShare) {
  test::CoupledRun run(pickled_rock);
  run.steps(2000);
  const auto dissolved = test::host_copy(run.parts().geometry.dissolved);
  const Assembly& assembly = run.parts().rock->assembly;
  const Particles& particles = run.rock().particles();
  const Bonds& bonds = run.rock().bonds();
  const auto fraction = test::host_copy(particles.solid_fraction);
  const auto pair = test::host_copy(bonds.pair);
  const auto vertex = test::host_copy(bonds.vertex);
  const auto d_c = test::host_copy(bonds.d_c);

  // by the triangles' own geometry: a node belongs to the triangle that holds it, and to the nearest of its edges by
  // barycentric coordinates; nodes on an edge may go to either side
  const int nx = run.scene().lattice.nx, ny = run.scene().lattice.ny;
  const double dx = run.scene().lattice.spacing;
  std::vector<double> taken(particles.count, 0), nodes(particles.count, 0);
  std::vector<std::array<double, 2>> side_taken(bonds.count), side_nodes(bonds.count);
  for (int y = 0; y < ny; ++y)
    for (int x = 0; x < nx; ++x) {
      const std::array<double, 2> p{(x + 0.5) * dx, (y + 0.5) * dx};
      for (int t = 0; t < particles.count; ++t) {
        const auto& corner = assembly.triangles[t];
        std::array<double, 3> weight;  // of the edge (k, k + 1): the coordinate of the corner opposite
        for (int k = 0; k < 3; ++k)
          weight[k] = area2(assembly.vertices[corner[k]], assembly.vertices[corner[(k + 1) % 3]], p);
        const int edge = static_cast<int>(std::min_element(weight.begin(), weight.end()) - weight.begin());
        if (weight[edge] < 0) continue;
        const double lost = dissolved(run.parts().geometry.lattice.node(x, y));
        taken[t] += lost;
        nodes[t] += 1;
        for (int b = 0; b < bonds.count; ++b) {
          const bool own = pair(b, 0) == t || pair(b, 1) == t;
          const int p_ = corner[edge], q_ = corner[(edge + 1) % 3];
          if (!own || std::minmax(p_, q_) != std::minmax(vertex(b, 0), vertex(b, 1))) continue;
          side_taken[b][pair(b, 1) == t] += lost;
          side_nodes[b][pair(b, 1) == t] += 1;
        }
        break;
      }
    }
  int touched = 0, damaged = 0, gone = 0;
  for (int t = 0; t < particles.count; ++t) {
    EXPECT_NEAR(fraction(t), 1 - taken[t] / nodes[t], 1e-12) << "triangle " << t;
    touched += taken[t] > 0.01 * nodes[t];
    gone += nodes[t] - taken[t] < 0.05 * nodes[t];
  }
  for (int b = 0; b < bonds.count; ++b) {
    double compliance = 0;  // of two springs in series, each as long as its side
    for (const int side : {0, 1}) {
      const int t = pair(b, side);
      const double left = std::min(1 - side_taken[b][side] / side_nodes[b][side], 3 * (fraction(t) - 0.05));
      compliance += side_nodes[b][side] / std::max(1e-300, left);
    }
    EXPECT_NEAR(d_c(b), 1 - (side_nodes[b][0] + side_nodes[b][1]) / compliance, 1e-11) << "bond " << b;
    damaged += d_c(b) > 0.01;
  }
  EXPECT_GE(touched, 5);
  EXPECT_GE(damaged, 5);
  EXPECT_GE(gone, 1);
  EXPECT_EQ(run.now("triangles_dissolved_1"), gone);
  const auto state = test::host_copy(bonds.state);
  int failed = 0;  // nothing else breaks them
  for (int b = 0; b < bonds.count; ++b) failed += d_c(b) >= 0.95;
  EXPECT_GE(failed, 1);
  EXPECT_EQ(run.now("bonds_dissolved_1"), failed);
  EXPECT_EQ(std::count(state.data(), state.data() + bonds.count, BondState::dissolved), failed);
  EXPECT_GE(run.now("nodes_dissolved_1"), 20);  // whose share is kept, and not summed again
  // all that is missing was dissolved by the acid: volume = molar volume times acid (Eq. 24)
  double sum = 0;
  for (const double one : taken) sum += one;
  EXPECT_NEAR(sum * dx * dx / (-4e-4 * run.now("acid_gain_reaction_mol_per_m")), 1, 1e-11);
}

/// Rock that is gone stays gone: while acid in the pathways eats the sectors of bonds whole, and when cracks open
/// beside them and move what solid is left.
TEST(DissolvedTriangle, IsNotMendedByPathwaysThatOpen) {
  test::CoupledRun run(replaced(replaced(pickled_rock, "porosity = 0", "porosity = 0.1\npathway_aperture = 3"),
                                "molar_volume = 4e-4", "molar_volume = 2e-3"));
  const Bonds& bonds = run.rock().bonds();
  const auto never_falls = [&](int steps) {
    const auto before = test::host_copy(bonds.d_c), fraction = test::host_copy(run.rock().particles().solid_fraction);
    run.steps(steps);
    const auto after = test::host_copy(bonds.d_c),
               fraction_after = test::host_copy(run.rock().particles().solid_fraction);
    for (int b = 0; b < bonds.count; ++b) EXPECT_GE(after(b), before(b) - 1e-12) << "bond " << b;
    for (int t = 0; t < run.rock().particles().count; ++t) EXPECT_LE(fraction_after(t), fraction(t) + 1e-12) << t;
  };
  for (int part = 0; part < 10; ++part) never_falls(10);

  const auto d_c = test::host_copy(bonds.d_c), d_m = test::host_copy(bonds.d_m);
  const auto fraction = test::host_copy(run.rock().particles().solid_fraction);
  const auto pair = test::host_copy(bonds.pair);
  int gone = 0;  // bonds without rock between triangles that still stand
  for (int b = 0; b < bonds.count; ++b) {
    gone += d_c(b) >= 1 && std::min(fraction(pair(b, 0)), fraction(pair(b, 1))) > 0.1;
    d_m(b) = 1;
  }
  ASSERT_GE(gone, 3);
  const double opened = run.now("nodes_opened_by_damage_1");
  Kokkos::deep_copy(bonds.d_m, d_m);
  never_falls(2);
  ASSERT_GT(run.now("nodes_opened_by_damage_1"), opened + 20);
}

/// A round cavity under pressure that acid widens. The rock that is there feels the pressure on the whole wall, also
/// where what is left of triangles that are gone holds the fluid up: 2 pi r p over all directions.
TEST(DissolvedTriangle, LeavesThePressureOnTheRockBehind) {
  test::CoupledRun run(R"(
[lattice]
size = [0.03, 0.03]
spacing = 5e-4
time_step = 1e-6
[time]
steps = 2000
[geometry]
type = "rock"
[[geometry.shapes]]
type = "disc"
name = "well"
centre = [0.015, 0.015]
radius = 0.003
[rock]
element_size = 3e-3
[[rock.holes]]
type = "disc"
centre = [0.015, 0.015]
radius = 0.006
[flow]
viscosity = 0.025
initial_pressure = 1e5
[solute]
[[solute.species]]
name = "acid"
diffusivity = 2e-2
[reaction]
reactant = "acid"
rate_constant = 1
molar_volume = 1e-5
[mechanics]
local_damping = 0.7
[mechanics.bond]
normal_strength = 1e12
cohesion = 1e12
[boundary.shape.well]
flow = { type = "pressure", pressure = 1.1e6, ramp_time = 2e-4 }
solute = { type = "concentration", concentration = { acid = 3000 } }
[boundary.left]
traction = { support = "roller" }
[boundary.bottom]
traction = { support = "roller" }
[accuracy]
dissolution_factor = 300
)");
  const Particles& particles = run.rock().particles();
  const auto x0 = test::host_copy(particles.x0);
  run.steps(500);
  int gone = 0;
  for (int part = 0; part < 10; ++part) {
    run.steps(60);
    const auto force = test::host_copy(particles.force);
    const auto fraction = test::host_copy(particles.solid_fraction);
    double push = 0;
    gone = 0;
    for (int i = 0; i < particles.count; ++i) {
      const double x = x0(i, 0) - 0.015, y = x0(i, 1) - 0.015;
      if (is_gone(fraction(i)))
        ++gone;
      else
        push += (force(i, 0) * x + force(i, 1) * y) / std::hypot(x, y);
    }
    double cells = 0, pressure = 0, fluid = 0;
    const std::vector<double> type = run.nodes("node_type"), p = run.nodes("gauge_pressure");
    for (std::size_t n = 0; n < type.size(); ++n) {
      cells += type[n] != 1;
      if (type[n] == 0) pressure += p[n], fluid += 1;
    }
    const double circumference = 2 * std::sqrt(3.14159265 * cells) * 5e-4;
    EXPECT_NEAR(push / (circumference * pressure / fluid), 1, 0.03) << gone << " triangles are gone";
  }
  EXPECT_GT(gone, 20);
}

}  // namespace
}  // namespace vug
