#pragma once
// Several reactions at the same walls of which one reads what another one changes (joint_fluxes.hpp).
#include "kernels/reaction/joint_fluxes.hpp"
#include "kernels/reaction/reactive_wall.hpp"

namespace vug {

/// A reaction among others.
template <class T>
struct JointReaction {
  ReactiveWall wall;
  ReactiveLinks<T> links;  ///< the same links as those of the others, with conductances and turnover of its own
  int reactant = 0, product = -1;
};

/// All of them, and the populations of their species, numbered as the reactions name them.
template <class T>
struct JointReactions {
  int count = 0, species = 0;
  Kokkos::Array<JointReaction<T>, most_joint_reactions> reaction;
  Kokkos::Array<ScalarField<T>, 2 * most_joint_reactions> h;
  Rounding<T> rounding;
};

/// One step of all reactions at all links, by the kinetic law: each sees at the wall what all of them make of the
/// concentrations in this step, in whatever order they are given. Conserves as react_at_wall does.
template <class Set, class T>
void react_jointly(const Exec& exec, const JointReactions<T>& reactions);

}  // namespace vug
