// Loads over time: what they do, from where a run may be resumed, and that they cost nothing where nobody asked.
#include "support/coupled_run.hpp"
#include "support/host_copy.hpp"
#include "support/overheard.hpp"
#include "support/states.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>

namespace {

using namespace vug;
using test::CoupledRun;
using test::host_copy;

/// A block whose top is pressed by a table and whose right side is moved by one.
const char* const moving_loads =
    "[lattice]\nsize = [0.02, 0.02]\nspacing = 1e-3\ntime_step = 2e-7\n[time]\nsteps = 60\n[geometry]\ntype = "
    "\"rock\"\n"
    "[rock]\nelement_size = 2e-3\n[mechanics]\n[boundary.left]\ntraction = { support = \"roller\" "
    "}\n[boundary.bottom]\n"
    "traction = { support = \"roller\" }\n[boundary.top.traction]\nnormal_stress = "
    "1e6\n[[boundary.top.traction.parts]]\n"
    "from = 0.005\nto = 0.012\nnormal_stress = [[0, 2e6], [\"3 us\", 8e6], [\"8 us\", "
    "4e6]]\n[boundary.right.traction]\n"
    "support = \"pin_roller\"\nvelocity = [[0, 0, 0], [\"2 us\", -0.5, 0], [\"9 us\", 0.2, "
    "0]]\n[[output.gauges]]\nname = "
    "\"wall\"\ntype = \"reaction\"\nside = \"left\"\n[[output.gauges]]\nname = \"floor\"\ntype = \"reaction\"\nside = "
    "\"bottom\"\n[[output.gauges]]\nname = \"core\"\ntype = \"stress\"\nshape = { type = \"disc\", centre = [0.01, "
    "0.01], "
    "radius = 0.005 }\n";

TEST(MovingLoads, MoveAPlatenByTheIntegralOfItsTable) {
  CoupledRun run(moving_loads);
  EXPECT_NEAR(run.now("floor_y_N_per_m"), 1e6 * 0.013 + 2e6 * 0.007, 1e-6 * 27e3);  // at rest under the first values
  run.steps(45);                                                                    // 9 us
  const auto u = host_copy(run.rock().particles().u);
  const auto reference = host_copy(run.rock().particles().u_reference);
  const double way = -0.5 * 2e-6 / 2 + 0.5 * (-0.5 + 0.2) * 7e-6;
  int held = 0;
  for (const BoundaryEdge& edge : run.rock().boundary()) {
    if (edge.side != static_cast<int>(RockSide::right)) continue;
    ++held;
    EXPECT_NEAR(u(edge.particle, 0) - reference(edge.particle, 0), way, 1e-3 * std::abs(way));
  }
  EXPECT_GT(held, 5);
}

/// A block on a fixed floor, loaded on parts of two sides.
CoupledRun settled(const std::string& pressure, const std::string& shear, int steps) {
  CoupledRun run(fmt::format(
      "[lattice]\nsize = [0.02, 0.02]\nspacing = 1e-3\ntime_step = 5e-7\n[time]\nsteps = 2000\n"
      "[geometry]\ntype = \"rock\"\n[rock]\nelement_size = 2e-3\n"
      "[mechanics]\nlocal_damping = 0.5\ndisplacement_from = \"unloaded\"\nbond = {{ normal_strength = 1e12, "
      "cohesion = 1e12 }}\n[boundary.bottom]\ntraction = {{ support = \"fixed\" }}\n"
      "[[boundary.top.traction.parts]]\nfrom = 0.005\nto = 0.012\nnormal_stress = {0}\nshear_stress = {1}\n"
      "[[boundary.right.traction.parts]]\nfrom = 0.008\nto = 0.018\nshear_stress = {1}\n"
      "[[output.gauges]]\nname = \"floor\"\ntype = \"reaction\"\nside = \"bottom\"\n",
      pressure, shear));
  run.steps(steps);
  return run;
}

/// What has come to rest under loads that grew is what the same loads at rest give: every displacement, every rotation.
TEST(MovingLoads, EndLikeTheSameLoadsAtRest) {
  const CoupledRun still = settled("6e6", "-2e6", 0);
  const CoupledRun grown = settled("[[0, 0], [1e-5, 6e6]]", "[[0, 1e6], [1e-5, -2e6]]", 2000);
  EXPECT_NEAR(grown.now("floor_x_N_per_m"), 2e6 * 0.007, 1e-4 * 62e3);
  EXPECT_NEAR(grown.now("floor_y_N_per_m"), 6e6 * 0.007 + 2e6 * 0.010, 1e-4 * 62e3);
  const auto u = host_copy(grown.rock().particles().u), u_still = host_copy(still.rock().particles().u);
  const auto angle = host_copy(grown.rock().particles().angle), angle_still = host_copy(still.rock().particles().angle);
  double moved = 0, turned = 0, off = 0, off_turned = 0;
  for (std::size_t i = 0; i < u.extent(0); ++i) {
    for (int axis = 0; axis < 2; ++axis) {
      moved = std::max(moved, std::abs(u_still(i, axis)));
      off = std::max(off, std::abs(u(i, axis) - u_still(i, axis)));
    }
    turned = std::max(turned, std::abs(angle_still(i)));
    off_turned = std::max(off_turned, std::abs(angle(i) - angle_still(i)));
  }
  std::printf("    displacements off by %.1e, rotations by %.1e\n", off / moved, off_turned / turned);
  EXPECT_LT(off, 1e-3 * moved);
  EXPECT_LT(off_turned, 1e-3 * turned);
}

TEST(MovingLoads, GoOnWithTheSameBitsFromAStateTakenAnywhere) {
  const Scene scene = parse_scene(moving_loads, "case.toml");
  for (const int stop : {1, 13, 40}) {
    Simulation whole(scene), half(scene), rest(scene);
    whole.begin();
    half.begin();
    for (int step = 0; step < 60; ++step) whole.step();
    for (int step = 0; step < stop; ++step) half.step();
    test::restore(rest, test::state_of(half));
    for (int step = stop; step < 60; ++step) rest.step();
    const auto a = whole.history(), b = rest.history();
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t k = 0; k < a.size(); ++k) EXPECT_EQ(a[k].value, b[k].value) << a[k].name << " from step " << stop;
  }
}

