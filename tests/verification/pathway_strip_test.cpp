// What the strip of a pathway conducts: the slot of its aperture, in any direction and wherever it lies.
#include "coupling/strip.hpp"
#include "support/flow_setup.hpp"
#include "support/host_copy.hpp"
#include "support/record.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace vug {
namespace {

/// A crack that closes on itself on a periodic lattice of `columns` x `rows`: `bonds` equal bonds from (0, start)
/// to (over[0], start + over[1]), both of which are the same place or lie one lattice apart.
struct Crack {
  int columns, rows;
  std::array<int, 2> over;
  int bonds = 4;
  double start = 0.13;

  double length() const { return std::hypot(over[0], over[1]); }

  std::vector<char> open(double aperture) const {
    constexpr int margin = 20;
    const Lattice wide(columns + 2 * margin, 2 * rows + 2 * margin);
    std::vector<char> open(static_cast<std::size_t>(columns) * rows, 0);
    const auto at = [&](int bond) {
      const double share = static_cast<double>(bond) / bonds;
      return std::array{margin + share * over[0], margin + start + share * over[1]};
    };
    for (int bond = 0; bond < bonds; ++bond)
      for (const StripNode& entry : strip_nodes(at(bond), at(bond + 1), aperture, wide, 1)) {
        const int x = (entry.node % wide.nx - margin + columns) % columns;
        const int y = (entry.node / wide.nx - margin + rows) % rows;
        open[static_cast<std::size_t>(y) * columns + x] = 1;
      }
    return open;
  }

  /// Viscosity times flow rate over the pressure gradient along the crack, cells^3.
  double conductivity(double aperture) const {
    const auto fluid = open(aperture);
    const double tau = 1.5, viscosity = (tau - 0.5) / 3, gradient = 1e-8;  // so slow that it is Stokes flow
    const Lattice lattice(columns, rows);
    test::Flow<double> flow(
        lattice, test::shape(lattice, [&](int x, int y) { return !fluid[static_cast<std::size_t>(y) * columns + x]; }),
        {true, true}, Collision::trt, tau);
    for (int axis = 0; axis < 2; ++axis) flow.step.body_force[axis] = gradient * over[axis] / length();
    // The sum of the velocities is the flow rate times the way once along the crack.
    double rate = 0;
    for (int sweep = 0; sweep < 100000; sweep += 100) {
      for (int k = 0; k < 100; ++k) flow.sweep();
      const auto u = test::host_copy(flow.fields.u);
      double sum = 0;
      for (int i = 0; i < flow.nodes.count; ++i) sum += (u(i, 0) * over[0] + u(i, 1) * over[1]) / length();
      const double now = sum / length();
      if (std::abs(now - rate) < 1e-8 * std::abs(now)) return viscosity * now / gradient;
      rate = now;
    }
    ADD_FAILURE() << "the flow did not become steady";
    return 0;
  }
};

TEST(PathwayStrip, ObeysTheCubicLawWhereverAnAxisParallelLineLies) {
  for (const double start : {0.0, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9})
    for (const int w : {1, 2, 3, 4, 6}) {
      const Crack along_x{8, 12, {8, 0}, 1, 5 + start};
      const double expected = w * w * w / 12.0 * (1 + 1 / (2.0 * w * w));  // n nodes of a parabola
      EXPECT_NEAR(along_x.conductivity(w) / expected, 1, 1e-5) << w << " cells at " << start;
    }
}

struct Direction {
  int degrees;
  std::array<int, 2> over;
};

/// Directions to 0.01 degrees.
const std::vector<Direction> directions{{0, {101, 0}},  {5, {103, 9}},  {10, {97, 17}}, {15, {97, 26}},
                                        {20, {91, 33}}, {25, {90, 42}}, {30, {71, 41}}, {37, {73, 55}},
                                        {45, {71, 71}}, {60, {41, 71}}, {75, {26, 97}}, {90, {0, 101}}};

TEST(PathwayStrip, ConductsAlikeInEveryDirection) {
  for (const auto& [degrees, over] : directions) {
    const Crack crack{over[0] > 0 ? over[0] : 20, over[1] > 0 ? over[1] : 20, over};
    for (const double w : {1.0, 1.25, 1.5, 2.0, 2.5, 3.0, 3.4, 4.0, 5.0, 6.0}) {
      if (degrees == 5 && w > 3) continue;  // its turns around the lattice would meet
      const double error = crack.conductivity(w) / slot_conductivity(w) - 1;
      const double slope = std::tan(std::min(degrees, 90 - degrees) * std::numbers::pi / 180);
      if (w == 1) {  // the narrowest piece of whole cells is wider than one
        EXPECT_NEAR(error, slot_conductivity(strip_aperture(1, slope)) / slot_conductivity(1) - 1, 0.1) << degrees;
      } else {
        const double bound = w >= 3 ? 0.05 : w >= 2 ? 0.08 : 0.13;
        EXPECT_LT(std::abs(error), bound) << degrees << " degrees, " << w << " cells";
      }
      test::record("pathway_strip", {{"degrees", degrees}, {"aperture", w}, {"error", error}});
    }
  }
}

/// Generated meshes have bonds of any length and place; a chain of them conducts as well as one.
TEST(PathwayStrip, ConductsAlikeForBondsOfAnyLength) {
  for (const auto& over : {std::array{97, 26}, {71, 41}, {71, 71}})
    for (const int bonds : {1, 3, 5, 8})
      for (const double start : {0.05, 0.4, 0.75}) {
        const Crack crack{over[0], over[1], over, bonds, start};
        for (const double w : {3.0, 4.3})
          EXPECT_NEAR(crack.conductivity(w) / slot_conductivity(w), 1, bonds > 5 ? 0.1 : 0.05)
              << over[1] << "/" << over[0] << ", " << bonds << " bonds, " << w << " cells";
      }
}

}  // namespace
}  // namespace vug
