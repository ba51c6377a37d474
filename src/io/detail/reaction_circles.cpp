// Reactions that feed each other.
#include "io/detail/case_checks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace vug {
namespace {

/// Moles that a mole of the first species becomes of the second one.
using Yields = std::map<std::pair<std::string, std::string>, double>;

/// Of the single reactions of a rock with these rates, and of those that turn back.
Yields yields_of(const ReactionSection& reaction, const std::vector<RateLaw>& rates) {
  Yields most;
  const auto raise = [&](const std::string& from, const std::string& into, double yield) {
    double& known = most[{from, into}];
    known = std::max(known, yield);
  };
  const auto add = [&](const auto& species, const RateLaw& rate) {
    if (!species.product || rate.rate_constant == 0) return;
    raise(species.reactant, *species.product, rate.product_yield());
    if (rate.inverse_equilibrium_constant > 0) raise(*species.product, species.reactant, 1 / rate.product_yield());
  };
  add(reaction, rates[0]);
  for (std::size_t r = 0; r < reaction.further.size(); ++r) add(reaction.further[r], rates[r + 1]);
  return most;
}

/// Warns of the first species that becomes more of itself by chains of these reactions: the largest products of yields
/// along chains, as Floyd and Warshall find shortest paths. True where there is one.
bool warn_about_a_circle(Scene& scene, Yields most) {
  const std::vector<Species>& all = scene.solute->species;
  for (const Species& by : all)
    for (const Species& from : all)
      for (const Species& into : all) {
        double& known = most[{from.name, into.name}];
        known = std::max(known, most[{from.name, by.name}] * most[{by.name, into.name}]);
      }
  constexpr double rounding = 1e-9;
  for (const Species& species : all) {
    const double again = most[{species.name, species.name}];
    if (again < 1 + rounding) continue;
    scene.warnings.push_back(fmt::format(
        "[reaction]: in a circle of reactions a mole of {} becomes {:.4g} moles of it; where that is faster "
        "than diffusion, no concentrations at the wall satisfy the rates, and results have no meaning",
        species.name, again));
    return true;
  }
  return false;
}

}  // namespace

void warn_about_circles(Scene& scene) {
  const ReactionSection& reaction = *scene.reaction;
  std::vector<RateLaw> of_rock{reaction};
  of_rock.insert(of_rock.end(), reaction.further.begin(), reaction.further.end());
  bool warned = warn_about_a_circle(scene, yields_of(reaction, of_rock));
  for (std::size_t m = 0; m < scene.minerals.size() && !warned; ++m)
    if (!scene.minerals[m].inert) warned = warn_about_a_circle(scene, yields_of(reaction, scene.minerals[m].rates));
}

}  // namespace vug
