// Natural convection in a square cavity against the benchmark of G. de Vahl Davis (Int. J. Numer. Meth. Fluids 3, 1983,
// 249): mean Nusselt numbers 1.118, 2.243, 4.519 and 8.800 at Rayleigh numbers 10^3 to 10^6. A case file run by the
// program and read from its history.csv.
#include "support/history.hpp"
#include "support/record.hpp"
#include "support/run_vug.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

namespace vug {
namespace {

constexpr double side = 0.0224, diffusivity = 2.2e-5, gravity_at_1e4 = 8.992506;

/// Mean Nusselt number of the warm wall after `times` of the square of the side over the diffusivity; steps such that
/// (g beta dT L)^1/2 is 0.2 cells per step, the largest speed a fifth of it.
double nusselt(double rayleigh, int cells, double times) {
  const double spacing = side / cells;
  const double step = 0.2 * cells / std::sqrt(0.71 * rayleigh) * spacing * spacing / diffusivity;
  const double end = times * side * side / diffusivity;
  const test::TemporaryFolder folder;
  const test::Outcome outcome = test::run_vug(
      fmt::format("run {}/cases/heated_cavity.toml -o {} --quiet --threads 1 --set lattice.spacing={:.17g} --set "
                  "lattice.time_step={:.17g} "
                  "--set time.end={:.17g} --set output.interval={:.17g} --set 'flow.gravity=[0,{:.17g}]'",
                  VUG_SOURCE_DIR, folder / "run", spacing, step, end, end / 4, -gravity_at_1e4 * rayleigh / 1e4));
  EXPECT_EQ(outcome.exit_code, 0) << outcome.output;
  constexpr double at_rest = 1.2 * 1004.5 * diffusivity * 10;  // conductivity dT L / L, W/m
  const auto warm = test::history_column(folder / "run", "left_heat_flow_W_per_m");
  const auto cold = test::history_column(folder / "run", "right_heat_flow_W_per_m");
  EXPECT_NEAR(warm.back() / at_rest, -cold.back() / at_rest, 2e-3 * warm.back() / at_rest) << "not steady";
  test::record("natural_convection", {{"rayleigh", rayleigh}, {"cells", cells}, {"nusselt", warm.back() / at_rest}});
  return warm.back() / at_rest;
}

TEST(NaturalConvection, Rayleigh1e3) {
  EXPECT_NEAR(nusselt(1e3, 32, 0.8), 1.118, 0.01 * 1.118);
}
TEST(NaturalConvection, Rayleigh1e4) {
  EXPECT_NEAR(nusselt(1e4, 48, 0.5), 2.243, 0.01 * 2.243);
}
TEST(NaturalConvectionLong, Rayleigh1e5) {
  EXPECT_NEAR(nusselt(1e5, 96, 0.4), 4.519, 0.01 * 4.519);
}
TEST(NaturalConvectionLong, Rayleigh1e6) {
  EXPECT_NEAR(nusselt(1e6, 128, 0.25), 8.800, 0.01 * 8.800);
}

}  // namespace
}  // namespace vug
