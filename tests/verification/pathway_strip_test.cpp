// What the strip of a pathway conducts: the slot of its aperture, in any direction and wherever it lies.
#include "support/crack.hpp"
#include "support/record.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace vug {
namespace {

using test::Crack;

TEST(PathwayStrip, ObeysTheCubicLawWhereverAnAxisParallelLineLies) {
  for (const double start : {0.0, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9})
    for (const int w : {1, 2, 3, 4, 6}) {
      const Crack along_x{8, 12, {8, 0}, 1, 5 + start};
      const double expected = w * w * w / 12.0 * (1 + 1 / (2.0 * w * w));  // n nodes of a parabola
      EXPECT_NEAR(along_x.conductivity(w) / expected, 1, 1e-5) << w << " cells at " << start;
    }
}

TEST(PathwayStrip, ConductsAlikeInEveryDirection) {
  for (const test::Direction& direction : test::directions) {
    const int degrees = direction.degrees;
    const Crack crack(direction);
    for (const double w : {1.0, 1.25, 1.5, 2.0, 2.5, 3.0, 3.4, 4.0, 5.0, 6.0}) {
      if (degrees == 5 && w > 3) continue;  // its turns around the lattice would meet
      const double error = crack.conductivity(w) / slot_conductivity(w) - 1;
      if (w == 1) {  // the narrowest piece of whole cells is wider than one
        EXPECT_NEAR(error, slot_conductivity(narrowest_aperture(direction.slope())) / slot_conductivity(1) - 1, 0.05)
            << degrees;
      } else {
        const double bound = w >= 3 ? 0.03 : 0.065;  // half a column more or less
        EXPECT_LT(std::abs(error), bound) << degrees << " degrees, " << w << " cells";
      }
      test::record("pathway_strip", {{"degrees", degrees}, {"aperture", w}, {"error", error}});
    }
  }
}

/// What a column more or less does to each bond averages out along a crack and over cracks: the same crack at 0 to 90
/// degrees.
TEST(PathwayStrip, CracksOfManyBondsConductAlikeInEveryDirection) {
  constexpr int cracks = 8;
  double all_squares = 0;
  int all = 0;
  for (const double w : {1.35, 1.65, 1.8, 2.0, 2.2, 2.5})
    for (const test::Direction& direction : test::directions) {
      double sum = 0, squares = 0;
      for (int seed = 0; seed < cracks; ++seed) {
        const double error = Crack::at_random(direction, 5, seed).conductivity(w) / slot_conductivity(w) - 1;
        sum += error;
        squares += error * error;
      }
      EXPECT_LT(std::abs(sum / cracks), 0.05) << direction.degrees << " degrees, " << w << " cells";
      test::record(
          "pathway_strip_cracks",
          {{"degrees", direction.degrees}, {"aperture", w}, {"mean", sum / cracks}, {"mean_square", squares / cracks}});
      all_squares += squares;
      all += cracks;
    }
  EXPECT_LT(std::sqrt(all_squares / all), 0.025);
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
