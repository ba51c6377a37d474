#include "coupling/solute_module.hpp"

#include "coupling/joint_reactions.hpp"
#include "coupling/read_fields.hpp"
#include "coupling/shared_field.hpp"
#include "coupling/sum_state.hpp"
#include "kernels/launch/launch.hpp"
#include "kernels/nodes/streaming.hpp"
#include "kernels/reaction/dissolution.hpp"
#include "kernels/scalar/advective_form.hpp"
#include "kernels/solute/face_exchange.hpp"
#include "kernels/solute/slit_diffusion.hpp"

#include <algorithm>

namespace vug {

template <class T, class Set>
SoluteModule<T, Set>::SoluteModule(const Exec& exec, const Scene& scene, const LatticeUnits& units,
                                   const Geometry& geometry, FlowModule<T>* flow)
    : section_(*scene.solute),
      units_(units),
      geometry_(geometry),
      flow_(flow),
      carrier_(flow ? &flow->carrier(exec, scene.accuracy.solute_interval, Set::Q) : nullptr),
      interval_(scene.accuracy.solute_interval),
      next_interval_(interval_),
      compared_(geometry.fluid.count),
      fill_(scene.reaction ? scene.reaction->birth_fill : BirthFill::mean),
      fastest_(flow ? flow->largest_speed() : 0),
      ages_(scene.accuracy.dissolution_tolerance > 0) {
  if (flow && section_.face_exchange) excess_ = &flow->face_excess(exec, interval_);
  for (const Species& section : section_.species) {
    SpeciesState<T> state;
    state.section = section;
    state.parameters = parameters_of(section);
    state.fields = make_solute_fields<Set, T>(exec, geometry.fluid, section.initial / units.concentration);
    for (const Stretch& stretch : boundary_stretches(scene, geometry)) {
      const SoluteBoundaryKind kind = stretch.conditions.solute.kind;
      if (kind != SoluteBoundaryKind::no_flux && kind != SoluteBoundaryKind::periodic)
        state.boundaries.push_back({stretch, {}, {}, 0});
    }
    if (scene.accuracy.chooses_intervals()) {
      state.watched = ScalarField<T>("vug::solute::watched", geometry.fluid.capacity);
      Kokkos::deep_copy(exec, state.watched, state.fields.C);
    }
    // outflows are dressed first, because they read populations that the others overwrite
    std::stable_partition(state.boundaries.begin(), state.boundaries.end(), [](const StretchLinks& boundary) {
      return boundary.stretch.conditions.solute.kind == SoluteBoundaryKind::outflow;
    });
    species_.push_back(std::move(state));
  }
  find_boundaries(exec);
  for (SpeciesState<T>& s : species_) s.initial = total(s);
}

template <class T, class Set>
SoluteParameters SoluteModule<T, Set>::parameters_of(const Species& species) const {
  const double D = interval_ * species.diffusivity / units_.diffusivity();
  return solute_parameters(D, section_.relaxation_time);
}

template <class T, class Set>
SpeciesState<T>& SoluteModule<T, Set>::species(const std::string& name) {
  const auto found =
      std::find_if(species_.begin(), species_.end(), [&](const SpeciesState<T>& s) { return s.section.name == name; });
  KOKKOS_ASSERT(found != species_.end());
  return *found;
}

template <class T, class Set>
void SoluteModule<T, Set>::find_boundaries(const Exec& exec) {
  const int blocks = block_count(geometry_.fluid.capacity);
  narrow_ = false;
  for (SpeciesState<T>& s : species_) {
    for (StretchLinks& boundary : s.boundaries) {
      const Stretch& stretch = boundary.stretch;
      boundary.find(exec, geometry_.fluid, Set::Q);
      if (stretch.conditions.solute.kind == SoluteBoundaryKind::flux)
        boundary.area = stretch.opening ? link_areas(exec, geometry_.fluid, *stretch.opening, Set::Q)
                                        : link_areas(boundary.links, Set::Q);
      if (stretch.conditions.solute.kind == SoluteBoundaryKind::outflow &&
          &s == &species_[0])  // all species have the same links
        narrow_ = narrow_ || is_narrow(exec, geometry_.fluid, boundary.links);
    }
    if (s.watched.extent(0) > 0) Kokkos::resize(exec, s.watched, geometry_.fluid.capacity);
    s.correction.resize(exec, blocks);
    Kokkos::resize(exec, s.created, blocks);
  }
  find_halos();
}

template <class T, class Set>
SoluteCondition<T> SoluteModule<T, Set>::condition(const SpeciesState<T>& s, const StretchLinks& boundary,
                                                   const StepTimes& times, const ScalarField<double>& gain) const {
  const SoluteBoundary& given = boundary.stretch.conditions.solute;
  if (given.kind == SoluteBoundaryKind::outflow) return outflow_condition(boundary.links, s.parameters, s.fields, gain);
  const bool flux = given.kind == SoluteBoundaryKind::flux;
  const auto& values = flux ? given.flux : given.concentration;
  const auto found = values.find(s.section.name);
  const auto at = [&](double time) { return found->second.at(time); };
  const double given_value = found == values.end() ? 0 : flux ? times.mean(at) : times.mean_about_last(at);
  const double value = given_value / units_.concentration;
  if (flux) return flux_condition(boundary.links, boundary.area, interval_ * value / units_.velocity(), s.fields, gain);
  return concentration_condition(boundary.links, value, s.fields, gain);
}

template <class T, class Set>
Crossing<T> SoluteModule<T, Set>::crossing() const {
  if (!carrier_) return {};
  return {geometry_.fluid.open_links, carrier_->displacement()};
}

template <class T, class Set>
void SoluteModule<T, Set>::step_pairs(const Exec& exec, const SoluteCarrier<T>& carrier) {
  for (SpeciesState<T>& s : species_) advance_solute<Set>(exec, geometry_.fluid, carrier, s.stepping());
  if (jointly_) return react_jointly<Set>(exec, joined(reacting_));
  for (const auto& [wall, links, reactant, product, key] : reacting_)
    react_at_wall<Set>(exec, geometry_.fluid, *wall, *links, reactant->fields, product ? &product->fields : nullptr);
}

template <class T, class Set>
void SoluteModule<T, Set>::step(const Exec& exec, const Clock& clock) {
  if (!due(clock)) return;
  const FluidNodes& fluid = geometry_.fluid;
  conditions_.clear();
  const StepTimes times{clock.time(), units_.time_step, interval_};
  for (SpeciesState<T>& s : species_) {
    if (!ages_) s.fields.rounding = rounding_of_step<T>((clock.step + 1) / interval_);
    if (clock.every(LongSum::interval)) s.settle(exec);
    for (const StretchLinks& boundary : s.boundaries)
      conditions_.push_back(condition(s, boundary, times, boundary.gain.recent()));
  }
  for (const SpeciesState<T>& s : species_) before_outflow_.template exchange<T, 1>(exec, {s.fields.C});
  dress<Set, T>(exec, fluid, conditions_, narrow_, crossing());
  if (next_interval_ == interval_)
    sweep(exec);
  else
    turn(exec);
  act_on_links(exec);
}

template <class T, class Set>
void SoluteModule<T, Set>::act_on_links(const Exec& exec) {
  const SlitNodes& slits = geometry_.slits;
  if (!excess_ && slits.count == 0) return;
  const SoluteCarrier<T> carrier = carrier_of_all();
  for (const SpeciesState<T>& s : species_) {
    neighbours_.template exchange<T, 1>(exec, {s.fields.C});
    if (excess_) exchange_at_faces(exec, geometry_.fluid, *excess_, interval_, s.fields, s.correction.recent());
    if (slits.count == 0) continue;
    exchange(exec, s.fields);
    resist_in_slits<Set>(exec, geometry_.fluid, slits, carrier, s.parameters, s.fields);
  }
}

template <class T, class Set>
SoluteCarrier<T> SoluteModule<T, Set>::carrier_of_all() const {
  SoluteCarrier<T> carrier;
  if (carrier_) carrier.displacement = carrier_->displacement();
  if (carrier_ && section_.advective_form) carrier.defect = carrier_->e;
  return carrier;
}

template <class T, class Set>
void SoluteModule<T, Set>::sweep(const Exec& exec) {
  const SoluteCarrier<T> carrier = carrier_of_all();
  const FluidNodes& fluid = geometry_.fluid;
  const bool one_pair = reacting_.size() == 1, many_pairs = reacting_.size() > 1;
  const ReactingSpecies<T> none, &pair = one_pair ? reacting_[0] : none;
  const auto& [wall, links, reactant, product, key] = pair;
  for (SpeciesState<T>& s : species_) {
    exchange(exec, s.fields);
    if (!many_pairs && &s != reactant && &s != product) advance_solute<Set>(exec, fluid, carrier, s.stepping());
  }
  if (many_pairs) step_pairs(exec, carrier);
  if (!reactant) return;
  if (product) {
    const SteppingSolute<T> stepping = product->stepping();
    advance_reacting_solutes<Set>(exec, fluid, carrier, *wall, *links, reactant->stepping(), &stepping);
  } else {
    advance_reacting_solutes<Set, T>(exec, fluid, carrier, *wall, *links, reactant->stepping(), nullptr);
  }
}

template <class T, class Set>
void SoluteModule<T, Set>::births(const Exec& exec, const Births& births) {
  const FluidNodes& fluid = geometry_.fluid;
  const Split& split = geometry_.split;
  for (SpeciesState<T>& s : species_) {
    if (s.fields.turned) exchange(exec, s.fields);
    gather_sums(s);
  }
  find_boundaries(exec);
  for (SpeciesState<T>& s : species_) {
    fit_to_capacity(exec, fluid, Set::Q, births.first, s.fields.h, s.fields.C);
    // the links to new nodes were walls until now
    settle<Set>(exec, fluid, births.first, s.fields.h, s.fields.turned);
    if (!split.alone())  // so that all ranks fill the new nodes alike
      split.make_whole(split.of_neighbours(fluid, births.first, births.last), s.fields.h, Set::Q, fluid.capacity);
    initialise_births<Set>(exec, fluid, births.first, births.last, fill_, s.fields, s.created);
  }
}

template <class T, class Set>
void SoluteModule<T, Set>::ledger(Ledger& ledger) const {
  for (const SpeciesState<T>& s : species_) {
    const double mol = units_.amount();
    gather_sums(s);
    Balance& balance = ledger.of(s.section.name, "mol/m");
    balance.initial = mol * s.initial;
    balance.stored = mol * total(s);
    double injected = 0, left = 0;
    for (const StretchLinks& boundary : s.boundaries) {
      if (boundary.stretch.opening) continue;
      (boundary.stretch.conditions.solute.kind == SoluteBoundaryKind::outflow ? left : injected) += boundary.total();
    }
    balance.gains.push_back({"injected", mol * injected});
    balance.gains.push_back({"outflow", mol * left});
    for (const StretchLinks& boundary : s.boundaries)
      if (boundary.stretch.opening) balance.gains.push_back({boundary.stretch.name, mol * boundary.total()});
    balance.gains.push_back({"births", mol * sum_in_order(s.created)});
    balance.gains.push_back({"advective_form", mol * s.correction.total()});
  }
}

template <class T, class Set>
void SoluteModule<T, Set>::fields(FieldList& list) const {
  for (const SpeciesState<T>& s : species_)
    list.lattice.push_back({"concentration_" + s.section.name, "mol/m3", 1, [this, &s] {
                              return read_fluid(geometry_, std::array{s.fields.C}, {units_.concentration, 0, 0});
                            }});
}

template <class T, class Set>
void SoluteModule<T, Set>::state(StateList& list) {
  if (species_[0].watched.extent(0) > 0)
    list.add_value("solute/compared", compared_, {0, static_cast<double>(geometry_.fluid.count)});
  visit_shares(SharedFields(geometry_.split.ranks(), &list));
  for (SpeciesState<T>& s : species_) {
    const std::string key = "solute/" + s.section.name;
    list.add_value(key + "/turned", s.fields.turned, {0, 1});
    add_state(list, key + "/correction", s.correction);
    list.add(key + "/created", s.created);
    list.add_value(key + "/initial", s.initial);
    for (StretchLinks& boundary : s.boundaries) {
      const std::string side = key + "/" + boundary.stretch.name + "/" + std::to_string(boundary.stretch.first);
      add_state(list, side + "/gain", boundary.gain);
      list.add_value(side + "/entered", boundary.entered);
    }
  }
}

template class SoluteModule<float, D2Q5>;
template class SoluteModule<float, D2Q9>;
template class SoluteModule<double, D2Q5>;
template class SoluteModule<double, D2Q9>;

}  // namespace vug
