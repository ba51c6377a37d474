#include "coupling/heat_module.hpp"

#include "base/pages.hpp"
#include "base/require.hpp"
#include "coupling/read_fields.hpp"
#include "coupling/shared_field.hpp"
#include "coupling/sum_state.hpp"
#include "io/each_boundary.hpp"
#include "kernels/flow/guards.hpp"
#include "kernels/heat/heat_sums.hpp"
#include "kernels/launch/launch.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace vug {

namespace {

// Temperatures this far outside those of the case are no solution of the heat equation. What a flux does has no such
// bound: the second value is far beyond what it maintains across a lattice.
constexpr double runaway_margin = 1000, runaway_margin_with_flux = 1e5;  // K

}  // namespace

template <class T>
HeatModule<T>::HeatModule(const Exec& exec, const Scene& scene, const LatticeUnits& units, const Geometry& geometry,
                          FlowModule<T>* flow)
    : section_(*scene.heat),
      units_(units),
      geometry_(geometry),
      flow_(flow),
      interval_(scene.accuracy.heat_interval),
      next_interval_(interval_),
      update_interval_(scene.accuracy.update_interval),
      periodic_(periodic_sides(scene)),
      initial_theta_(units.lattice_temperature(section_.initial_temperature)),
      range_(named_range(scene)),
      fastest_(flow ? flow->largest_speed() : 0) {
  for_each_boundary(scene, [&](const BoundarySection& given) {
    if (given.heat.kind == HeatCondition::flux)
      largest_flux_ = std::max(largest_flux_, std::abs(given.heat.flux.peak()));
  });
  set_up_minerals(scene);
  fields_ = make_heat_fields<T>(exec, geometry.lattice, parameters(), geometry.type, periodic_, initial_theta_,
                                !geometry.openings.empty(), geometry.mineral, geometry.split.share_of_rows());
  const bool in_parts = !geometry.split.alone();
  if (flow && flow->needs_temperature()) {
    fluid_theta_ = zeros<ScalarField<T>>(exec, "vug::heat::fluid_theta", geometry.fluid.capacity, in_parts);
    if (flow->buoyant()) before_ = zeros<ScalarField<T>>(exec, "vug::heat::before", geometry.fluid.capacity, in_parts);
    flow->be_heated_by(fluid_theta_);
  }
  if (flow) carrier_ = &flow->carrier(exec, interval_, directions(), even_defect_weight(fields_));
  for (const Stretch& stretch : boundary_stretches(scene)) {
    const HeatBoundary& heat = stretch.conditions.heat;
    if (periodic_[is_upright(stretch.side) ? 0 : 1]) continue;
    stretches_.push_back(stretch);
    sides_.push_back(make_heat_side(stretch.side, stretch.first, stretch.last, heat.kind, value_of(heat, 0)));
    sides_.back().transfer = transfer_of(heat);
    entered_.emplace_back("vug::heat::entered", sides_.back().energy_in.extent(0));
    sides_.back().energy_in = entered_.back().recent();
  }
  assign_corners(geometry.lattice, sides_);
  for (const InnerOpening& opening : geometry.openings) {
    const HeatBoundary& heat = opening.conditions.heat;
    openings_.push_back(
        make_heat_opening(exec, fields_, geometry.type, periodic_, opening.nodes, heat.kind, value_of(heat, 0)));
    openings_.back().transfer = transfer_of(heat);
    entered_.emplace_back("vug::heat::entered", openings_.back().energy_in.extent(0));
    openings_.back().energy_in = entered_.back().recent();
  }
  if (carrier_) {
    lagged_ = zeros<ScalarField<T>>(exec, "vug::heat::lagged", geometry.fluid.capacity, in_parts);
    rows_ = fluid_rows(exec, geometry.fluid);
  }
  const int sums =
      std::max(block_count(geometry.lattice.size()), geometry.lattice.ny);  // by row; as many as checkpoints have had
  created_ = LongSum("vug::heat::created", carrier_ ? sums : 0);
  born_ = ScalarField<double>("vug::heat::born", block_count(geometry.lattice.size()));  // rock may open without flow
  if (scene.mechanics || scene.reaction)
    theta_ = zeros<ScalarField<T>>(exec, "vug::heat::theta", geometry.lattice.size(), in_parts);
  if (scene.accuracy.chooses_intervals()) {
    watched_ = zeros<ScalarField<T>>(exec, "vug::heat::watched", geometry.lattice.size(), in_parts);
    take_temperatures(exec, fields_, watched_);
  }
  find_halos();
  begin_temperatures_of_fluid(exec, 0);
  initial_energy_ = energy();
}

