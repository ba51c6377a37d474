// A front of acid in cracked rock: a pathway is open to the acid, but the rock of its cells is still there to dissolve.
#include "../reference/reactive_box.hpp"
#include "base/base.hpp"
#include "coupling/pathways.hpp"
#include "coupling/rock.hpp"
#include "support/host_copy.hpp"
#include "support/record.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <string>

namespace vug {
namespace {

/// 15 mm x 6 mm of rock in 60 x 24 cells, with acid in the two columns on the left.
const std::string slab_case = R"(
[lattice]
size = [0.015, 0.006]
spacing = 2.5e-4
time_step = 2.5e-6
[time]
steps = 1
[geometry]
type = "rock"
[rock]
element_size = 2.7e-3
seed = {}
porosity = 0
[rock.hole]
from = [0, 0]
to = [5e-4, 0.006]
[flow]
viscosity = 2.2e-3
initial_pressure = 100e3
[mechanics]
[damage]
minimum_aperture = 3
)";

/// What opens when.
enum class Cracks { none, all_at_the_start, as_the_front_comes };

struct Front {
  double half_time = 0;  ///< steps until half of the slab's solid has dissolved
  double passed = 0;     ///< steps until the first half of the slab holds 1 % of its solid
  double most = 0;       ///< most that one node was given, cells
};

/// Acid of concentration 1 at x = 0, of diffusivity 1, that reacts at rate k (lattice units).
Front dissolve_slab(Cracks cracks, double k, int seed) {
  const Scene scene = parse_scene(fmt::format(fmt::runtime(slab_case), seed), "case.toml");
  const int nx = scene.lattice.nx, ny = scene.lattice.ny;
  const Lattice lattice(nx, ny);
  const Rock rock = build_rock(scene, lattice);
  reference::ReactiveBox<D2Q5, double> box(
      nx, ny, [&](int x, int y) { return rock.solid[static_cast<std::size_t>(y) * nx + x]; }, solute_parameters(1.0));
  box.use_normals = true;
  box.renew_normals();
  box.wall.molar_volume = 0.2;
  box.k = k;
  box.give_concentration(Side::left, [](int) { return 1.0; });

  PathwayOpener opener(lattice, rock.pathways, SolidSpread(rock.nodes_of_particle, rock.neighbours));
  const ScalarField<double> d_m("d_m", rock.bonds);
  const auto sectors = test::host_copy(rock.sectors_of_bond);
  const auto middle = [&](int b) {
    double x = 0;
    for (int end = 0; end < 2; ++end)
      for (const int v : rock.assembly.triangles[sectors(b, end) / 3])
        x += rock.assembly.vertices[v][0] / (6 * scene.lattice.spacing);
    return x;
  };
  Front front;
  const double start = box.solid_total();
  const auto open = [&](double to) {  // two bonds of three
    test::edit(d_m, [&](const auto& host) {
      for (int b = 0; b < rock.bonds; ++b)
        if (b % 3 && middle(b) < to) host(b) = 1;
    });
    const int first = box.nodes.count;
    if (opener.look(box.exec, d_m).changed == 0 || opener.open(box.exec, box.type, box.V, box.dissolved) == 0) return;
    const auto type = on_host(box.type);
    const auto V = on_host(box.V), dissolved = on_host(box.dissolved);
    for (int n = 0; n < lattice.size(); ++n)
      if (type(n) == NodeType::solid) front.most = std::max(front.most, V(n) + dissolved(n));
    append_births(box.exec, box.type, box.nodes);
    fit_to_capacity(box.exec, box.nodes, D2Q5::Q, first, box.acid.h, box.acid.C);
    initialise_births<D2Q5>(box.exec, box.nodes, first, box.nodes.count, BirthFill::split, box.acid, box.created);
    find_surface(box.exec, box.nodes, box.type, box.surface);
    box.renew_normals();
  };
  if (cracks == Cracks::all_at_the_start) open(std::numeric_limits<double>::infinity());
  EXPECT_NEAR((box.solid_total() + sum_in_order(opener.waiting())) / start, 1, 1e-12);

  const auto held_before = [&](int to) {
    const auto V = on_host(box.V);
    double sum = 0;
    for (int y = 0; y < ny; ++y)
      for (int x = 0; x < to; ++x) sum += std::max(0.0, V(lattice.node(x, y)));
    return sum;
  };
  const double first_half = held_before(nx / 2);
  for (int step = 1; step <= 200000 && (front.half_time == 0 || front.passed == 0); ++step) {
    box.step();
    box.births(BirthFill::split);
    if (step % 10) continue;
    const double gone = 1 - box.solid_total() / start;
    if (cracks == Cracks::as_the_front_comes) open(2 + 1.2 * gone * nx + 6);
    if (front.half_time == 0 && gone >= 0.5) front.half_time = step;
    if (front.passed == 0 && held_before(nx / 2) <= 0.01 * first_half) front.passed = step;
  }
  return front;
}

const char* name_of(Cracks cracks) {
  return cracks == Cracks::all_at_the_start ? "at the start" : "as the front comes";
}

/// Against the uncracked slab, times over its own: means of five rocks.
Front compare(Cracks cracks, double k) {
  constexpr int rocks = 5;
  Front mean;
  for (int seed = 1; seed <= rocks; ++seed) {
    const Front whole = dissolve_slab(Cracks::none, k, seed), front = dissolve_slab(cracks, k, seed);
    std::printf(
        "    k = %g, cracks %s: half gone after %.0f steps (uncracked %.0f), first half after %.0f (%.0f), most %.3f\n",
        k, name_of(cracks), front.half_time, whole.half_time, front.passed, whole.passed, front.most);
    mean.half_time += front.half_time / whole.half_time / rocks;
    mean.passed += front.passed / whole.passed / rocks;
    mean.most = std::max(mean.most, front.most);
  }
  EXPECT_GT(mean.most, 1.5);
  EXPECT_LE(mean.most, most_solid * (1 + 1e-12));
  test::record(
      "cracked_slab",
      {{"k", k}, {"cracks", name_of(cracks)}, {"half", mean.half_time}, {"passed", mean.passed}, {"most", mean.most}});
  return mean;
}

TEST(CrackedSlab, DissolvesAsFastAsTheSameRockUncracked) {
  for (const Cracks cracks : {Cracks::all_at_the_start, Cracks::as_the_front_comes}) {
    const Front ratio = compare(cracks, 100);
    EXPECT_NEAR(ratio.passed, 1, 0.05);
    if (cracks == Cracks::as_the_front_comes)
      EXPECT_NEAR(ratio.half_time, 1, 0.05);
    else {  // acid goes ahead in cracks that are open before it comes: from rock to rock 0 to 14 % faster
      EXPECT_LT(ratio.half_time, 1);
      EXPECT_GT(ratio.half_time, 0.9);
    }
  }
}

/// Where the reaction decides, the walls of the pathways are reactive surface: the rate is no longer that of one face.
TEST(CrackedSlab, DissolvesFasterWhereTheReactionIsSlow) {
  double last = 1;
  for (const double k : {0.1, 0.01}) {
    const Front at_once = compare(Cracks::all_at_the_start, k);
    const Front with_front = compare(Cracks::as_the_front_comes, k);
    EXPECT_LT(at_once.half_time, with_front.half_time);
    EXPECT_LT(with_front.half_time, last);
    last = at_once.half_time;
  }
}

}  // namespace
}  // namespace vug
