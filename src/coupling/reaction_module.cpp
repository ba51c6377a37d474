#include "coupling/reaction_module.hpp"

#include "coupling/face_temperature.hpp"
#include "coupling/read_fields.hpp"
#include "coupling/sum_state.hpp"
#include "kernels/launch.hpp"
#include "kernels/reactive_wall_kernel.hpp"
#include "kernels/solid_share.hpp"
#include "kernels/surface_normal.hpp"

#include <algorithm>

namespace vug {

namespace {

constexpr double gas_constant = 8.314462618;  // J/(mol K)

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

}  // namespace

template <class T, class Set>
ReactionModule<T, Set>::ReactionModule(const Exec& exec, const Scene& scene, const LatticeUnits& units,
                                       Geometry& geometry, SoluteModule<T, Set>& solutes, const HeatModule<T>* heat)
    : section_(*scene.reaction),
      units_(units),
      geometry_(geometry),
      solutes_(solutes),
      reactant_(solutes.species(section_.reactant)),
      product_(section_.product ? &solutes.species(*section_.product) : nullptr),
      heat_(heat),
      wall_interval_(scene.accuracy.wall_interval),
      faster_(scene.accuracy.dissolution_factor > 1) {
  wall_.law = section_.wall;
  wall_.molar_volume = scene.accuracy.dissolution_factor * section_.molar_volume * units.concentration;
  wall_.inverse_equilibrium = section_.inverse_equilibrium_constant;
  wall_.D_reactant = reactant_.parameters.diffusivity();
  if (product_) wall_.D_product = product_->parameters.diffusivity();

  const Lattice& lattice = geometry.lattice;
  geometry.volume = ScalarField<double>("vug::reaction::volume", lattice.size());
  geometry.dissolved = ScalarField<double>("vug::reaction::dissolved", lattice.size());
  for_each_node(exec, "vug::reaction::fill", lattice.nx * lattice.ny,
                FillVolume{geometry.type, lattice, geometry.volume});
  consumed_ = LongSum("vug::reaction::consumed", block_count(lattice.size()));
  sums_ = {geometry.volume, geometry.dissolved, consumed_.recent(), {}};
  if (wall_.law == ReactiveWallLaw::paper && product_)
    sums_.released = ScalarField<double>("vug::reaction::released", lattice.size());
  lost_ = ScalarField<double>("vug::reaction::lost", block_count(lattice.size()));
  initial_volume_ = sum_in_order(geometry.volume);
  find_reactive_links<Set>(exec, geometry.fluid, geometry.surface, wall_.law, links_);
  solutes.react({&wall_, &links_, &reactant_, product_});
}

template <class T, class Set>
void ReactionModule<T, Set>::refresh(const Exec& exec, std::int64_t step) {
  // At the start all changes with the time gone by.
  const std::int64_t next = std::clamp<std::int64_t>(step / 8, 1, wall_interval_);
  const bool links_are_new = refreshed_ < 0;
  if (!links_are_new && step - refreshed_ < next) return;
  const double ahead = links_are_new ? 0 : 0.5 * static_cast<double>(next) / static_cast<double>(step - refreshed_);
  refreshed_ = step;
  if (section_.surface_normal)
    find_normals(exec, geometry_.fluid, geometry_.surface, geometry_.volume, geometry_.dissolved, normal_);
  const double k0 = solutes_.interval() * section_.rate_constant / units_.rate_constant();
  const double activation = section_.activation_energy / gas_constant;
  if (heat_) {
    const ArrheniusRate<FaceTemperature<T>> rate{k0, activation, section_.reference_temperature,
                                                 heat_->face_temperature(exec)};
    set_conductances<Set>(exec, geometry_.fluid, geometry_.surface, wall_, rate, normal_, links_, ahead);
  } else {
    const UniformRate rate{arrhenius(k0, activation, section_.temperature, section_.reference_temperature)};
    set_conductances<Set>(exec, geometry_.fluid, geometry_.surface, wall_, rate, normal_, links_, ahead);
  }
}

template <class T, class Set>
void ReactionModule<T, Set>::step(const Exec& exec, const Clock& clock) {
  refresh(exec, clock.step);
  if (clock.every(LongSum::interval)) consumed_.settle(exec);
}

template <class T, class Set>
void ReactionModule<T, Set>::book(const Exec& exec) {
  book_turnover(exec, geometry_.surface, wall_, links_, sums_);
}

template <class T, class Set>
void ReactionModule<T, Set>::births(const Exec& exec, const Births&) {
  find_reactive_links<Set>(exec, geometry_.fluid, geometry_.surface, wall_.law, links_);
  refreshed_ = -1;
}

template <class T, class Set>
void ReactionModule<T, Set>::limits(LimitTable& table) const {
  const double k0 = solutes_.interval() * section_.rate_constant / units_.rate_constant();
  const double activation = section_.activation_energy / gas_constant;
  const double D = reactant_.parameters.diffusivity();
  const auto row = [&](const char* name, double kelvin) {
    const double k = arrhenius(k0, activation, kelvin, section_.reference_temperature);
    table.push_back({"reaction", std::string("Damkohler number of a node, k dx/D, ") + name, k / D, "1", 0,
                     std::numeric_limits<double>::infinity(), ""});
  };
  const double coldest = heat_ ? heat_->coldest() : section_.temperature;
  const double hottest = heat_ ? heat_->hottest() : section_.temperature;
  if (heat_) {
    row("coldest", coldest);
    row("hottest", hottest);
  } else {
    row("at the case's temperature", section_.temperature);
  }
  const char* clamped = "beyond the range of Arrhenius' law the rate is that of its nearest end";
  table.push_back({"reaction", "lowest temperature", coldest, "K", coldest_reaction, hottest_reaction, clamped});
  table.push_back({"reaction", "highest temperature", hottest, "K", coldest_reaction, hottest_reaction, clamped});
  if (faster_)
    table.push_back({"reaction", "volume dissolved per volume of the strongest acid", wall_.molar_volume, "1", 0, 0.1 + 1e-9,
                     "lower accuracy.dissolution_factor: the error is about a third of this (docs/accuracy.md)"});
  if (wall_.law == ReactiveWallLaw::paper && Set::Q == D2Q9::Q)
    table.push_back({"reaction", "diffusivity for the paper's wall on D2Q9", D, "lattice", 0.05, 1,
                     "use reaction.wall = \"kinetic\" or solute.velocity_set = \"D2Q5\" (docs/stability.md)"});
}

template <class T, class Set>
double ReactionModule<T, Set>::dissolving() const {
  return wall_.molar_volume * sum_in_order(links_.solid);
}

template <class T, class Set>
void ReactionModule<T, Set>::ledger(Ledger& ledger) const {
  const double mol = units_.amount();
  const double consumed = consumed_.total() + sum_in_order(links_.acid);  // booked and not yet
  ledger.of(reactant_.section.name, "mol/m").gains.push_back({"reaction", -mol * consumed});
  if (product_) {
    const double released =
        sums_.released.extent(0) > 0 ? sum_in_order(sums_.released) + sum_in_order(links_.product) : consumed;
    ledger.of(product_->section.name, "mol/m").gains.push_back({"reaction", mol * released});
  }
  if (wall_.molar_volume == 0) return;
  const double dissolved = sum_in_order(geometry_.dissolved) + dissolving();
  Balance& solid = ledger.of("solid_volume", "m3/m");
  solid.initial = units_.volume() * initial_volume_;
  solid.stored = units_.volume() * (sum_in_order(geometry_.volume) - dissolving());
  solid.gains.push_back({"dissolved", -units_.volume() * dissolved});
  solid.gains.push_back({"overdrawn", -units_.volume() * sum_in_order(lost_)});
  Balance& reaction = ledger.of("dissolved_volume", "m3/m");
  reaction.stored = units_.volume() * dissolved;
  reaction.gains.push_back({"acid_times_molar_volume", units_.volume() * wall_.molar_volume * consumed});
}

template <class T, class Set>
void ReactionModule<T, Set>::history(std::vector<HistoryValue>& row) const {
  VectorField<double> normal;
  if (section_.surface_normal)
    find_normals(Exec{}, geometry_.fluid, geometry_.surface, geometry_.volume, geometry_.dissolved, normal);
  const double area = surface_area<Set>(Exec{}, geometry_.fluid, geometry_.surface, normal);
  row.push_back({"reactive_area_m2_per_m", area * units_.spacing});
  const double dissolved = sum_in_order(geometry_.dissolved) + dissolving();
  row.push_back({"dissolved_volume_m3_per_m", units_.volume() * dissolved});
}

template <class T, class Set>
void ReactionModule<T, Set>::fields(FieldList& list) const {
  list.lattice.push_back(
      {"dissolved_fraction", "1", 1, [this](std::span<double> out) { read_solid(geometry_, dissolved_share, out); }});
}

template <class T, class Set>
void ReactionModule<T, Set>::state(StateList& list) {
  list.add("reaction/volume", geometry_.volume);
  list.add("reaction/dissolved", geometry_.dissolved);
  add_state(list, "reaction/consumed", consumed_);
  if (sums_.released.extent(0) > 0) list.add("reaction/released", sums_.released);
  list.add("reaction/lost", lost_);
  list.add_value("reaction/initial_volume", initial_volume_);
  list.add_value("reaction/refreshed", refreshed_, {-1, most_steps});
  const std::pair all(0, links_.count);
  list.add("reaction/link_acid", Kokkos::subview(links_.acid, all));  // not booked yet
  if (wall_.law != ReactiveWallLaw::kinetic) {
    list.add("reaction/link_product", Kokkos::subview(links_.product, all));
    list.add("reaction/link_solid", Kokkos::subview(links_.solid, all));
  }
  list.add("reaction/link_rate", Kokkos::subview(links_.rate, all));
  list.add("reaction/link_conductance", Kokkos::subview(links_.conductance, all));
}

template class ReactionModule<float, D2Q5>;
template class ReactionModule<float, D2Q9>;
template class ReactionModule<double, D2Q5>;
template class ReactionModule<double, D2Q9>;

}  // namespace vug
