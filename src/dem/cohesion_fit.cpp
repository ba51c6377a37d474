#include "base/require.hpp"
#include "dem/laboratory.hpp"

#include <cmath>
#include <string>
#include <vector>

namespace vug {

CohesionFit fit_cohesion(const Exec& exec, const Assembly& specimen, MechanicsParameters parameters,
                         const TestOfRock& test, double strength, int seeds, double tolerance) {
  constexpr int most_rounds = 10;
  const std::uint64_t first = parameters.bond.seed;
  CohesionFit fit;
  while (fit.rounds < most_rounds) {
    ++fit.rounds;
    std::vector<double> strengths;
    for (int s = 0; s < seeds; ++s) {
      parameters.bond.seed = first + static_cast<std::uint64_t>(s);
      const PlatenResult loaded = load_between_platens(exec, specimen, parameters, test(parameters));
      if (loaded.preload && (!loaded.preload->settled || broken(loaded.preload->bonds) > 0))
        fit.restless = loaded.preload;
      if (!loaded.passed_a_peak())
        throw InputError(
            "laboratory: a specimen did not pass a peak of stress, so that it has no strength to fit; raise "
            "laboratory.largest_strain, or laboratory.temperature_change where it is heated");
      strengths.push_back(loaded.strength);
    }
    fit.strength = spread_of(strengths);
    fit.cohesion = parameters.bond.cohesion;
    if (std::abs(fit.strength.mean / strength - 1) <= tolerance) return fit;
    parameters.bond.cohesion *= strength / fit.strength.mean;
    for (RockMaterial& material : parameters.materials)  // a case that does not set it has given them that of the rock
      if (material.bond.cohesion == fit.cohesion) material.bond.cohesion = parameters.bond.cohesion;
  }
  throw InputError("laboratory: no cohesion found that gives a strength of " + std::to_string(strength) +
                   " Pa; is the tensile strength or the friction too large for it, or does the rock break where a "
                   "material has a cohesion of its own?");
}

}  // namespace vug
