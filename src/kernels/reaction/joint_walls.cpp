#include "kernels/reaction/joint_walls.hpp"

#include "kernels/launch/launch.hpp"

namespace vug {

namespace {

/// What the kernel needs of a reaction.
template <class T>
struct AtLinks {
  LinkReaction of_rock;                   ///< constants of rock of one kind
  Kokkos::View<const MineralRate*> rate;  ///< (mineral) empty: those
  ScalarField<T> conductance;
  ScalarField<double> acid;

  AtLinks() = default;
  explicit AtLinks(const JointReaction<T>& from)
      : rate(from.wall.minerals.rate), conductance(from.links.conductance), acid(from.links.acid) {
    of_rock.equilibrium = from.wall.inverse_equilibrium;
    of_rock.yield = from.wall.product_yield;
    of_rock.reference = from.wall.reference_concentration;
    of_rock.reactant = from.reactant;
    of_rock.product = from.product;
  }
  KOKKOS_FORCEINLINE_FUNCTION LinkReaction at(int l, int mineral) const {
    LinkReaction now = of_rock;
    now.conductance = conductance(l);
    if (rate.extent(0) == 0) return now;
    now.equilibrium = rate(mineral).inverse_equilibrium;
    now.yield = rate(mineral).product_yield;
    now.order = rate(mineral).order;
    return now;
  }
};

template <class T, class Set>
struct JointStep {
  int count, species;
  Kokkos::Array<AtLinks<T>, most_joint_reactions> reaction;
  Kokkos::Array<ScalarField<T>, 2 * most_joint_reactions> h;
  IndexList slots, root;
  Kokkos::View<const std::uint8_t*> mineral;
  Rounding<T> rounding;

  KOKKOS_FUNCTION void operator()(int l) const {
    const int slot = slots(l), of_rock = mineral.extent(0) > 0 ? mineral(l) : 0;
    LinkReaction at[most_joint_reactions];
    double A[2 * most_joint_reactions], J[most_joint_reactions], gain[2 * most_joint_reactions];
    for (int s = 0; s < species; ++s) {
      A[s] = h[s](slot);
      gain[s] = 0;
    }
    for (int i = 0; i < count; ++i) at[i] = reaction[i].at(l, of_rock);
    joint_fluxes(at, count, A, Set::w(root(l) % 8 + 1), J);
    for (int i = 0; i < count; ++i) {
      const T taken = T(J[i]);
      reaction[i].acid(l) += double(taken);
      gain[at[i].reactant] -= double(taken);
      if (at[i].product >= 0) gain[at[i].product] += double(T(at[i].yield) * taken);
    }
    for (int s = 0; s < species; ++s) h[s](slot) = rounding.sum(h[s](slot), T(gain[s]), l);
  }
};

}  // namespace

template <class Set, class T>
void react_jointly(const Exec& exec, const JointReactions<T>& reactions) {
  const ReactiveLinks<T>& links = reactions.reaction[0].links;
  JointStep<T, Set> step{reactions.count, reactions.species, {}, reactions.h, links.slot, links.root,
                         links.mineral,   reactions.rounding};
  for (int i = 0; i < reactions.count; ++i) step.reaction[i] = AtLinks<T>(reactions.reaction[i]);
  for_each_node<false>(exec, "vug::reactive_wall::react_jointly", links.share(), step);
}

VUG_COMPILE_FOR_SETS(react_jointly)

}  // namespace vug
