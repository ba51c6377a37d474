// A plate with a crack in its middle, pulled until it breaks, against the load of fracture mechanics.
#include "dem/toughness.hpp"

#include "support/specimens.hpp"

#include <gtest/gtest.h>

#include <numbers>

namespace {

using namespace vug;
using namespace vug::test;

/// Plate of 2 W x H with a horizontal crack of 2 a in its middle.
struct Plate {
  double half_width, height, half_crack;  ///< m

  /// Stress at which it breaks by Griffith: K^2 = E G_I = sigma^2 pi a / cos(pi a / 2 W) (Feddersen 1966), with the
  /// crack longer by 0.42 E G_I / sigma_n^2 for its softening zone (linear softening; Planas and Elices 1992, Int. J.
  /// Fract. 55).
  double strength(const BondParameters& bond) const {
    const double a = half_crack + 0.42 * softening_length(bond);
    const double finite_width = 1 / std::cos(std::numbers::pi * a / (2 * half_width));
    return std::sqrt(elasticity_of(bond).young_modulus * bond.fracture_energy_I /
                     (std::numbers::pi * a * finite_width));
  }

  /// Triangles that are three times smaller at the crack's tips than far away, there of the size `edge`.
  Assembly generated(double edge, std::uint64_t seed) const {
    RockSection rock = elements(1.85 * edge, seed);
    rock.grading = 4;
    rock.notches = {{{half_width - half_crack, height / 2}, {half_width + half_crack, height / 2}}};
    return generate_rock(2 * half_width, height, rock);
  }

  /// Rows of equilateral triangles with the crack on a row: its path is straight.
  Assembly regular(double edge) const {
    const double row_height = std::sqrt(0.75) * edge;
    const double tall = 4 * row_height * std::round(height / (4 * row_height));  // the middle row is not a shifted one
    Assembly plate = block(2 * half_width, tall, edge, 0);
    std::vector<int> row;
    for (int v = 0; v < static_cast<int>(plate.vertices.size()); ++v) {
      const auto [x, y] = plate.vertices[static_cast<std::size_t>(v)];
      if (std::abs(y - tall / 2) < 1e-9 && std::abs(x - half_width) < half_crack + 1e-9) row.push_back(v);
    }
    for (std::size_t i = 0; i + 1 < row.size(); ++i) plate.initial_cracks.push_back({row[i], row[i + 1]});
    return plate;
  }
};

constexpr Plate plate{0.026, 0.07, 0.008};

BondParameters without_scatter() {
  BondParameters bond;
  bond.weibull_shape = 0;
  return bond;
}

/// Strength over that of fracture mechanics, the bonds' energies over `ratio`.
double strength_ratio(const Assembly& assembly, double ratio) {
  MechanicsParameters parameters;
  parameters.bond = bonds_of_rock(without_scatter(), ratio);
  parameters.local_damping = 0.3;
  PlatenTest pull;
  pull.speed = -0.03;  // half of it takes 1 % off
  pull.step_fraction = 0.8;
  pull.sample_strain = 1e-6;
  pull.stop_below = 0.9;
  return load_between_platens(Exec(), assembly, parameters, pull).strength / plate.strength(without_scatter());
}

constexpr double path_ratio = 1.2;  // of the generator's triangles (docs/model.md)

TEST(Toughness, OfGeneratedRockIsItsFractureEnergyWithThePathRatio) {
  const double ratio = strength_ratio(plate.generated(1e-3, 1), path_ratio);
  EXPECT_NEAR(ratio, 1, 0.05);  // twice the scatter of seeds; 1.07 with a path ratio of 1
}

TEST(ToughnessLong, OfAStraightPathConvergesToTheFractureEnergyOfTheBonds) {
  std::vector<double> ratios;
  for (const double edge : {2e-3, 1e-3}) {
    ratios.push_back(strength_ratio(plate.regular(edge), 1));
    record("toughness_straight", {{"edge", edge}, {"ratio", ratios.back()}});
  }
  EXPECT_NEAR(ratios[1], 1, 0.05);
  EXPECT_LT(std::abs(ratios[1] - 1), 0.6 * std::abs(ratios[0] - 1));
}

TEST(ToughnessLong, OfGeneratedRockIsGriffithsWithinFivePercentForAnySeed) {
  for (const double edge : {1e-3, 2e-3}) {
    for (const double ratio : {1.0, path_ratio}) {
      std::vector<double> strengths;
      for (std::uint64_t seed = 1; seed <= 5; ++seed)
        strengths.push_back(strength_ratio(plate.generated(edge, seed), ratio));
      const Spread spread = spread_of(strengths);
      record("toughness", {{"edge", edge},
                           {"path_ratio", ratio},
                           {"mean", spread.mean},
                           {"deviation", spread.deviation},
                           {"least", *std::min_element(strengths.begin(), strengths.end())},
                           {"largest", *std::max_element(strengths.begin(), strengths.end())}});
      if (edge > 1e-3 || ratio == 1) continue;
      EXPECT_NEAR(spread.mean, 1, 0.05);
      EXPECT_LT(spread.deviation, 0.05);
    }
  }
}

}  // namespace
