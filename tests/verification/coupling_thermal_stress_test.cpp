// Temperature of the lattice to strain of the triangles: the stress of a slab whose upper face is suddenly cold.
#include "dem/mean_stress.hpp"
#include "dem_support.hpp"
#include "support/coupled_run.hpp"
#include "support/record.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

namespace vug {
namespace {

/// 8 cm x 1.5 cm at 400 K, face at 300 K, on a roller so that it does not bend; bonds that never break.
const std::string slab = R"(
[lattice]
size = [0.08, 0.015]
spacing = 5e-4
time_step = 1e-6
[time]
steps = 300
[geometry]
type = "rock"
[rock]
element_size = 1.5e-3
[heat]
fluid_diffusivity = 0.03
solid_diffusivity = 0.03
initial_temperature = 400
[mechanics]
thermal_expansion = 8e-6
local_damping = 0.3
[mechanics.bond]
normal_strength = 1e12
cohesion = 1e12
[boundary.bottom]
traction = { support = "roller" }
[boundary.top]
heat = { type = "temperature", temperature = 300 }
)";

constexpr double height = 0.015, drop = 100, modulus = 27.8e9, expansion = 8e-6;

/// Temperature change of a slab whose upper face has been cold for the time in which the cold comes down by `length`
/// and whose lower face is insulated (Carslaw & Jaeger, Conduction of Heat in Solids, 3.3): images of the face.
double change(double depth, double length) {
  double sum = 0;
  for (int n = 0; n < 6; ++n)
    sum += (n % 2 == 0 ? 1 : -1) *
           (std::erfc((2 * n * height + depth) / length) + std::erfc((2 * (n + 1) * height - depth) / length));
  return -drop * sum;
}

/// Stress of a slab that stays flat: what is colder than the mean is in tension.
double slab_stress(double depth, double length) {
  double mean = 0;
  for (int k = 0; k < 4000; ++k) mean += change(height * (k + 0.5) / 4000, length) / 4000;
  return modulus * expansion * (mean - change(depth, length));
}

TEST(CooledSlab, HasTheStressOfTheErrorFunction) {
  test::CoupledRun run(slab);
  run.steps(300);
  const double length = 2 * std::sqrt(0.03 * 300e-6);  // of diffusion
  const Particles& particles = run.rock().particles();
  const auto x0 = test::host_copy(particles.x0);
  for (double depth = 3e-3; depth < 0.012; depth += 2e-3) {
    std::vector<int> layer;
    double exact = 0;
    for (int i = 0; i < particles.count; ++i) {
      if (std::abs(height - x0(i, 1) - depth) > 1e-3 || std::abs(x0(i, 0) - 0.04) > 0.015) continue;
      layer.push_back(i);
      exact += slab_stress(height - x0(i, 1), length);
    }
    exact /= static_cast<double>(layer.size());
    const double stress = mean_stress(particles, run.rock().bonds(), layer).xx;
    test::record("coupling_thermal_stress", {{"depth", depth}, {"stress", stress}, {"exact", exact}});
    // 0.7 % at most; 0.5 % where the closed form itself heats the slab (quench_test.cpp)
    EXPECT_NEAR(stress, exact, 0.01 * modulus * expansion * drop) << depth;
  }
}

}  // namespace
}  // namespace vug