/// The kernels of loads over time, of temperatures and of gauges that a step launches, and how often.
std::map<std::string, int> launches(const Scene& scene) {
  static std::map<std::string, int> found;
  static const test::Overheard* others;
  Simulation simulation(scene);
  simulation.begin();
  simulation.step();
  simulation.catch_up();
  found.clear();
  const test::Overheard overheard;
  others = &overheard;
  Kokkos::Tools::Experimental::set_begin_parallel_for_callback(
      [](const char* label, std::uint32_t device, std::uint64_t* id) {
        const std::string name = label;
        if (name == "vug::dem::follow_loads" || name == "vug::dem::follow_temperature" ||
            name.starts_with("vug::dem::gauge") || name.starts_with("vug::dem::mean_stress"))
          ++found[name];
        others->launched(label, device, id);
      });
  simulation.step();
  simulation.catch_up();
  return found;
}

TEST(MovingLoads, AreOneKernelPerSubStepWhereAskedForAndNoneElsewhere) {
  for (const int substeps : {3, 5}) {
    const std::string given = "mechanics.substeps=" + std::to_string(substeps);
    const auto found = launches(parse_scene(moving_loads, "case.toml", {given}));
    EXPECT_EQ(found, (std::map<std::string, int>{{"vug::dem::follow_loads", substeps}}));
  }
  EXPECT_TRUE(launches(read_scene(VUG_SOURCE_DIR "/cases/rock/cantilever.toml")).empty());
}

}  // namespace
