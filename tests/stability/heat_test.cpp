// Conjugate heat at the extremes: where it holds, and where it does not.
#include "support/flow_setup.hpp"
#include "support/heat_box.hpp"
#include "support/host_copy.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace vug {
namespace {

using test::HeatBox;

constexpr int n = 40;

/// A quarter of the nodes fluid, in blocks of three: interfaces of every kind, islands included.
bool rock(int x, int y) {
  unsigned h = static_cast<unsigned>(x / 3 * 73856093) ^ static_cast<unsigned>(y / 3 * 19349663);
  h = (h ^ h >> 13) * 0x5bd1e995u;
  return (h >> 15) % 4 != 0;
}

double checkers(int x, int y) {
  return (x * 7 + y * 13) % 5 < 2 ? 1.0 : -1.0;
}

/// The energy norm of the scheme never grows: sum of c g^2 / w. Bounds theta of a start with |theta| = 1.
TEST(ConductionStability, HoldsForAnyDiffusivityAndContrast) {
  for (const double diffusivity : {1e-6, 1e-3, 0.1, 1.5, 1e3}) {
    for (const double sigma : {1e-4, 1e-2, 1.0, 1e2, 1e4}) {
      for (const double conductivity : {1e-4, 1.0, 1e4}) {
        // the sets take turns
        const ScalarVelocitySet set = conductivity == 1 ? ScalarVelocitySet::d2q9 : ScalarVelocitySet::d2q5;
        HeatBox<double> box(n, n, {diffusivity, diffusivity * conductivity / sigma, sigma, set}, rock, checkers);
        double start = 0;
        for (int y = 0; y < n; ++y)
          for (int x = 0; x < n; ++x) start += rock(x, y) ? sigma : 1.0;
        box.run(400);
        const auto solid = test::host_copy(box.fields.solid);
        const std::vector<double> theta = box.theta();
        double norm = 0;
        for (int y = 0; y < n; ++y)
          for (int x = 0; x < n; ++x)
            norm += (solid(box.lattice.node(x, y)) ? sigma : 1.0) * theta[y * n + x] * theta[y * n + x];
        // theta^2 <= sum g^2 / w by Cauchy-Schwarz, and the latter never grows
        EXPECT_LE(norm, start * (1 + 1e-12)) << diffusivity << " " << sigma << " " << conductivity;
      }
    }
  }
}

/// Grains and the creeping flow between them, to be scaled to any speed.
struct PorousFlow {
  static bool solid(int x, int y) { return y < 2 || y >= n - 2 || (rock(x + 1, y) && rock(x, y + 5)); }
  test::Flow<double> flow{Lattice(n, n), test::shape(Lattice(n, n), solid), {true, false}, Collision::trt, 1.0};
  double fastest = 0;
  PorousFlow() {
    flow.step.body_force = {1e-5, 0};
    for (int step = 0; step < 3000; ++step) flow.sweep();
    const auto u = test::host_copy(flow.fields.u);
    for (int i = 0; i < flow.nodes.count; ++i) fastest = std::max(fastest, std::hypot(u(i, 0), u(i, 1)));
  }
};

/// Largest |theta| ever seen at a few moments of a flow past grains, from a start within [-1, 1].
template <class T>
double largest(const PorousFlow& porous, const HeatParameters& parameters, double speed) {
  HeatBox<T> box(n, n, parameters, PorousFlow::solid,
                 [](int x, int y) { return std::sin(0.3 * x) * std::cos(0.2 * y); }, {true, false});
  const auto u = test::host_copy(porous.flow.fields.u);
  const auto index = test::host_copy(porous.flow.nodes.index);
  box.flow([&](int x, int y) {
    const int i = index(box.lattice.node(x, y));
    const double scale = speed / porous.fastest;
    return std::array<double, 2>{scale * u(i, 0), scale * u(i, 1)};
  });
  double found = 0;
  for (int moment = 0; moment < 8; ++moment) {
    box.run(250);
    const HeatExtremes extremes = heat_extremes(box.exec, box.fields);
    found = std::max({found, -extremes.lowest, extremes.highest});
    if (extremes.not_finite > 0) return INFINITY;
  }
  return found;
}

/// Diffusivities from 0.01 to 5 at a grid Peclet number u / D of 4 or a speed of 0.2. A start that is itself not smooth
/// on the scale of D rings: at D = 5 (tau = 15) the conducting scheme alone reaches 1.6 for a moment.
TEST(ConvectionStability, HoldsBetweenGrainsAtGridPeclet4AndAnyContrast) {
  const PorousFlow porous;
  for (const auto& [diffusivity, bound] : {std::pair{0.01, 1.05}, {0.05, 1.05}, {1.0, 1.5}, {5.0, 1.7}})
    for (const double sigma : {1e-4, 1.0, 1e4})
      for (const double conductivity : {1e-4, 1.0, 1e4}) {
        const double speed = std::min(0.2, 4 * diffusivity);
        const HeatParameters parameters{diffusivity, diffusivity * conductivity / sigma, sigma};
        EXPECT_LE(largest<double>(porous, parameters, speed), bound)
            << "D " << diffusivity << " sigma " << sigma << " lambda " << conductivity << " u " << speed;
      }
}

/// As documented: where the flow has a divergence on the lattice and u / D is large, conduction no longer damps the
/// mode that alternates from step to step (s is near 2), and it grows at a rate of about |u| / 4. `vug check` warns.
TEST(ConvectionStability, IsLostAtGridPeclet20) {
  const PorousFlow porous;
  EXPECT_GT(largest<double>(porous, {0.005, 0.0125, 0.625}, 0.1), 10);
}

/// D2Q9 has the even part of the equilibrium as well and holds to the same number.
TEST(ConvectionStability, OfD2Q9HoldsAndIsLostAtTheSameGridPecletNumbers) {
  const PorousFlow porous;
  constexpr ScalarVelocitySet set = ScalarVelocitySet::d2q9;
  for (const double sigma : {1e-4, 1.0, 1e4})
    for (const double diffusivity : {0.01, 0.05})
      EXPECT_LE(largest<double>(porous, {diffusivity, diffusivity / sigma, sigma, set}, 4 * diffusivity), 1.1)
          << sigma << " " << diffusivity;
  EXPECT_GT(largest<double>(porous, {0.005, 0.0125, 0.625, set}, 0.1), 10);
}

TEST(ConvectionStability, IsTheSameInFloat) {
  const PorousFlow porous;
  const HeatParameters parameters{0.05, 0.125, 0.625};
  EXPECT_NEAR(largest<float>(porous, parameters, 0.2), largest<double>(porous, parameters, 0.2), 1e-5);
}

}  // namespace
}  // namespace vug
