// Drag and lift of a cylinder in a channel, the benchmark 2D-1 of M. Schäfer and S. Turek (Flow Simulation with
// High-Performance Computers II, Vieweg 1996, 547): C_D 5.57 ... 5.59, C_L 0.0104 ... 0.0110; converged 5.57953523384
// and 0.010618948146 (Nabh 1998). A case file run by the program and read from its history.csv.
#include "support/history.hpp"
#include "support/record.hpp"
#include "support/run_vug.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace vug {
namespace {

struct Coefficients {
  double drag, lift, mass_error;
};

/// With so many cells per diameter, at the same speeds in cells per step.
Coefficients cylinder(int cells) {
  const test::TemporaryFolder folder;
  const test::Outcome outcome = test::run_vug(
      fmt::format("run {}/cases/cylinder.toml -o {} --quiet --threads 1 --set lattice.spacing={:.17g} --set "
                  "lattice.time_step={:.17g} --set output.flows=true --set time.end=20 --set output.interval=20",
                  VUG_SOURCE_DIR, folder / "run", 0.1 / cells, 0.02 / cells));
  EXPECT_EQ(outcome.exit_code, 0) << outcome.output;
  const auto last = [&](const char* column) { return test::history_column(folder / "run", column).back(); };
  constexpr double pressure = 0.5 * 1.0 * 0.2 * 0.2 * 0.1;  // density U^2 D / 2
  const Coefficients found{last("shape_cylinder_force_x_N_per_m") / pressure,
                           last("shape_cylinder_force_y_N_per_m") / pressure,
                           last("right_mass_flow_kg_per_m_s") / last("left_mass_flow_kg_per_m_s") + 1};
  test::record("cylinder", {{"cells", cells}, {"drag", found.drag}, {"lift", found.lift}});
  return found;
}

/// 10 cells make such a staircase of the circle that the lift, a five-hundredth of the drag, is 17 % off.
TEST(Cylinder, DragAndLiftAtReynolds20) {
  const Coefficients coarse = cylinder(10), fine = cylinder(20);
  EXPECT_NEAR(coarse.drag, 5.5795, 0.025 * 5.5795);
  EXPECT_NEAR(coarse.lift, 0.010619, 0.2 * 0.010619);
  EXPECT_NEAR(coarse.mass_error, 0, 1e-4);
  EXPECT_NEAR(fine.drag, 5.5795, 0.0125 * 5.5795);
  EXPECT_NEAR(fine.lift, 0.010619, 0.06 * 0.010619);
}

TEST(CylinderLong, DragAndLiftAtReynolds20OnAFinerLattice) {
  const Coefficients fine = cylinder(40);
  EXPECT_NEAR(fine.drag, 5.5795, 0.01 * 5.5795);
  EXPECT_NEAR(fine.lift, 0.010619, 0.08 * 0.010619);
}

}  // namespace
}  // namespace vug
