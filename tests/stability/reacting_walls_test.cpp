// Where the reactive wall holds, and where it breaks as docs/stability.md says.
#include "../reference/diffusion_reaction.hpp"
#include "../reference/reactive_box.hpp"
#include "kernels/flow/guards.hpp"
#include "support/host_copy.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <random>

namespace vug {
namespace {

using reference::ReactiveBox;

/// Pores between random pixels, all of which react, open to C = 1 on the left.
template <class Set, class T>
FieldRange reacted_pores(SoluteParameters p, double k, double q, bool normals, ReactiveWallLaw law, int steps) {
  std::mt19937 random(3);
  std::vector<char> rock(40 * 30);
  for (char& r : rock) r = random() % 3 == 0;
  ReactiveBox<Set, T> box(
      40, 30, [&](int x, int y) { return rock[y * 40 + x]; }, p, 0);
  if (q > 0) box.add_product(0);
  box.wall.inverse_equilibrium = q;
  box.wall.law = law;
  box.wall.D_reactant = box.wall.D_product = p.diffusivity();
  box.use_normals = normals;
  box.renew_normals();
  box.k = k;
  set_random(box);
  box.give_concentration(Side::left, [](int) { return 1.0; });
  for (int n = 0; n < steps; ++n) box.step();
  return field_range(box.exec, box.acid.C, box.nodes.count);
}

TEST(ReactiveWallStability, HoldsForEveryRateConstantAndEquilibrium) {
  for (const double D : {1e-5, 0.02, 1.5})
    for (const double node_Da : {1e-12, 1e-6, 1e-3, 1.0, 1e3, 1e6, 1e12})
      for (const double q : {0.0, 1.0, 1e3}) {
        const FieldRange range =
            reacted_pores<D2Q5, float>(solute_parameters(D), node_Da * D, q, true, ReactiveWallLaw::kinetic, 400);
        EXPECT_EQ(range.first_outside, -1) << D << ' ' << node_Da << ' ' << q;
        // noise from node to node overshoots once; nothing grows
        EXPECT_LT(range.max, 1.6) << D << ' ' << node_Da << ' ' << q;
        EXPECT_GT(range.min, -0.6) << D << ' ' << node_Da << ' ' << q;
      }
}

TEST(ReactiveWallStability, ThePapersWallHoldsAtItsOwnDiffusivityAndNotFarBelow) {
  for (const double node_Da : {1e-6, 1e-3, 1.0, 1e6}) {
    const FieldRange range = reacted_pores<D2Q9, double>(solute_parameters(0.02, 0.7), node_Da * 0.02, 0, false,
                                                         ReactiveWallLaw::paper, 3000);
    EXPECT_EQ(range.first_outside, -1);
    EXPECT_LT(range.max, 1.6);
    EXPECT_GT(range.min, -0.6);
  }
  // a slow reaction at a seventh of the diffusivity: Eq. 23 with C_w = C_f feeds the noise at rough walls
  const auto slow = [](ReactiveWallLaw law) {
    return reacted_pores<D2Q9, double>(solute_parameters(0.003, 0.649), 3e-9, 0, false, law, 3000).max;
  };
  EXPECT_GT(slow(ReactiveWallLaw::paper), 1e3);
  EXPECT_LT(slow(ReactiveWallLaw::kinetic), 1.1);
}

struct SlabResult {
  double flux_error;       ///< of what dissolves per step in the steady state
  double acid_error;       ///< of the acid that the fluid loses per step
  double lowest, highest;  ///< ever, from an empty start
};

/// Acid given at x = 0 diffuses through n nodes to a wall that takes it: D C_in Da/((1 + Da) n) in the steady state, Da
/// = k n/D.
template <class Set, class T>
SlabResult reacting_slab(double Da, SoluteParameters p, ReactiveWallLaw law) {
  constexpr int n = 10, width = 3;
  ReactiveBox<Set, T> box(n + 1, width, [](int x, int) { return x == n; }, p, 0, {false, true});
  const double diffusivity = p.diffusivity();
  box.k = Da * diffusivity / n;
  box.wall.law = law;
  box.wall.molar_volume = 1;  // to read the flux off the dissolved volume: nothing is turned into fluid here
  box.wall.D_reactant = diffusivity;
  box.give_concentration(Side::left, [](int) { return 1.0; });
  SlabResult result{0, 0, 1, 0};
  const auto look = [&] {
    const FieldRange range = field_range(box.exec, box.acid.C, box.nodes.count);
    EXPECT_EQ(range.first_outside, -1);
    result.lowest = std::min(result.lowest, range.min);
    result.highest = std::max(result.highest, range.max);
  };
  for (int step = 0; step < 100; ++step) {
    box.step();
    look();
  }
  const int steps = static_cast<int>(25 * n * n / (2.46 * diffusivity));  // 25 decay times of the slowest mode
  for (int step = 0; step < steps; ++step) box.step();
  look();
  const double solid = sum_in_order(box.dissolved), acid = sum_in_order(box.consumed);
  constexpr int more = 1000;
  for (int step = 0; step < more; ++step) box.step();
  const double exact = more * width * diffusivity / n * (Da / (1 + Da));
  result.flux_error = (sum_in_order(box.dissolved) - solid) / exact - 1;
  result.acid_error = (sum_in_order(box.consumed) - acid) / exact - 1;
  return result;
}

constexpr double all_damkohler_numbers[] = {1e-6, 1e-3, 1.0, 1e3, 1e6};

/// Twelve decades of Da with the default law: the flux is exact, and nothing leaves 0 ... C_in.
TEST(ReactingSlab, HasItsExactFluxFromReactionToDiffusionControl) {
  for (const double Da : all_damkohler_numbers) {
    const SlabResult twice = reacting_slab<D2Q5, double>(Da, solute_parameters(0.2), ReactiveWallLaw::kinetic);
    const SlabResult single = reacting_slab<D2Q5, float>(Da, solute_parameters(0.2), ReactiveWallLaw::kinetic);
    std::printf("    Da %g: flux %+.1e (float %+.1e), C from %.1e to 1%+.1e (float %.1e, 1%+.1e)\n", Da,
                twice.flux_error, single.flux_error, twice.lowest, twice.highest - 1, single.lowest,
                single.highest - 1);
    EXPECT_LE(std::abs(twice.flux_error), 1e-10);  // sums of a thousand steps; Da/(1 + Da) off the wall at 1e6
    EXPECT_LE(std::abs(single.flux_error), 1e-4);  // 6e-8 in each of the n^2/D = 500 steps that the state remembers
    EXPECT_NEAR(twice.acid_error, twice.flux_error, 1e-11);
    EXPECT_GE(twice.lowest, 0);
    EXPECT_LE(twice.highest, 1 + 1e-13);
    EXPECT_GE(single.lowest, 0);
    EXPECT_LE(single.highest, 1 + 1e-5f);
  }
}

/// The paper's wall where it is stable: on D2Q5, and on D2Q9 with the parameters of its Table 2. What its links take
/// and its faces dissolve agrees on a straight wall at rest. The scheme of Table 2 undershoots for a few steps behind
/// the jump of an abrupt start, with either law; nothing else leaves 0 ... C_in.
TEST(ReactingSlab, OfThePapersWallHoldsOverTheSameRange) {
  constexpr ReactiveWallLaw paper = ReactiveWallLaw::paper;
  const SoluteParameters table_2 = solute_parameters(0.02, 0.7);
  for (const double Da : all_damkohler_numbers) {
    const SlabResult d2q5 = reacting_slab<D2Q5, double>(Da, solute_parameters(0.2), paper);
    const SlabResult d2q9 = reacting_slab<D2Q9, double>(Da, table_2, paper);
    const SlabResult single = reacting_slab<D2Q9, float>(Da, table_2, paper);
    std::printf("    Da %g: flux D2Q5 %+.1e, D2Q9 %+.1e (float %+.1e), C from %.1e, %.1e (float %.1e)\n", Da,
                d2q5.flux_error, d2q9.flux_error, single.flux_error, d2q5.lowest, d2q9.lowest, single.lowest);
    EXPECT_LE(std::abs(d2q5.flux_error), 1e-9);
    EXPECT_LE(std::abs(d2q9.flux_error), 1e-9);    // 25 decay times: 1e-11
    EXPECT_LE(std::abs(single.flux_error), 5e-4);  // 6e-8 in each of 5000 steps that the state remembers
    EXPECT_GE(d2q5.lowest, 0);
    for (const SlabResult& r : {d2q9, single}) EXPECT_GE(r.lowest, -0.13);
    for (const SlabResult& r : {d2q5, d2q9, single}) EXPECT_LE(r.highest, 1);
    EXPECT_LE(std::abs(d2q9.acid_error), std::max(1e-9, 1e-12 / Da)) << Da;  // what is left of the start, over the flux
  }
}

/// Eq. 28 on 25 x 20 nodes from a reaction that hardly takes anything to one that leaves nothing at the wall.
TEST(DiffusionReactionCavity, KeepsItsBoundsAndFluxFromReactionToDiffusionControl) {
  constexpr int nx = 25, ny = 20;
  const SoluteParameters p = solute_parameters(0.2);
  std::vector<double> xs(nx), ys(ny);
  for (int i = 0; i < nx; ++i) xs[i] = i + 0.5;
  for (int i = 0; i < ny; ++i) ys[i] = i + 0.5;
  for (const double Da : all_damkohler_numbers) {
    ReactiveBox<D2Q5, double> box(
        nx, ny + 1, [](int, int y) { return y == ny; }, p, 0);
    box.k = Da * p.diffusivity() / ny;
    box.wall.molar_volume = 1;
    box.wall.D_reactant = p.diffusivity();
    box.give_concentration(Side::left, [](int y) { return y < ny ? 1.0 : 0.0; });
    double lowest = 1, highest = 0;
    for (int step = 0; step < 20000; ++step) {  // 16 times the slowest decay time, 4 nx^2/(pi^2 D)
      box.step();
      if (step % 1000 > 3) continue;
      const FieldRange range = field_range(box.exec, box.acid.C, box.nodes.count);
      lowest = std::min(lowest, range.min);
      highest = std::max(highest, range.max);
    }
    const std::vector<double> psi = box.concentration(box.acid),
                              exact = reference::diffusion_reaction_psi(xs, ys, nx, ny, Da);
    double error = 0, norm = 0;
    for (std::size_t i = 0; i < exact.size(); ++i) {
      error += (psi[i] - exact[i]) * (psi[i] - exact[i]);
      norm += exact[i] * exact[i];
    }
    const auto dissolved_beyond = [&](int from) {  // away from the corner where the data jump
      const auto host = Kokkos::create_mirror(Kokkos::HostSpace{}, box.dissolved);
      Kokkos::deep_copy(host, box.dissolved);
      double sum = 0;
      for (int x = from; x < nx; ++x) sum += host(box.lattice.node(x, ny));
      return sum;
    };
    constexpr int from = 5;
    const double before = dissolved_beyond(from);
    box.step();
    const double flux = (dissolved_beyond(from) - before) / p.diffusivity() /
                        (reference::diffusion_reaction_wall_flux(nx, nx, ny, Da) -
                         reference::diffusion_reaction_wall_flux(from, nx, ny, Da));
    std::printf("    Da %g: L2 %.1e, flux %+.1e, C from %.1e to 1%+.1e\n", Da, std::sqrt(error / norm), flux - 1,
                lowest, highest - 1);
    // four times coarser either way than Eq. 28 in solute_wall_test (bound 8e-4), of order 1.8 by the corner
    EXPECT_LE(std::sqrt(error / norm), 4e-3);
    EXPECT_NEAR(flux, 1, 4e-3);
    EXPECT_GE(lowest, 0);
    EXPECT_LE(highest, 1 + 1e-13);
  }
}

TEST(CreepingReaction, FloatDissolvesTheSameAsDouble) {
  // what one step takes off a pixel is far below the last digit of a float of 1, and of the populations
  const auto dissolved = [](auto zero, double k) {
    using T = decltype(zero);
    ReactiveBox<D2Q5, T> box(8, 1, [](int x, int) { return x >= 6; }, solute_parameters(0.02), 1.0, {false, true});
    box.k = k;
    box.wall.molar_volume = 0.1209;
    for (int n = 0; n < 1000; ++n) box.step();
    return sum_in_order(box.dissolved);
  };
  for (const double k : {1e-15, 1e-12, 1e-9}) {
    EXPECT_NEAR(dissolved(0.0f, k) / (0.1209 * k * 1000), 1, 1e-5) << k;
    EXPECT_NEAR(dissolved(0.0, k) / (0.1209 * k * 1000), 1, 1e-5) << k;
  }
}

}  // namespace
}  // namespace vug
