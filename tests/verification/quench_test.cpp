// Thermal shock of a slab: stress before it cracks against the closed form, crack pattern against published trends.
#include "dem/quench.hpp"

#include "dem/mean_stress.hpp"
#include "dem_support.hpp"
#include "io/rock_generator.hpp"
#include "support/record.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace {

using namespace vug;
using vug::test::host_copy;
using vug::test::record;

Assembly slab(double width, double height, double element) {
  RockSection rock;
  rock.element_size = element;
  return generate_rock(width, height, rock);
}

// Heat that has left by a time is what has passed the face until then: the two sides of an energy balance, of which one
// knows the roots only through the mean, the other through the face. A large Biot number is a face that is cold at
// once.
TEST(SlabCooling, LosesThroughItsFaceWhatItsMeanTemperatureSays) {
  const double drop = 100, height = 0.02;
  for (const double biot : {0.1, 1.5, 5.0, 40.0}) {
    const SlabCooling cooling(drop, height, biot);
    double lost =
        0;  // per area and heat capacity: integral of kappa biot / H (face + drop) dt, with length = 2 sqrt(kappa t)
    const int steps = 4000;
    const double from = 0.01 * height, to = 1.5 * height;
    const auto mean = [&](double length) {
      double sum = 0;
      for (int k = 0; k < 4000; ++k) sum += cooling.change(height * (k + 0.5) / 4000, length) / 4000;
      return sum;
    };
    for (int k = 0; k < steps; ++k) {
      const double length = from + (to - from) * (k + 0.5) / steps;
      lost += biot / height * (cooling.change(0, length) + drop) * 0.5 * length * (to - from) / steps;
    }
    EXPECT_NEAR(lost / height, mean(from) - mean(to), 1e-5 * drop) << biot;
  }
  const SlabCooling film(drop, height, 1e7), cold(drop, height);
  for (const double length : {0.3 * height, height})
    for (const double depth : {0.0, 0.2 * height, height})
      EXPECT_NEAR(film.change(depth, length), cold.change(depth, length), 1e-4 * drop);
}

/// Beyond eight times its height nothing is left of the slow decay 4/pi exp(-(pi length/(4 H))^2) of the closed form.
TEST(SlabCooling, EndsCold) {
  const double drop = 100, height = 0.02;
  const SlabCooling cold(drop, height);
  const double left =
      4 / std::acos(-1.0) * std::exp(-std::pow(std::acos(-1.0) / 4 * 6, 2));  // at 6 H, at the mid-plane
  EXPECT_NEAR(1 + cold.change(height, 6 * height) / drop, left, 1e-13);
  for (const double length : {7.9 * height, 8.1 * height, 1e3 * height, 1e300})
    for (const double depth : {0.0, 0.3 * height, height}) EXPECT_NEAR(cold.change(depth, length), -drop, 1e-12 * drop);
  EXPECT_NEAR(cold.mean_change(0.2 * height), -drop * 0.2 / std::sqrt(std::acos(-1.0)), 1e-6 * drop);  // half a space
}

TEST(Quench, StressBeforeCracksIsThatOfTheErrorFunction) {
  const double height = 0.015, drop = 100, length = 0.006, modulus = 27.8e9;
  MechanicsParameters parameters;
  parameters.bond.normal_strength = parameters.bond.cohesion = 1e15;
  const SlabCooling cooling(drop, height);
  QuenchTest test;
  test.drop = drop;
  test.final_length = length;
  test.samples = 50;
  test.duration = 3e-4;
  quench(Exec(), slab(0.08, height, 1.5e-3), parameters, test, [&](const Mechanics& rock, double now, bool last) {
    if (!last) return;
    const auto x0 = host_copy(rock.particles().x0);
    for (double depth = 3e-3; depth < 0.012; depth += 2e-3) {
      std::vector<int> layer;
      double mean_exact = 0;
      for (int i = 0; i < rock.particles().count; ++i) {
        if (std::abs(height - x0(i, 1) - depth) > 1e-3 || std::abs(x0(i, 0) - 0.04) > 0.015) continue;
        layer.push_back(i);
        mean_exact += cooling.stress(modulus, parameters.thermal_expansion, height - x0(i, 1), now);
      }
      mean_exact /= static_cast<double>(layer.size());
      const double stress = mean_stress(rock.particles(), rock.bonds(), layer).xx;
      record("quench_stress", {{"depth", depth}, {"stress", stress}, {"exact", mean_exact}});
      // one layer of elements scatters by 0.5 %
      EXPECT_NEAR(stress, mean_exact, 0.01 * modulus * parameters.thermal_expansion * drop);
    }
  });
}

TEST(QuenchLong, CracksStandCloserTheHarderTheShockAndEndInTheCompressedCore) {
  const double width = 0.06, height = 0.015, element = 1e-3;
  const Assembly block = slab(width, height, element);
  std::vector<QuenchResult> results;
  const std::vector<double> drops = {100, 150, 200, 300, 400};
  for (const double drop : drops) {
    QuenchTest test;
    test.drop = drop;
    test.final_length = 2 * height;
    results.push_back(quench(Exec(), block, {}, test, [&](const Mechanics& rock, double, bool last) {
      if (!last) return;
      const auto state = host_copy(rock.bonds().state);
      const auto vertex = host_copy(rock.bonds().vertex);
      for (int k = 0; k < rock.bonds().count; ++k) {
        if (!has_failed(state(k))) continue;
        const auto &p = block.vertices[vertex(k, 0)], &q = block.vertices[vertex(k, 1)];
        record("quench_cracks", {{"drop", drop}, {"x0", p[0]}, {"y0", p[1]}, {"x1", q[0]}, {"y1", q[1]}});
      }
    }));
    const QuenchResult& r = results.back();
    record("quench", {{"drop", drop},
                      {"spacing", r.spacing},
                      {"mean_depth", r.mean_depth},
                      {"deepest", r.deepest},
                      {"failed", r.bonds_at_end.failed()}});
  }
  for (std::size_t i = 1; i < results.size(); ++i) EXPECT_LT(results[i].spacing, results[i - 1].spacing) << drops[i];
  // weakest bonds of 15 MPa hold E alpha dT of 50 to 70 K: at 100 K a single crack or two, at 400 K many
  EXPECT_GT(results.front().spacing, 4 * results.back().spacing);
  // where the closed form has its core under pressure at the height of the shock, cracks end or turn
  for (const QuenchResult& r : results) EXPECT_LT(r.mean_depth, 0.6 * height);
}

}  // namespace