template <class T>
double HeatModule<T>::energy() const {
  ScalarField<double> partial("vug::heat::partial", geometry_.lattice.ny);
  add_heat_energy(Exec{}, fields_, partial);
  const Split& split = geometry_.split;
  if (!split.alone()) split.make_whole(split.of_rows(), partial);
  return sum_in_order(partial);
}

template <class T>
HeatExtremes HeatModule<T>::extremes(const Exec& exec) const {
  const Ranks& ranks = geometry_.split.ranks();
  const HeatExtremes ours = heat_extremes(exec, fields_);
  return {ranks.least(ours.lowest), ranks.most(ours.highest), ranks.most(ours.not_finite)};
}

template <class T>
bool HeatModule<T>::rock_asks_before_next_step(const Clock& clock) const {
  const std::int64_t asks = (clock.step + update_interval_ - 1) / update_interval_ * update_interval_;
  return asks < clock.step + interval_;
}

template <class T>
const ScalarField<T>& HeatModule<T>::temperature(const Exec& exec, const Halo& others) const {
  if (!fresh_) take_temperatures(exec, fields_, theta_);
  fresh_ = true;
  others.exchange<T, 1>(exec, {theta_});
  return theta_;
}

template <class T>
FaceTemperature<T> HeatModule<T>::face_temperature(const Exec& exec, const Halo& others) const {
  const double share = solid_share(section_.solid_density, section_.solid_heat_capacity, section_.solid_diffusivity);
  return {temperature(exec, others), {share, geometry_.mineral, solid_share_}, units_.reference_temperature};
}

template <class T>
HeatCrossing<T> HeatModule<T>::crossing() const {
  if (!carrier_) return {};
  return {geometry_.fluid.index, {geometry_.fluid.open_links, carrier_->displacement()}};
}

template <class T>
void HeatModule<T>::step(const Exec& exec, const Clock& clock) {
  if (!clock.every(interval_)) return;
  if (clock.every(LongSum::interval)) {
    created_.settle(exec);
    for (const LongSum& side : entered_) side.settle(exec);
  }
  fields_.rounding = rounding_of_step<T>((clock.step + 1) / interval_);
  set_values(clock.time());
  populations_.exchange<T, 1>(exec, {fields_.g});
  fill_heat_openings<T>(exec, fields_, openings_, crossing());
  for (int axis = 0; axis < 2; ++axis)
    if (periodic_[axis]) join_heat_sides(exec, fields_, axis);
  fill_heat_sides<T>(exec, fields_, sides_, crossing());
  const double stretch = static_cast<double>(next_interval_) / interval_;
  const double carried = stretch == 1 ? 1 : turn(stretch);
  fresh_ = theta_.extent(0) > 0 && rock_asks_before_next_step(clock);
  const ScalarField<T> theta = fresh_ ? theta_ : ScalarField<T>();
  if (carrier_) {
    Displacement<T> u = carrier_->displacement();
    u.steps *= static_cast<T>(carried);
    conduct_and_advect(exec, geometry_.fluid, rows_, u, carrier_->e, lagged_, fields_, created_.recent(), theta);
  } else {
    conduct(exec, fields_, theta);
  }
  if (stretch != 1) {
    set_heat_rates(parameters(), 1, fields_);
    if (carrier_) stretch_lagged(exec, geometry_.fluid.near(geometry_.fluid.count), stretch, lagged_);
  }
  take_temperatures_of_fluid(exec);
}

