// Walls that recede: Stefan problems, the quasi-steady slab and the shrinking disc, with the balance of acid and solid.
#include "../reference/reactive_box.hpp"
#include "support/host_copy.hpp"
#include "support/record.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <numbers>

namespace vug {
namespace {

using reference::ReactiveBox;
using test::record;

/// Acid in the fluid minus acid that the remaining solid stands for, less everything that came in, per ledger;
/// constant.
template <class Set>
double book(const ReactiveBox<Set, double>& box) {
  const double M = box.wall.molar_volume;
  return box.acid_total() - box.gained() - sum_in_order(box.created) - (box.solid_total() + sum_in_order(box.lost)) / M;
}

/// A slab of fluid [0, s) of height 1 with C = 1 at x = 0 beside solid up to `length`.
ReactiveBox<D2Q5, double> slab(int s, int length, double D, double M, double k) {
  ReactiveBox<D2Q5, double> box(length, 1, [=](int x, int) { return x >= s; }, solute_parameters(D), 0, {false, true});
  box.wall.molar_volume = M;
  box.k = k;
  box.give_concentration(Side::left, [](int) { return 1.0; });
  return box;
}

/// Sets a profile at rest.
void set_concentration(ReactiveBox<D2Q5, double>& box, const std::function<double(double)>& C_of_x) {
  const auto node = test::host_copy(box.nodes.node);
  test::edit(box.acid.h, [&](const auto& h) {
    for (int i = 0; i < box.nodes.count; ++i) {
      const double C = C_of_x(box.lattice.x(node(i)) + 0.5);
      for (int q = 0; q < 5; ++q) h(q * box.nodes.capacity + i) = D2Q5::w(q) * C;
    }
  });
}

/// lambda of sqrt(pi) lambda exp(lambda^2) erf(lambda) = a.
double stefan_lambda(double a) {
  double low = 0, high = 2;
  for (int n = 0; n < 100; ++n) {
    const double l = 0.5 * (low + high);
    (std::sqrt(std::numbers::pi) * l * std::exp(l * l) * std::erf(l) < a ? low : high) = l;
  }
  return low;
}

/// Steps until the wall has receded to `to`; `at(step, position)` is called whenever a pixel has gone.
int steps_until(ReactiveBox<D2Q5, double>& box, double from, double to, BirthFill fill, int limit,
                const std::function<void(int, double)>& at = {}) {
  const double start = box.solid_total();
  for (int n = 1; n <= limit; ++n) {
    box.step();
    const bool gone = box.births(fill) > 0;
    if (n % 1000 == 0) box.drain();  // without, a million steps of a = 0.001 drift by 2e-12, with it by 2e-14
    const double receded = start - box.solid_total();
    if (gone && at) at(n, from + receded);
    if (receded >= to - from) return n;
  }
  return limit;
}

/// Relative error of lambda when the wall moves from s0 to 2 s0 in the diffusion limit, D (s1^2 - s0^2) = 4 lambda^2 D
/// t.
double stefan_error(double a, int s0) {
  const double lambda = stefan_lambda(a);
  const double D = std::clamp(0.2 / a, 0.2, 5.0);  // the wall moves by less than 0.01 nodes a step
  auto box = slab(s0, 2 * s0 + 2, D, a, 1e6);
  set_concentration(box, [=](double x) { return 1 - std::erf(lambda * x / s0) / std::erf(lambda); });
  const double start = book(box);
  const int steps = steps_until(box, s0, 2 * s0, BirthFill::mean, 10000000, [&](int step, double s) {
    // the similarity solution is at s0 at the time s0^2/(4 lambda^2 D)
    record("solute_stefan_front",
           {{"a", a}, {"s0", s0}, {"tau", 4 * lambda * lambda * D * step / (s0 * s0)}, {"s", s / s0}});
  });
  EXPECT_NEAR(book(box) / start, 1, 1e-12);
  record("solute_stefan_balance", {{"a", a}, {"s0", s0}, {"steps", steps}, {"drift", book(box) / start - 1}});
  const double measured = std::sqrt(3.0 * s0 * s0 / (4 * D * steps));
  std::printf("    a = %g, wall from %d to %d: lambda %.7f, exact %.7f, %+.2e\n", a, s0, 2 * s0, measured, lambda,
              measured / lambda - 1);
  record("solute_stefan", {{"a", a}, {"s0", s0}, {"measured", measured}, {"exact", lambda}});
  return measured / lambda - 1;
}

TEST(StefanProblem, ConvergesToTheExactFront) {
  EXPECT_NEAR(stefan_lambda(0.1209), 0.2411285, 1e-7);
  for (const double a : {0.01, 0.1, 0.1209, 1.0}) {
    // The wall stays at the face of a pixel until the pixel is gone, half a pixel ahead of the front on average: an
    // error of first order in 1/s.
    const double coarse = stefan_error(a, 20), fine = stefan_error(a, 40);
    EXPECT_LT(std::abs(fine), 0.01);
    EXPECT_LT(std::abs(fine), 0.6 * std::abs(coarse));
  }
}

TEST(StefanProblem, HoldsOverThreeDecadesOfTheStefanNumber) {
  for (const double a : {0.001, 0.01, 0.05, 0.1, 0.1209, 0.2, 0.5, 1.0}) EXPECT_LT(std::abs(stefan_error(a, 60)), 0.01);
}

/// s - s0 + k (s^2 - s0^2)/(2 D) = a k t for a wall that recedes slowly (a << 1).
double receding_wall_error(double k, double D, double a, int s0) {
  auto box = slab(s0, 2 * s0 + 2, D, a, k);
  const double gradient = k / (D + k * s0);
  set_concentration(box, [=](double x) { return 1 - gradient * x; });
  const double start = book(box);
  const double to_the_end = (s0 + 1.5 * k * s0 * s0 / D) / (a * k);
  const int steps = steps_until(box, s0, 2 * s0, BirthFill::split, 10000000, [&](int step, double s) {
    record("solute_receding_front", {{"k_s_over_D", k * s0 / D}, {"t", step / to_the_end}, {"s", s / s0}});
  });
  EXPECT_NEAR(book(box) / start, 1, 1e-12);
  EXPECT_EQ(sum_in_order(box.created), 0);
  std::printf("    k s/D = %g: time %+.2e\n", k * s0 / D, steps / to_the_end - 1);
  record("solute_receding_wall", {{"k_s_over_D", k * s0 / D}, {"error", steps / to_the_end - 1}});
  return steps / to_the_end - 1;
}

TEST(RecedingWall, FollowsTheQuasiSteadyLawInBothLimits) {
  // reaction limited: the concentration is uniform and only the transient of order a remains
  EXPECT_LT(std::abs(receding_wall_error(0.02, 5.0, 0.01, 20)), 0.012);
  // mixed and diffusion limited: the pixel's face is half a pixel ahead, 1/(3 s0) of the diffusive part of the time
  EXPECT_LT(std::abs(receding_wall_error(0.25, 5.0, 0.01, 20)), 0.02);
  EXPECT_LT(std::abs(receding_wall_error(1e3, 5.0, 0.01, 20)), 0.025);
}

struct Shrinking {
  double rate;                ///< recession over the true one
  double r_axis, r_diagonal;  ///< radius over that of the disc of the same area
};

/// Radius of the solid around the centre, averaged over sectors of 17 degrees about `angle` and its three images.
double sector_radius(const ReactiveBox<D2Q5, double>& box, double cx, double cy, double angle, double reach) {
  constexpr int per_node = 100;
  const auto V = test::host_copy(box.V);
  double sum = 0;
  int rays = 0;
  for (int quarter = 0; quarter < 4; ++quarter)
    for (int degree = -8; degree <= 8; ++degree, ++rays) {
      const double t = angle + quarter * std::numbers::pi / 2 + degree * std::numbers::pi / 180;
      for (int k = 0; k < reach * per_node; ++k) {
        const double r = (k + 0.5) / per_node;
        sum += V(box.lattice.node(static_cast<int>(std::floor(cx + r * std::cos(t))),
                                  static_cast<int>(std::floor(cy + r * std::sin(t))))) /
               per_node;
      }
    }
  return sum / rays;
}

/// What is left of each pixel, in tenths, one row of the lattice after the other.
void record_shape(const ReactiveBox<D2Q5, double>& box, const std::string& form, double cx, double cy, double r0,
                  double r1) {
  const auto V = test::host_copy(box.V);
  for (int y = 0; y < box.lattice.ny; ++y) {
    std::string row;
    for (int x = 0; x < box.lattice.nx; ++x)
      row += static_cast<char>('0' + std::clamp(std::lround(9 * V(box.lattice.node(x, y))), 0L, 9L));
    record("solute_disc_shape",
           {{"form", form}, {"y", y}, {"row", row}, {"cx", cx}, {"cy", cy}, {"r0", r0}, {"r1", r1}});
  }
}

/// A disc (or the solid around a disc of fluid) in acid of uniform concentration: so little is consumed and so much
/// dissolved per mole that the radius changes by 0.005 per step and nothing else happens.
Shrinking uniform_recession(double R, bool hollow, ReactiveWallLaw law, bool normals, double cx_offset) {
  constexpr double k = 1e-9, speed = 0.002;
  const int n = static_cast<int>((hollow ? 2.9 : 2) * R) + 12;
  const double cx = n / 2.0 + cx_offset, cy = n / 2.0 + 0.7 * cx_offset;
  ReactiveBox<D2Q5, double> box(n, n,
                                [=](int x, int y) { return (std::hypot(x + 0.5 - cx, y + 0.5 - cy) < R) != hollow; },
                                solute_parameters(0.5), 1.0, {true, true});
  box.use_normals = normals;
  box.renew_normals();
  box.k = k;
  box.wall.molar_volume = speed / k;
  box.wall.law = law;
  const double start = hollow ? n * n - box.solid_total() : box.solid_total();
  const double end = hollow ? 2 * start : 0.5 * start;
  const double book_before = book(box);
  double area = start;
  int steps = 0;
  while (hollow ? area < end : area > end) {
    box.step();
    if (++steps % 10 == 0) {
      box.births(BirthFill::mean);
      box.renew_normals();
    }
    area = hollow ? n * n - box.solid_total() : box.solid_total();
  }
  if (law == ReactiveWallLaw::kinetic) {
    EXPECT_NEAR(book(box), book_before, 1e-12 * n * n);
  }
  const double r0 = std::sqrt(start / std::numbers::pi), r1 = std::sqrt(area / std::numbers::pi);
  Shrinking result{std::abs(r1 - r0) / (speed * steps), 1, 1};
  if (!hollow) {
    result.r_axis = sector_radius(box, cx, cy, 0, R) / r1;
    result.r_diagonal = sector_radius(box, cx, cy, std::numbers::pi / 4, R) / r1;
  }
  const std::string form = law == ReactiveWallLaw::kinetic ? "default" : "paper";
  record("solute_disc", {{"form", form},
                         {"R", R},
                         {"hollow", hollow ? 1 : 0},
                         {"offset", cx_offset},
                         {"rate", result.rate},
                         {"r_axis", result.r_axis},
                         {"r_diagonal", result.r_diagonal}});
  if (!hollow && cx_offset == 0 && R == 20) record_shape(box, form, cx, cy, r0, r1);
  std::printf("    R = %g%s: rate over true %.4f, r along the axes %.4f, along the diagonals %.4f\n", R,
              hollow ? " (hollow)" : "", result.rate, result.r_axis, result.r_diagonal);
  return result;
}

TEST(ShrinkingDisc, RecedesAtItsTrueRateAndStaysRound) {
  for (const double offset : {0.0, 0.3}) {
    const Shrinking disc = uniform_recession(20, false, ReactiveWallLaw::kinetic, true, offset);
    EXPECT_NEAR(disc.rate, 1, 0.01);
    EXPECT_NEAR(disc.r_axis, 1, 0.01);
    EXPECT_NEAR(disc.r_diagonal, 1, 0.01);
  }
}

TEST(ShrinkingDisc, AHollowGrowsAtItsTrueRate) {
  EXPECT_NEAR(uniform_recession(20, true, ReactiveWallLaw::kinetic, true, 0.3).rate, 1, 0.01);
}

TEST(ShrinkingDisc, ThePapersFormDissolvesTheStaircase) {
  // Eq. 24 counts every exposed face: 4/pi of the circumference of a still disc, more of one that has grown corners
  const Shrinking disc = uniform_recession(20, false, ReactiveWallLaw::paper, false, 0);
  EXPECT_NEAR(disc.rate, 1.33, 0.03);
  EXPECT_GT(disc.r_axis / disc.r_diagonal, 1.04);
}

TEST(ShrinkingDiscLong, RecedesAtItsTrueRateFromTenToFortyNodes) {
  for (const double R : {10.0, 40.0})
    for (const double offset : {0.0, 0.15, 0.3}) {
      EXPECT_NEAR(uniform_recession(R, false, ReactiveWallLaw::kinetic, true, offset).rate, 1, 0.01);
      EXPECT_NEAR(uniform_recession(R, true, ReactiveWallLaw::kinetic, true, offset).rate, 1, 0.01);
    }
}

}  // namespace
}  // namespace vug
