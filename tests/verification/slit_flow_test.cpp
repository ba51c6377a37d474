// Cracks narrower than a cell: drag on the fluid of their nodes.
#include "support/crack.hpp"
#include "support/record.hpp"

#include <cmath>

namespace vug {
namespace {

using test::Crack;
using test::Direction;
using test::Flow;

/// Between walls n cells apart in a medium of resistance 1/k (Brinkman 1949): u = g k/nu (1 - cosh(m y)/cosh(m n/2)),
/// m = 1/sqrt(k), y from the middle. Relative L2 error.
double brinkman_error(int n, double resistance, Collision collision) {
  const double tau = 0.9, viscosity = (tau - 0.5) / 3, force = 1e-7;
  Flow<double> flow(2, n, {true, false}, collision, tau);
  flow.step.body_force[0] = force;
  const SlitNodes slits = Crack::all_nodes(flow.nodes, resistance);
  const double slowest = viscosity * (resistance + 10.0 / (n * n));
  for (int step = 0; step < 30 / slowest + 100; ++step) {
    flow.sweep();
    drag_in_slits(flow.exec, flow.nodes, slits, viscosity, flow.step, flow.fields);
  }
  double error2 = 0, size2 = 0;
  const double m = std::sqrt(resistance);
  for (int y = 0; y < n; ++y) {
    const double exact =
        force / (viscosity * resistance) * (1 - std::cosh(m * (y + 0.5 - n / 2.0)) / std::cosh(m * n / 2.0));
    error2 += std::pow(flow.at(1, y).ux - exact, 2);
    size2 += exact * exact;
  }
  return std::sqrt(error2 / size2);
}

TEST(SlitFlow, FollowsBrinkmanBetweenWalls) {
  for (const Collision collision : {Collision::trt, Collision::bgk, Collision::lallemand_luo, Collision::regularised}) {
    double coarse = 0;
    for (const int n : {10, 20, 40}) {
      const double error = brinkman_error(n, 25.0 / (n * n), collision);  // five boundary layers wide
      test::record("brinkman", {{"collision", static_cast<int>(collision)}, {"nodes", n}, {"error", error}});
      if (n > 10) {
        EXPECT_LT(error, 0.3 * coarse) << n;
      }
      coarse = error;
    }
    EXPECT_LT(coarse, 2e-3);
  }
}

/// Without walls the velocity is g k/nu for any k.
TEST(SlitFlow, FollowsDarcy) {
  for (const double resistance : {1e-3, 1.0, 1e3, 1e5}) {
    const double tau = 0.9, viscosity = (tau - 0.5) / 3, force = 1e-7;
    Flow<double> flow(4, 4, {true, true}, Collision::trt, tau);
    flow.step.body_force = {force, -2 * force};
    const SlitNodes slits = Crack::all_nodes(flow.nodes, resistance);
    for (int step = 0; step < 20 * (viscosity * resistance + 1 / (viscosity * resistance)) + 10; ++step) {
      flow.sweep();
      drag_in_slits(flow.exec, flow.nodes, slits, viscosity, flow.step, flow.fields);
    }
    EXPECT_NEAR(flow.at(1, 2).ux * viscosity * resistance / force, 1, 1e-8) << resistance;
    EXPECT_NEAR(flow.at(1, 2).uy * viscosity * resistance / force, -2, 1e-8) << resistance;
  }
}

TEST(SlitFlow, ConductsByTheCubicLawInEveryDirection) {
  for (const Direction& direction : test::directions) {
    const Crack crack(direction);
    for (const double w : {0.01, 0.1, 0.3, 0.6, 1.0, 1.2, 1.5, 2.0, 3.0}) {
      if (w == 0.01 && direction.slope() > 0) continue;  // its pressures take a million steps to settle around corners
      const double resistance = slit_resistance(cubic_law(w), direction.slope());
      const double strip = std::max(1.0, slot_aperture(cubic_law(w)));
      const double error = crack.conductivity(strip, resistance) / cubic_law(w) - 1;
      const double bound = w <= 1.2 ? 0.025 : w < 3 ? 0.09 : 0.03;  // from a cell on: one column more or less
      EXPECT_LT(std::abs(error), bound) << direction.degrees << " degrees, " << w << " cells";
      test::record("slit", {{"degrees", direction.degrees}, {"aperture", w}, {"error", error}});
    }
  }
}

}  // namespace
}  // namespace vug