template <class T>
void HeatModule<T>::births(const Exec& exec, const Births& births) {
  const Split& split = geometry_.split;
  if (!split.alone()) {  // so that all ranks book the same gain of the new nodes
    const auto node = on_host(geometry_.fluid.node);
    std::vector<int> nodes;
    for (int i = births.first; i < births.last; ++i) nodes.push_back(node(i));
    split.make_whole(split.of_dense_nodes(geometry_.lattice, nodes), fields_.g, directions(), geometry_.lattice.size());
  }
  add_birth_energy(exec, fields_, geometry_.fluid.node, births.first, births.last, born_);
  if (carrier_) {
    Kokkos::resize(exec, lagged_, geometry_.fluid.capacity);
    rows_ = fluid_rows(exec, geometry_.fluid);
  }
  set_heat_geometry(exec, geometry_.type, periodic_, fields_);
  find_halos();
  if (fluid_theta_.extent(0) > 0) Kokkos::resize(exec, fluid_theta_, geometry_.fluid.capacity);
  if (before_.extent(0) > 0) Kokkos::resize(exec, before_, geometry_.fluid.capacity);
  begin_temperatures_of_fluid(exec, births.first);
}

template <class T>
double HeatModule<T>::margin(double time) const {
  if (largest_flux_ == 0) return runaway_margin;
  // a flux into a closed space warms it for ever, at most through four sides of a single cell
  double capacity = std::min(section_.fluid_density * section_.fluid_heat_capacity,
                             section_.solid_density * section_.solid_heat_capacity);  // J/(m3 K)
  for (const Mineral& mineral : minerals_) capacity = std::min(capacity, mineral.density * mineral.heat_capacity);
  return std::max(runaway_margin_with_flux, runaway_margin + 4 * largest_flux_ * time / (units_.spacing * capacity));
}

template <class T>
void HeatModule<T>::guard(const Exec& exec, const Clock& clock) {
  const double margin = this->margin(static_cast<double>(clock.step) * units_.time_step);
  const double lowest = units_.lattice_temperature(range_.coldest - margin);
  const double highest = units_.lattice_temperature(range_.hottest + margin);
  const HeatExtremes extremes = this->extremes(exec);
  if (extremes.not_finite == 0 && extremes.lowest > lowest && extremes.highest < highest) return;
  if (!geometry_.split.alone()) geometry_.split.make_whole(geometry_.lattice, fields_.g, directions());
  const int node =
      field_range(exec, temperatures(exec, fields_), fields_.lattice.size(), lowest, highest).first_outside;
  throw StabilityError(fmt::format(
      "heat diverged at step {}: node ({}, {}) is not finite or {:.4g} K beyond what the case puts in; temperatures "
      "from {:.4g} to {:.4g} K, {} nodes not finite; {}",
      clock.step, geometry_.lattice.x(node), geometry_.lattice.y(node), margin,
      extremes.lowest + units_.reference_temperature, extremes.highest + units_.reference_temperature,
      extremes.not_finite, carrier_ ? "lower the velocity or raise the diffusivities" : "lower lattice.time_step"));
}

template <class T>
void HeatModule<T>::fields(FieldList& list) const {
  list.lattice.push_back({"temperature", "K", 1, [this] {
                            const auto theta = zeros<ScalarField<T>>(
                                Exec{}, "vug::heat::theta", geometry_.lattice.size(), !geometry_.split.alone());
                            take_temperatures(Exec{}, fields_, theta);
                            return read_dense(geometry_, theta, {1, units_.reference_temperature, 0});
                          }});
}

template <class T>
void HeatModule<T>::state(StateList& list) {
  fresh_ = false;  // because a checkpoint may be loaded
  visit_shares(SharedFields(geometry_.split.ranks(), &list));
  add_state(list, "heat/created", created_);
  list.add("heat/born", born_);
  for (std::size_t s = 0; s < sides_.size(); ++s)
    add_state(list, "heat/" + stretches_[s].name + "/" + std::to_string(stretches_[s].first), entered_[s]);
  for (std::size_t o = 0; o < openings_.size(); ++o)
    add_state(list, "heat/" + geometry_.openings[o].name, entered_[sides_.size() + o]);
  list.add_value("heat/initial_energy", initial_energy_);
}

template class HeatModule<float>;
template class HeatModule<double>;

}  // namespace vug
