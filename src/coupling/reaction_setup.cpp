// The reactions of a case in the units of its steps: minerals, the constants of the walls, the volume that acid
// dissolves.
#include "coupling/minerals.hpp"
#include "coupling/reaction_module.hpp"
#include "io/units.hpp"
#include "kernels/launch/launch.hpp"

namespace vug {

template <class T, class Set>
void ReactionModule<T, Set>::set_up_minerals(const Scene& scene, double waiting) {
  std::vector<double> initial =
      sums_by_mineral(Exec{}, "vug::minerals::initial", geometry_.lattice.size(), geometry_.volume, geometry_.mineral,
                      static_cast<int>(scene.minerals.size()) + 1);
  initial[0] += waiting;
  const std::vector<std::string> names = mineral_names(scene);
  losses_.of_minerals.of_node = geometry_.mineral;
  for (std::size_t m = 0; m < names.size(); ++m) {
    const bool there = initial[m] > 0;
    solids_.push_back({there ? names[m] : "",
                       m == 0                        ? section_.molar_volume
                       : scene.minerals[m - 1].inert ? 0
                                                     : scene.minerals[m - 1].molar_volume,
                       initial[m]});
    losses_.names.push_back(solids_.back().name);
    losses_.of_minerals.lost.emplace_back("vug::minerals::lost", block_count(geometry_.lattice.size()));
  }
}

template <class T, class Set>
void ReactionModule<T, Set>::set_up(Attack<T>& attack) {
  ReactiveWall& wall = attack.wall;
  wall.law = section_.wall;
  wall.inverse_equilibrium = attack.rate.inverse_equilibrium_constant;
  wall.product_yield = attack.rate.product_yield();
  wall.reference_concentration = section_.reference_concentration / units_.concentration;
  wall.D_reactant = attack.reactant->parameters.diffusivity();
  if (attack.product) wall.D_product = attack.product->parameters.diffusivity();
  const int size = geometry_.lattice.size();
  attack.consumed = LongSum("vug::reaction::consumed", block_count(size));
  attack.sums = {geometry_.volume, geometry_.dissolved, attack.consumed.recent(), {}, {}};
  if (wall.law == ReactiveWallLaw::paper && attack.product)
    attack.sums.released = ScalarField<double>("vug::reaction::released", size);
  if (has_minerals()) attack.sums.acid = ScalarField<double>("vug::minerals::acid", size);
  attack.aged.resize(has_minerals() ? solids_.size() : 1);
  set_volumes(attack);
}

template <class T, class Set>
void ReactionModule<T, Set>::set_volumes(Attack<T>& attack) {
  ReactiveWall& wall = attack.wall;
  factor_of_walls_ = factor_;
  wall.molar_volume = volume_per_acid(section_.molar_volume, attack.rate);
  const std::vector<RateLaw> rates = has_minerals() ? attack.rates : std::vector<RateLaw>{attack.rate};
  if (!has_minerals() && attack.rate.order == 1) return;  // the constants of the wall are enough
  if (attack.table.extent(0) == 0) attack.table = Kokkos::View<MineralRate*>("vug::minerals::rate", rates.size());
  const HostWriter host(attack.table);
  for (std::size_t m = 0; m < rates.size(); ++m)
    host(m) = {scaled(rates[m]),
               rates[m].activation_energy / gas_constant,
               rates[m].inverse_equilibrium_constant,
               rates[m].order,
               volume_per_acid(solids_.empty() ? section_.molar_volume : solids_[m].molar_volume, rates[m]),
               rates[m].product_yield()};
  wall.minerals = {geometry_.mineral, attack.table};
}

template <class T, class Set>
double ReactionModule<T, Set>::scaled(const RateLaw& rate) const {
  return solute_interval_ * rate.rate_constant / units_.rate_constant();
}

#define VUG_INSTANTIATE(T, Set)                                                \
  template void ReactionModule<T, Set>::set_up_minerals(const Scene&, double); \
  template void ReactionModule<T, Set>::set_up(Attack<T>&);                    \
  template void ReactionModule<T, Set>::set_volumes(Attack<T>&);               \
  template double ReactionModule<T, Set>::scaled(const RateLaw&) const;
VUG_FOR_NUMBERS_AND_SETS(VUG_INSTANTIATE)
#undef VUG_INSTANTIATE

}  // namespace vug
