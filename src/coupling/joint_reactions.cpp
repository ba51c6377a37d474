#include "coupling/joint_reactions.hpp"

#include "base/require.hpp"

#include <fmt/format.h>

#include <optional>
#include <string>

namespace vug {

bool reactions_depend(const Scene& scene) {
  struct Pair {
    std::string reactant;
    std::optional<std::string> product;
    bool reversible;
  };
  const ReactionSection& reaction = *scene.reaction;
  std::vector<Pair> pairs;
  const auto add = [&](const auto& species) {
    pairs.push_back({species.reactant, species.product, turns_back(scene, pairs.size())});
  };
  add(reaction);
  for (const FurtherReactant& further : reaction.further) add(further);
  bool depend = false;
  for (const Pair& of : pairs)
    for (const Pair& by : pairs) {
      if (&of == &by) continue;
      depend = depend || by.product == of.reactant;
      if (of.reversible && of.product) depend = depend || by.reactant == *of.product || by.product == of.product;
    }
  if (depend && pairs.size() > most_joint_reactions)
    throw InputError(fmt::format(
        "{}: reaction.further: one reaction reads what another one changes, and then there may be {} of them "
        "in all, not {}",
        scene.path, most_joint_reactions, pairs.size()));
  return depend;
}

template <class T>
JointReactions<T> joined(const std::vector<ReactingSpecies<T>>& pairs) {
  JointReactions<T> all;
  const auto number_of = [&](const SpeciesState<T>* species) {
    if (!species) return -1;
    int s = 0;
    while (s < all.species && all.h[s].data() != species->fields.h.data()) ++s;
    if (s == all.species) all.h[all.species++] = species->fields.h;
    return s;
  };
  for (const ReactingSpecies<T>& pair : pairs)
    all.reaction[all.count++] = {*pair.wall, *pair.links, number_of(pair.reactant), number_of(pair.product)};
  all.rounding = pairs[0].reactant->fields.rounding.at_links;
  return all;
}

VUG_COMPILE_FOR_NUMBERS(joined)

}  // namespace vug
