// Checks of the names of species in a reaction.
#include "io/detail/case_checks.hpp"
#include "io/detail/nearest_name.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace vug {
namespace {

std::vector<std::string> names_of(const SoluteSection& solute) {
  std::vector<std::string> names;
  for (const Species& species : solute.species) names.push_back(species.name);
  return names;
}

/// Checks the names of a reactant and its product in the table `key`.
void check_pair(const TomlDocument& document, const std::string& key, const std::vector<std::string>& names,
                const std::string& reactant, const std::optional<std::string>& product) {
  const auto known = [&](const std::string& name) {
    return std::find(names.begin(), names.end(), name) != names.end();
  };
  if (!known(reactant))
    document.fail(key + ".reactant", "is not the name of a [[solute.species]]" + suggestion(reactant, names));
  if (!product) return;
  if (!known(*product))
    document.fail(key + ".product", "is not the name of a [[solute.species]]" + suggestion(*product, names));
  if (*product == reactant) document.fail(key + ".product", "is the reactant; it must be another species");
}

}  // namespace

void check_species(const TomlDocument& document, const Scene& scene) {
  if (!scene.reaction) return;
  const auto names = names_of(*scene.solute);
  const ReactionSection& reaction = *scene.reaction;
  check_pair(document, "reaction", names, reaction.reactant, reaction.product);
  for (std::size_t i = 0; i < reaction.further.size(); ++i) {
    const FurtherReactant& further = reaction.further[i];
    const std::string key = fmt::format("reaction.further.{}", i);
    check_pair(document, key, names, further.reactant, further.product);
    bool again = further.reactant == reaction.reactant;
    for (std::size_t j = 0; j < i; ++j) again = again || reaction.further[j].reactant == further.reactant;
    if (again) document.fail(key + ".reactant", "is that of an earlier reaction; each has its own");
    if (further.reactant == "acid")
      document.fail(key + ".reactant", "is what columns of the history call the first reactant; choose another name");
  }
}

}  // namespace vug
