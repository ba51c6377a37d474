#pragma once
// Reactions at the same walls that depend on each other through their species.
#include "coupling/solute_module.hpp"
#include "kernels/reaction/joint_walls.hpp"

#include <vector>

namespace vug {

/// Whether a reaction of the case reads what another one changes: its reactant, or its product where that turns back.
/// Two that only have an irreversible product in common do not. Throws InputError where more than most_joint_reactions
/// do.
bool reactions_depend(const Scene& scene);

/// The pairs as one reaction of several species, for this step.
template <class T>
JointReactions<T> joined(const std::vector<ReactingSpecies<T>>& pairs);

}  // namespace vug
