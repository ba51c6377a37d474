// Rate laws against the numbers and equations of the paper.
#include "kernels/reaction/reaction.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace vug {
namespace {

TEST(Exponential, IsThatOfTheLibraryOverItsWholeRange) {
  // steps that no power of two divides, so that all parts of the range of the series are met at all powers
  double worst = 0;
  for (double x = least_exponent; x <= largest_exponent; x += 0.00173) {
    const long double exact = std::exp(static_cast<long double>(x));
    worst = std::max(worst, static_cast<double>(std::abs(exponential(x) / exact - 1)));
  }
  for (double x = 1e-20; x < 1; x *= 1.07)
    for (const double y : {x, -x})
      worst =
          std::max(worst, static_cast<double>(std::abs(exponential(y) / std::exp(static_cast<long double>(y)) - 1)));
  EXPECT_LT(worst, 2.2e-16);
  EXPECT_EQ(exponential(0), 1);
  EXPECT_EQ(exponential(-1e9), exponential(least_exponent));
  EXPECT_EQ(exponential(1e300), exponential(largest_exponent));
}

TEST(Arrhenius, MatchesTheTableOfRateRatios) {
  // k/k0 for Ea = 62.8 kJ/mol, evaluated independently to four digits
  constexpr double Ea_over_R = 7553.1;
  EXPECT_NEAR(arrhenius(1.0, Ea_over_R, 288.15, 273.15) / 4.218, 1, 2e-4);
  EXPECT_NEAR(arrhenius(1.0, Ea_over_R, 363.15, 273.15) / 946.7, 1, 2e-4);
  EXPECT_NEAR(arrhenius(1.0, Ea_over_R, 488.15, 273.15) / 1.946e5, 1, 5e-4);
  EXPECT_NEAR(arrhenius(1.0, Ea_over_R, 288.15, 237.15) / 280.6, 1, 3e-4);
  EXPECT_NEAR(arrhenius(1.0, Ea_over_R, 488.15, 237.15) / 1.295e7, 1, 5e-4);
  EXPECT_EQ(arrhenius(2.5, Ea_over_R, 300.0, 300.0), 2.5);
}

TEST(Arrhenius, TakesTheNearestEndOfItsRange) {
  EXPECT_EQ(arrhenius(1.0, 7553.1, 100.0, 273.15), arrhenius(1.0, 7553.1, 250.0, 273.15));
  EXPECT_EQ(arrhenius(1.0f, 7553.1f, 5000.0f, 273.15f), arrhenius(1.0f, 7553.1f, 600.0f, 273.15f));
  EXPECT_TRUE(std::isfinite(arrhenius(1.0f, 7553.1f, 600.0f, 237.15f)));
}

/// What the kernels take from the populations A1, A2 that go out along a link.
template <class Real>
Real turned_over(Real k, Real q, Real A1, Real A2) {
  return kinetic_conductance(k, q) * (A1 - q * A2);
}

TEST(KineticFlux, KeepsItsDigitsInFloatForEveryRateConstant) {
  for (double k = 1e-30; k < 1e31; k *= 10)
    for (const double q : {0.0, 1e-7, 1.0, 100.0}) {
      const double A1 = 0.15, A2 = 0.0004;
      const double exact = 6.0 * (A1 - q * A2) / (1 / k + 3 * (1 + q));
      EXPECT_NEAR(turned_over<float>(float(k), float(q), float(A1), float(A2)) / exact, 1, 2e-6) << k << ' ' << q;
      EXPECT_NEAR(turned_over(k, q, A1, A2) / exact, 1, 1e-14) << k << ' ' << q;
    }
  EXPECT_EQ(turned_over(0.0, 0.5, 0.15, 0.1), 0);
}

TEST(KineticFlux, IsTheRateAtTheWallThatItImplies) {
  // J = 6 w k (C_1w - q C_2w) with C_w from the returning populations: the even part of outgoing and returning is w C_w
  constexpr double w = 1.0 / 9, k = 0.3, q = 0.4, A1 = 0.1, A2 = 0.02;
  const double J = turned_over(k, q, A1, A2);
  const double C1 = (A1 + (A1 - J)) / (2 * w), C2 = (A2 + (A2 + J)) / (2 * w);
  EXPECT_NEAR(J, 6 * w * k * (C1 - q * C2), 1e-16);
}

TEST(KineticFlux, TurnsAVeryFastReactionIntoEquilibriumAtTheWall) {
  constexpr double q = 0.25, A1 = 0.1, A2 = 0.02;
  const double J = turned_over(1e20, q, A1, A2);
  EXPECT_NEAR((2 * A1 - J) - q * (2 * A2 + J), 0, 1e-16);
}

template <class Real>
void expect_converted(Real n, Real a, Real b, double bound) {
  const double y = converted(a, b, n), x = double(a) - y;
  ASSERT_GE(y, 0);
  if (b * std::pow(double(a), double(n)) < 1e-30) return;  // may be nothing in float
  ASSERT_LE(y, double(a) * (1 + 1e-6));
  if (x > 1e-3 * a) {
    EXPECT_NEAR(y / (b * std::pow(x, double(n))), 1, bound) << n << " " << a << " " << b;
  } else {  // next to nothing is left
    EXPECT_GT(b * std::pow(2e-3 * a, double(n)), 0.9 * a) << n << " " << a << " " << b;
  }
}

TEST(RateOfAnyOrder, SolvesWhatReactsAtTheWall) {
  for (const double n : {0.2, 0.5, 0.9, 1.0, 1.5, 2.0, 4.0})
    for (const double a : {1e-9, 1e-3, 0.4, 1.0, 3.0})
      for (const double b : {1e-25, 1e-12, 1e-3, 0.5, 20.0, 1e8}) {
        expect_converted(n, a, b, 1e-9);
        expect_converted(float(n), float(a), float(b), 1e-2);
      }
  EXPECT_EQ(converted(0.0, 1.0, 0.5), 0);
  EXPECT_EQ(converted(-0.1, 1.0, 0.5), 0);  // an undershoot of the concentration
  EXPECT_EQ(converted(1.0, 0.0, 0.5), 0);
  EXPECT_NEAR(converted(2.0, 1.0, 2.0), 1, 1e-15);                         // x + x^2 = 2
  EXPECT_NEAR(converted(1.0, 1.0, 0.5), (std::sqrt(5.0) - 1) / 2, 1e-15);  // x + sqrt(x) = 1
  EXPECT_NEAR(converted(0.7, 0.3, 1.0), 0.7 * 0.3 / 1.3, 1e-16);           // the closed form of first order
  EXPECT_EQ(converted(0.5, 1e300, 0.5), 0.5);                              // all there is
}

TEST(PaperWall, SolvesEq22AsPrinted) {
  constexpr double k = 0.018, D1 = 0.03, D2 = 0.02, C1 = 0.7, C2 = 0.2;
  for (const double K : {0.5, 1.0, 10.0, 1e7}) {
    const PaperWall<double> wall = paper_wall(paper_conductance(k, 1 / K, D1, D2), 1 / K, D1, D2, C1, C2);
    const double below = 2 * D1 * D2 * K + D1 * k + D2 * K * k;
    const double exact1 = (2 * C1 * D1 * D2 * K + (C1 * D1 + C2 * D2) * k) / below;
    const double exact2 = K * (2 * C2 * D1 * D2 + (C1 * D1 + C2 * D2) * k) / below;
    EXPECT_NEAR(wall.C1 / exact1, 1, 1e-14) << K;
    EXPECT_NEAR(wall.C2 / exact2, 1, 1e-14) << K;
    EXPECT_NEAR(wall.rate, k * (wall.C1 - wall.C2 / K), 1e-16) << K;
    EXPECT_NEAR(wall.rate, D1 * (C1 - wall.C1) / 0.5, 1e-16) << K;
  }
}

TEST(ReactionYield, BothWallsGiveTheProductItsShareOfTheReactant) {
  constexpr double k = 0.018, D1 = 0.03, D2 = 0.02, C1 = 0.7, C2 = 0.2, w = 1.0 / 6;
  for (const double q : {0.0, 0.4, 2.0})
    for (const double y : {0.25, 0.5, 1.0, 3.0}) {
      const PaperWall<double> wall = paper_wall(paper_conductance(k, q, D1, D2, y), q, D1, D2, C1, C2, y);
      EXPECT_NEAR(wall.rate, k * (wall.C1 - q * wall.C2), 1e-16) << q << ' ' << y;
      EXPECT_NEAR(y * wall.rate, D2 * (wall.C2 - C2) / 0.5, 1e-16) << q << ' ' << y;
      const double A1 = 0.15, A2 = 0.04, J = kinetic_conductance(k, q, y) * (A1 - q * A2), r = J / (6 * w * k);
      const double C1_w = A1 / w - 3 * k * r, C2_w = A2 / w + 3 * y * k * r;
      EXPECT_NEAR(r, C1_w - q * C2_w, 1e-15) << q << ' ' << y;
    }
}

TEST(LinkArea, AddsUpToTheTrueLengthOfAStraightWallOfAnyOrientation) {
  // a wall along a lattice direction (a, b) has |a| + |b| faces per period, each seen by one straight link
  for (const auto& [a, b] : {std::pair{1, 0}, {1, 1}, {2, 1}, {5, 3}}) {
    const double length = std::hypot(a, b), nx = -b / length, ny = a / length;
    EXPECT_NEAR(b * link_area_share(nx, ny, 1, 0) + a * link_area_share(nx, ny, 0, 1), length, 1e-14);
  }
}

}  // namespace
}  // namespace vug
