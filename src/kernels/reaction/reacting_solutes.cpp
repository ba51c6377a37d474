#include "kernels/reaction/reactive_wall.hpp"
#include "kernels/reaction/reactive_wall_step.hpp"
#include "kernels/solute/solute_sweep.hpp"

namespace vug {

namespace {

struct NoSweep {
  [[maybe_unused]] void operator()(int, int) const {}
};

/// Number of blocks that a sweep runs over before the next sweep does. Fewer are mostly the beginning of memory
/// streams, which the processor does not predict; more do not stay in the cache.
[[maybe_unused]] constexpr int blocks_at_a_time = 4;

/// Runs the sweeps of some nodes, then the reaction at their links.
template <class Reactant, class Product, class React>
struct SweepAndReact {
  Reactant reactant;
  Product product;
  React react;
  IndexList first;
  int block;
  void operator()(int begin, int end) const {
    in_blocks(reactant, begin, end);
    in_blocks(product, begin, end);
    react(first(begin), first(end));
  }

 private:
  template <class Sweep>
  void in_blocks(const Sweep& sweep, int begin, int end) const {
    for (int i = begin; i < end; i += block) sweep(i, i + block < end ? i + block : end);
  }
};
// Clang deduces the arguments of aggregates by itself from version 17 on.
template <class Reactant, class Product, class React>
SweepAndReact(Reactant, Product, React, IndexList, int) -> SweepAndReact<Reactant, Product, React>;

/// The step by the kinetic law.
template <class Set, class T>
void sweep_and_react(const Exec& exec, const FluidNodes& nodes, const SoluteCarrier<T>& carrier,
                     const ReactiveWall& wall, const ReactiveLinks<T>& links, const SteppingSolute<T>& reactant,
                     const SteppingSolute<T>* product) {
  KOKKOS_ASSERT(!product || product->fields.turned == reactant.fields.turned);
  visit_flow(carrier, [&](const auto& flow) {
    visit_slots<Set>(nodes, reactant.fields.turned, [&](const auto& slots) {
      const auto sweep_of = [&](const SteppingSolute<T>& s) {
        return sweep_of_block(nodes, solute_sweep<Set>(slots, s.parameters, s.fields, flow), s.correction);
      };
      const auto launch = [&](const auto& its_product, const auto& sweep_of_product) {
        const int block = sweep_block_size<std::decay_t<decltype(flow)>>(nodes.count);
        visit_rock<T, Set>(wall, [&](const auto& rock) {
          using Step = KineticStep<T, std::decay_t<decltype(rock)>, std::decay_t<decltype(its_product)>>;
          const detail::NodeLoop<Step, false> react{
              {rock, links, reactant.fields.h, its_product, reactant.fields.rounding.at_links}};
          for_each_block(exec, "vug::solute::advance_and_react", nodes.share(),
                         SweepAndReact{sweep_of(reactant), sweep_of_product, react, links.first, block},
                         blocks_at_a_time * block);
        });
      };
      if (product)
        launch(WithProduct<T>{product->fields.h, product->fields.C}, sweep_of(*product));
      else
        launch(NoProduct{}, NoSweep{});
    });
  });
  reactant.fields.turned = 1 - reactant.fields.turned;
  if (product) product->fields.turned = 1 - product->fields.turned;
}

}  // namespace

template <class Set, class T>
void advance_reacting_solutes(const Exec& exec, const FluidNodes& nodes, const SoluteCarrier<T>& carrier,
                              const ReactiveWall& wall, const ReactiveLinks<T>& links,
                              const SteppingSolute<T>& reactant, const SteppingSolute<T>* product) {
  if (!runs_on_host || wall.law != ReactiveWallLaw::kinetic) {
    advance_solute<Set>(exec, nodes, carrier, reactant);
    if (product) advance_solute<Set>(exec, nodes, carrier, *product);
    react_at_wall<Set>(exec, nodes, wall, links, reactant.fields, product ? &product->fields : nullptr);
  } else if constexpr (runs_on_host) {
    require_product(wall, product != nullptr);
    sweep_and_react<Set>(exec, nodes, carrier, wall, links, reactant, product);
  }
}

VUG_COMPILE_FOR_SETS(advance_reacting_solutes)

}  // namespace vug
