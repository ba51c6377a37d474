#include "coupling/reaction_module.hpp"

#include "coupling/face_temperature.hpp"
#include "coupling/joint_reactions.hpp"
#include "coupling/read_fields.hpp"
#include "coupling/sum_state.hpp"
#include "io/units.hpp"
#include "kernels/flow/guards.hpp"
#include "kernels/launch/launch.hpp"
#include "kernels/reaction/reactive_wall_kernel.hpp"
#include "kernels/reaction/solid_share.hpp"
#include "kernels/reaction/surface_normal.hpp"

#include <algorithm>

namespace vug {

namespace {

/// V = 1 in solid, 0 in fluid, over the interior.
struct FillVolume {
  Kokkos::View<const NodeType*> type;
  Lattice lattice;
  ScalarField<double> volume;
  KOKKOS_FUNCTION void operator()(int item) const {
    const int n = lattice.node(item % lattice.nx, item / lattice.nx);
    volume(n) = type(n) == NodeType::solid ? 1 : 0;
  }
};

/// The rates of reactant number r on all minerals, beginning with rock.
std::vector<RateLaw> rates_of(const Scene& scene, const RateLaw& of_rock, std::size_t r) {
  std::vector<RateLaw> rates{of_rock};
  for (const MineralSection& mineral : scene.minerals) rates.push_back(mineral.rates[r]);
  return rates;
}

}  // namespace

template <class T, class Set>
ReactionModule<T, Set>::ReactionModule(const Exec& exec, const Scene& scene, const LatticeUnits& units,
                                       Geometry& geometry, SoluteModule<T, Set>& solutes, const HeatModule<T>* heat,
                                       PathwayOpener* opener)
    : section_(*scene.reaction),
      units_(units),
      geometry_(geometry),
      solutes_(solutes),
      heat_(heat),
      wall_interval_(scene.accuracy.wall_interval),
      factor_(scene.accuracy.dissolution_factor),
      varies_(scene.accuracy.dissolution_tolerance > 0),
      watches_(scene.accuracy.chooses_intervals()),
      solute_interval_(scene.accuracy.solute_interval),
      dissolves_(rock_dissolves(scene)) {
  const Lattice& lattice = geometry.lattice;
  geometry.volume = ScalarField<double>("vug::reaction::volume", lattice.size());
  geometry.dissolved = ScalarField<double>("vug::reaction::dissolved", lattice.size());
  for_each_node(exec, "vug::reaction::fill", lattice.nx * lattice.ny,
                FillVolume{geometry.type, lattice, geometry.volume});
  const double waiting = opener ? opener->return_solid(exec, geometry.type, geometry.volume, geometry.dissolved) : 0;
  const ScalarField<double> lost("vug::reaction::lost", block_count(lattice.size()));
  if (dissolves_) losses_.all = lost;
  lost_ = lost;
  initial_volume_ = sum_in_order(geometry.volume) + waiting;
  if (has_minerals()) set_up_minerals(scene, waiting);

  attacks_.resize(1 + section_.further.size());
  for (std::size_t r = 0; r < attacks_.size(); ++r) {
    Attack<T>& attack = attacks_[r];
    const FurtherReactant* further = r > 0 ? &section_.further[r - 1] : nullptr;
    if (further) attack.key = further->reactant;
    attack.rate = further ? static_cast<const RateLaw&>(*further) : section_;
    if (has_minerals()) attack.rates = rates_of(scene, attack.rate, r);
    attack.reactant = &solutes.species(further ? further->reactant : section_.reactant);
    const auto& product = further ? further->product : section_.product;
    if (product) attack.product = &solutes.species(*product);
    set_up(attack);
  }
  find_links(exec);
  std::vector<ReactingSpecies<T>> reacting;
  for (Attack<T>& attack : attacks_)
    reacting.push_back({&attack.wall, &attack.links, attack.reactant, attack.product, attack.state_key()});
  solutes.react(std::move(reacting), reactions_depend(scene));
}

template <class T, class Set>
void ReactionModule<T, Set>::find_links(const Exec& exec) {
  for (Attack<T>& attack : attacks_)
    find_reactive_links<Set>(exec, geometry_.fluid, geometry_.surface, attack.wall.law, attack.links,
                             geometry_.mineral);
  if (dissolves_) make_room_for_losses(exec);
  share_links();
}

template <class T, class Set>
void ReactionModule<T, Set>::refresh(const Exec& exec, std::int64_t step) {
  // At the start everything changes in proportion to the time so far.
  const std::int64_t next = std::clamp<std::int64_t>(step / 8, 1, wall_interval_);
  const bool links_are_new = refreshed_ < 0;
  if (!links_are_new && step - refreshed_ < next) return;
  const double ahead = links_are_new ? 0 : 0.5 * static_cast<double>(next) / static_cast<double>(step - refreshed_);
  refreshed_ = step;
  if (section_.surface_normal)
    find_normals(exec, geometry_.fluid, geometry_.surface, geometry_.volume, geometry_.dissolved, normal_,
                 our_surface());
  for (Attack<T>& attack : attacks_) set_rates(exec, attack, ahead);
}

template <class T, class Set>
void ReactionModule<T, Set>::set_rates(const Exec& exec, Attack<T>& attack, double ahead) {
  const auto set = [&](const auto& rate) {
    set_conductances<Set>(exec, geometry_.fluid, geometry_.surface, attack.wall, rate, normal_, attack.links, ahead);
  };
  const double k0 = scaled(attack.rate), activation = attack.rate.activation_energy / gas_constant;
  const double reference = section_.reference_temperature;
  const MineralRates& minerals = attack.wall.minerals;
  if (minerals.given() && heat_)
    set(MineralArrhenius<FaceTemperature<T>>{minerals, reference, heat_->face_temperature(exec, temperatures_)});
  else if (minerals.given())
    set(MineralArrhenius<UniformTemperature>{minerals, reference, {section_.temperature}});
  else if (heat_)
    set(ArrheniusRate<FaceTemperature<T>>{k0, activation, reference, heat_->face_temperature(exec, temperatures_)});
  else
    set(ArrheniusRate<UniformTemperature>{k0, activation, reference, {section_.temperature}});
}

template <class T, class Set>
void ReactionModule<T, Set>::step(const Exec& exec, const Clock& clock) {
  if (factor_of_walls_ != factor_)  // after a checkpoint was loaded
    for (Attack<T>& attack : attacks_) set_volumes(attack);
  refresh(exec, clock.step);
  if (clock.every(LongSum::interval))
    for (const Attack<T>& attack : attacks_) attack.consumed.settle(exec);
}

template <class T, class Set>
void ReactionModule<T, Set>::book(const Exec& exec) {
  gather_links();
  for (Attack<T>& attack : attacks_)
    book_turnover(exec, geometry_.surface, attack.wall, attack.links, attack.sums, wall_losses_,
                  &attack == &attacks_.front());
}

template <class T, class Set>
void ReactionModule<T, Set>::set_factor(const Exec& exec, double factor) {
  book(exec);
  for (Attack<T>& attack : attacks_) {
    const std::vector<double> acid =
        has_minerals() ? acid_of_minerals(attack) : std::vector<double>{attack.consumed.total()};
    for (std::size_t m = 0; m < acid.size(); ++m) attack.aged[m].change(acid[m], factor_);
  }
  factor_ = factor;
  for (Attack<T>& attack : attacks_) set_volumes(attack);
}

template <class T, class Set>
double ReactionModule<T, Set>::largest_loss(const Exec& exec) {
  gather_links();
  const Surface& surface = geometry_.surface;
  if (static_cast<int>(loss_.extent(0)) < surface.count)
    loss_ = ScalarField<double>("vug::reaction::loss", surface.node.extent(0));
  Kokkos::deep_copy(exec, loss_, 0.0);
  for (const Attack<T>& attack : attacks_) add_losses(exec, surface, attack.wall, attack.links, loss_);
  return field_range(exec, loss_, surface.count).max;
}

template <class T, class Set>
void ReactionModule<T, Set>::births(const Exec& exec, const Births&) {
  find_links(exec);
  refreshed_ = -1;
}

template <class T, class Set>
void ReactionModule<T, Set>::fields(FieldList& list) const {
  list.lattice.push_back({"dissolved_fraction", "1", 1, [this] { return read_solid(geometry_, dissolved_share); }});
}

template <class T, class Set>
void ReactionModule<T, Set>::state(StateList& list) {
  list.add("reaction/volume", geometry_.volume);
  list.add("reaction/dissolved", geometry_.dissolved);
  list.add("reaction/lost", lost_);
  list.add_value("reaction/initial_volume", initial_volume_);
  list.add_value("reaction/refreshed", refreshed_, {-1, most_steps});
  if (watches_) list.add_value("reaction/watched_volume", watched_);
  if (varies_) list.add_value("reaction/factor", factor_, {1, 1e6});
  for (std::size_t m = 0; m < solids_.size(); ++m)
    list.add("reaction/lost/" + std::to_string(m), losses_.of_minerals.lost[m]);
  for (Attack<T>& attack : attacks_) {
    const std::string key = attack.state_key();
    add_state(list, key + "/consumed", attack.consumed);
    if (watches_) list.add_value(key + "/watched", attack.watched);
    if (attack.sums.released.extent(0) > 0) list.add(key + "/released", attack.sums.released);
    if (attack.sums.acid.extent(0) > 0) list.add(key + "/acid", attack.sums.acid);
    const ReactiveLinks<T>& links = attack.links;
    const std::pair all(0, links.count);
    list.add(key + "/link_acid", Kokkos::subview(links.acid, all));  // not booked yet
    if (attack.wall.law != ReactiveWallLaw::kinetic) {
      list.add(key + "/link_product", Kokkos::subview(links.product, all));
      list.add(key + "/link_solid", Kokkos::subview(links.solid, all));
    }
    for (std::size_t m = 0; varies_ && m < attack.aged.size(); ++m) {
      list.add_value(key + "/aged" + std::to_string(m), attack.aged[m].earlier);
      list.add_value(key + "/seen" + std::to_string(m), attack.aged[m].seen);
    }
    list.add(key + "/link_rate", Kokkos::subview(links.rate, all));
    list.add(key + "/link_conductance", Kokkos::subview(links.conductance, all));
  }
}

template class ReactionModule<float, D2Q5>;
template class ReactionModule<float, D2Q9>;
template class ReactionModule<double, D2Q5>;
template class ReactionModule<double, D2Q9>;

}  // namespace vug
