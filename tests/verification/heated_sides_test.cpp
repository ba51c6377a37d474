// Sides that give heat, and sides that let none pass, against exact profiles.
#include "support/heat_box.hpp"
#include "support/record.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace vug {
namespace {

using test::HeatBox;
using test::record;
using test::velocity_sets;

/// Two layers in series, a given heat flux on one side and a given temperature on the other, on every side in turn and
/// the fluid first: in the steady state the temperature falls by q / lambda per node in each layer.
TEST(HeatedSlab, HasTheGradientOfItsFluxExactly) {
  const int n = 5;
  const double d_f = 0.2, d_s = 0.5, sigma = 0.625, flux = 0.03;
  for (const ScalarVelocitySet set : velocity_sets)
    for (const Side heated : all_sides) {
      const bool upright = is_upright(heated);
      const bool reversed = heated == Side::right || heated == Side::top;
      const auto depth = [&](int x, int y) {  // in nodes, from the heated side
        const int along = upright ? x : y;
        return (reversed ? 2 * n - 1 - along : along) + 0.5;
      };
      const auto exact = [&](double at) {
        return flux * ((at < n ? (n - at) / d_f : 0) + (2 * n - std::max<double>(at, n)) / (sigma * d_s));
      };
      HeatBox<double> box(
          upright ? 2 * n : 2, upright ? 2 : 2 * n, {d_f, d_s, sigma, set},
          [&](int x, int y) { return depth(x, y) > n; }, [](int x, int y) { return 0.1 * std::sin(x + 2 * y); },
          {!upright, upright});
      const Side cold = static_cast<Side>(D2Q9::opposite(static_cast<int>(heated)));
      box.side(heated, HeatCondition::flux, flux);
      box.side(cold, HeatCondition::temperature, 0);
      const double before = box.energy();
      const int steps = 6000;  // more than 40 times the slowest decay time
      box.run(steps);
      const std::vector<double> theta = box.theta();
      double error = 0;
      for (int y = 0; y < box.lattice.ny; ++y)
        for (int x = 0; x < box.lattice.nx; ++x)
          error = std::max(error, std::abs(theta[y * box.lattice.nx + x] - exact(depth(x, y))));
      EXPECT_LE(error, 1e-12 * exact(0)) << test::name_of(set) << " " << vug::name_of(heated);
      const double given = 2.0 * steps * flux;  // two nodes wide
      EXPECT_NEAR(sum_in_order(box.sides[0].energy_in) / given, 1, 1e-12);
      EXPECT_NEAR((box.energy() - before - box.entered()) / given, 0, 1e-12);
      record("heat_heated_slab",
             {{"set", test::name_of(set)}, {"side", vug::name_of(heated)}, {"error", error / exact(0)}});
    }
}

/// In a closed box with one heated side, corners included, exactly the given heat arrives, in fluid and in rock.
TEST(HeatedSide, GivesItsFluxToEveryNodeAndNothingElse) {
  for (const ScalarVelocitySet set : velocity_sets)
    for (const Side heated : all_sides) {
      HeatBox<double> box(
          9, 7, {0.1, 0.2, 3, set}, [](int x, int y) { return (x + y) % 3 == 0; },
          [](int x, int y) { return std::sin(x) * y; });
      box.side(heated, HeatCondition::flux, 0.01);
      const double before = box.energy();
      box.run(500);
      const double given = 500 * 0.01 * (is_upright(heated) ? 7 : 9);
      EXPECT_NEAR(box.energy() - before, given, 1e-12 * 100) << test::name_of(set) << " " << vug::name_of(heated);
    }
}

/// Nothing changes along an adiabatic side that a profile does not bring: corners, both sets, every side.
TEST(AdiabaticSide, LeavesAProfileAlongItOneDimensional) {
  constexpr int length = 16, width = 7;
  for (const ScalarVelocitySet set : velocity_sets)
    for (const HeatCondition end : {HeatCondition::temperature, HeatCondition::flux})
      for (const bool upright : {false, true}) {
        const auto profile = [](int k) { return std::sin(0.4 * k) + 0.1 * k; };
        HeatBox<double> box(
            upright ? width : length, upright ? length : width, {0.12, 0.12, 1, set}, [](int, int) { return false; },
            [&](int x, int y) { return profile(upright ? y : x); });
        box.side(upright ? Side::bottom : Side::left, end, 0.7);
        box.side(upright ? Side::top : Side::right, HeatCondition::temperature, 0);
        double across = 0, largest = 0;
        for (const int steps : {40, 8000}) {  // on the way and at rest
          box.run(steps);
          const std::vector<double> theta = box.theta();
          const auto at = [&](int k, int j) { return theta[upright ? k * width + j : j * length + k]; };
          for (int k = 0; k < length; ++k)
            for (int j = 1; j < width; ++j) {
              across = std::max(across, std::abs(at(k, j) - at(k, 0)));
              largest = std::max(largest, std::abs(at(k, j)));
            }
        }
        EXPECT_LE(across, 1e-13 * largest) << test::name_of(set) << " " << upright;
        record("heat_adiabatic_side", {{"set", test::name_of(set)},
                                       {"end", end == HeatCondition::flux ? "flux" : "temperature"},
                                       {"across", across / largest}});
      }
}

/// Nor in layers of fluid and rock across it.
TEST(AdiabaticSide, LeavesAProfileThroughLayersOneDimensional) {
  constexpr int length = 16, width = 5;
  for (const ScalarVelocitySet set : velocity_sets)
    for (const bool upright : {false, true}) {
      HeatBox<double> box(
          upright ? width : length, upright ? length : width, {0.12, 0.4, 2.5, set},
          [&](int x, int y) { return (upright ? y : x) / 5 % 2 == 1; }, [](int, int) { return 0.0; });
      box.side(upright ? Side::bottom : Side::left, HeatCondition::temperature, 1);
      box.side(upright ? Side::top : Side::right, HeatCondition::temperature, 0);
      double across = 0;
      for (const int steps : {40, 8000}) {
        box.run(steps);
        const std::vector<double> theta = box.theta();
        const auto at = [&](int k, int j) { return theta[upright ? k * width + j : j * length + k]; };
        for (int k = 0; k < length; ++k)
          for (int j = 1; j < width; ++j) across = std::max(across, std::abs(at(k, j) - at(k, 0)));
      }
      EXPECT_LE(across, 1e-13) << test::name_of(set) << " " << upright;
    }
}

/// A box whose sides are all adiabatic keeps its energy and, when it is uniform, its temperature, whatever rock stands
/// beside them.
TEST(AdiabaticSide, KeepsEnergyAndUniformity) {
  const auto rock = [](int x, int y) { return (3 * x + 5 * y + x * y) % 4 == 0; };
  for (const ScalarVelocitySet set : velocity_sets) {
    HeatBox<double> uniform(13, 9, {0.05, 0.3, 2.5, set}, rock, [](int, int) { return 0.7; });
    uniform.run(2000);
    for (const double theta : uniform.theta()) EXPECT_NEAR(theta, 0.7, 1e-13) << test::name_of(set);
    HeatBox<double> rough(13, 9, {0.05, 0.3, 2.5, set}, rock, [](int x, int y) { return std::sin(3 * x + y * y); });
    const double before = rough.energy();
    rough.run(5000);
    EXPECT_NEAR(rough.energy(), before, 1e-12 * 13 * 9 * 2.5) << test::name_of(set);
  }
}

}  // namespace
}  // namespace vug
