#include "coupling/flow_module.hpp"

#include "base/pages.hpp"
#include "coupling/shared_field.hpp"
#include "coupling/sum_state.hpp"
#include "io/narrow_cracks.hpp"
#include "io/units.hpp"
#include "kernels/flow/face_flow.hpp"
#include "kernels/flow/slit_drag.hpp"
#include "kernels/launch/launch.hpp"
#include "kernels/nodes/streaming.hpp"
#include "kernels/scalar/advective_form.hpp"

#include <algorithm>
#include <cmath>

namespace vug {

template <class T>
FlowModule<T>::FlowModule(const Exec& exec, const Scene& scene, const LatticeUnits& units, const Geometry& geometry,
                          const FlowPaths& paths)
    : section_(*scene.flow),
      units_(units),
      geometry_(geometry),
      forces_(body_forces(scene, units)),
      paths_(paths),
      varies_(scene.accuracy.chooses_intervals()),
      fills_slowly_(has_cracks_below_a_cell(scene)),
      pores_open_(scene.damage || rock_dissolves(scene)),
      pathways_in_cells_(scene.rock && !key_of_true_widths(scene)) {
  const double tau = 0.5 + 3 * section_.viscosity / units.diffusivity();
  step_.collision = section_.collision;
  step_.rates = relaxation_rates(section_.collision, tau);
  for (int axis = 0; axis < 2; ++axis)
    step_.body_force[axis] = static_cast<T>(section_.body_force[axis] / (units.acceleration() * units.pressure_scale));
  step_.speed_limit = static_cast<T>(section_.speed_limit);
  fields_ = make_flow_fields<T>(exec, geometry.fluid);
  if (needs_temperature()) prepare_thermal_flow(exec, scene);
  for (const Stretch& stretch : boundary_stretches(scene, geometry)) boundaries_.push_back({stretch, {}, {}, 0});
  find_boundaries(exec);
  for (const StretchLinks& boundary : boundaries_)
    raised_ = std::max(raised_, boundary.stretch.conditions.flow.settled());
  steady_ =
      SteadyFlow<T>(needs_temperature() ? 0 : scene.accuracy.flow_tolerance, raised_, scene.accuracy.guard_interval);
  steady_.wake(exec, geometry.fluid.capacity);
  find_halos();
  initial_mass_ = mass();
}

template <class T>
void FlowModule<T>::prepare_thermal_flow(const Exec& exec, const Scene& scene) {
  range_ = temperature_range(scene);
  const double warmth = section_.reference_temperature - units_.reference_temperature;
  double strength = 0;
  for (int axis = 0; axis < 2; ++axis) {
    const double per_kelvin = -section_.thermal_expansion * section_.gravity[axis];  // m/s2
    const double scaled = per_kelvin / (units_.acceleration() * units_.pressure_scale);
    step_.buoyancy[axis] = static_cast<T>(scaled);
    step_.body_force[axis] -= static_cast<T>(scaled * warmth);
    const double height = axis == 0 ? scene.lattice.nx : scene.lattice.ny;
    strength = std::max(strength, std::abs(scaled) * height);
  }
  buoyant_speed_ = std::sqrt(strength * range_.span());
  if (!section_.viscosity_varies()) return;
  const bool in_parts = !geometry_.split.alone();
  step_.spread = zeros<ScalarField<T>>(exec, "vug::flow::spread", geometry_.fluid.capacity, in_parts);
  const double nu = units_.diffusivity();
  viscosity_.viscosity = section_.viscosity / nu;
  viscosity_.activation = section_.viscosity_activation_energy / gas_constant;
  viscosity_.reference = section_.reference_temperature;
  viscosity_.zero = units_.reference_temperature;
  viscosity_.points = VectorField<double>("vug::flow::viscosity", section_.viscosity_table.size());
  const HostWriter points(viscosity_.points);
  for (std::size_t p = 0; p < section_.viscosity_table.size(); ++p) {
    points(p, 0) = section_.viscosity_table[p][0];
    points(p, 1) = section_.viscosity_table[p][1] / nu;
  }
}

template <class T>
const Carrier<T>& FlowModule<T>::carrier(const Exec& exec, int interval, int directions, T even_weight) {
  for (const Carrier<T>& carrier : carriers_)
    if (!varies_ && carrier.interval == interval && carrier.directions == directions &&
        carrier.even_weight == even_weight)
      return carrier;
  Carrier<T>& carrier = carriers_.emplace_back(Carrier<T>{interval, directions, even_weight, {}, {}});
  fit_carrier(exec, carrier);
  return carrier;
}

template <class T>
void FlowModule<T>::set_interval(const Carrier<T>& of, int interval) {
  for (Carrier<T>& carrier : carriers_) {
    if (&carrier != &of) continue;
    carrier.interval = interval;
    carrier.renewed = true;
  }
}

template <class T>
const VectorField<T>& FlowModule<T>::face_excess(const Exec& exec, int interval) {
  excess_ = VectorField<T>(Kokkos::view_alloc(exec, "vug::flow::excess"), geometry_.fluid.capacity);
  excess_interval_ = interval;
  find_halos();
  return excess_;
}

template <class T>
void FlowModule<T>::find_excess(const Exec& exec) const {
  return_populations(exec);
  around_.exchange<T, 1>(exec, {fields_.f});
  vug::face_excess(exec, geometry_.fluid, fields_, excess_);
  velocities_.exchange<T, 2>(exec, components(excess_));
}

template <class T>
void FlowModule<T>::fit_carrier(const Exec& exec, Carrier<T>& carrier) {
  carrier.u = fields_.u;
  Kokkos::resize(exec, carrier.e, geometry_.fluid.capacity);
}

namespace {

/// The share of a body force that acts in a lattice step: as given velocities (without_alternation), one that sets in
/// at once would leave a swing from step to step, which never decays in a closed box with an odd number of rows.
double onset(std::int64_t step) {
  return step == 0 ? 0.75 : step == 1 ? 1.25 : 1;
}

}  // namespace

template <class T>
void FlowModule<T>::step(const Exec& exec, const Clock& clock) {
  const FluidNodes& fluid = geometry_.fluid;
  // The velocity with which scalars collided in the step before is about to be overwritten.
  for (Carrier<T>& carrier : carriers_) {
    const bool known = steady_.held() && steady_.age() > carrier.interval && !carrier.renewed;
    if (!carrier.due(clock.step - 1) || known) continue;
    carrier.renewed = false;
    if (carrier.directions == D2Q5::Q)
      advective_defect<D2Q5>(exec, fluid, carrier.displacement(), carrier.e);
    else
      advective_defect<D2Q9>(exec, fluid, carrier.displacement(), carrier.e, carrier.even_weight);
    in_rows_.exchange<T, 1>(exec, {carrier.e});
  }
  for (const StretchLinks& boundary : boundaries_)
    if (clock.every(LongSum::interval)) boundary.gain.settle(exec);
  if (geometry_.slit_changes != slit_changes_) {
    slit_changes_ = geometry_.slit_changes;
    steady_.wake(exec, fluid.capacity);
  }
  if (steady_.held()) {
    steady_.pass();
  } else {
    if (needs_temperature()) step_.theta = *theta_;
    if (step_.spread.extent(0) > 0) set_spread(exec, fluid.share(), step_.theta, viscosity_, step_.spread);
    dressed_.exchange<T, 1>(exec, {fields_.f});
    conditions_.clear();
    for (const StretchLinks& boundary : boundaries_)
      conditions_.push_back(condition(boundary, clock.time(), boundary.gain.recent()));
    dress<T>(exec, fluid, conditions_, fields_);
    if (fields_.turned)
      populations_.exchange_back<T, 1>(exec, {fields_.f});
    else
      populations_.exchange<T, 1>(exec, {fields_.f});
    FlowStep<T> now = step_;
    for (T& component : now.body_force) component *= static_cast<T>(onset(clock.step));
    collide_and_stream(exec, fluid, fields_, now);
    if (geometry_.slits.count > 0) drag_in_slits(exec, fluid, geometry_.slits, viscosity(), now, fields_);
    velocities_.exchange<T, 2>(exec, components(fields_.u));
  }
  if (excess_.extent(0) > 0 && clock.every(excess_interval_)) find_excess(exec);
}

template <class T>
void FlowModule<T>::add_slit_drag(const Exec& exec, const VectorField<double>& centre, const VectorField<double>& force,
                                  const ScalarField<double>& torque) const {
  if (geometry_.slits.count == 0) return;
  const Split& split = geometry_.split;
  if (!split.alone()) {  // every rank sums over the slits of all triangles
    split.make_whole(split.of_fluid(geometry_.fluid), fields_.u);
    if (step_.spread.extent(0) > 0) split.make_whole(split.of_fluid(geometry_.fluid), step_.spread);
  }
  vug::add_slit_drag(exec, geometry_.fluid, geometry_.slits, viscosity(), step_, fields_, centre, geometry_.spacing,
                     units_.force(), units_.force() * geometry_.spacing, force, torque);
}

template <class T>
void FlowModule<T>::births(const Exec& exec, const Births& births) {
  const Split& split = geometry_.split;
  const FluidNodes& fluid = geometry_.fluid;
  return_populations(exec);
  gather_sums();  // links may get another owner
  fit_to_capacity(exec, fluid, D2Q9::Q, births.first, fields_.f, fields_.u);
  const double before = sum_mass();
  // the links to new nodes were walls until now
  settle<D2Q9>(exec, fluid, births.first, fields_.f, fields_.turned);
  if (!split.alone())  // all ranks fill the new nodes in the same way
    split.make_whole(split.of_neighbours(fluid, births.first, births.last), fields_.f, D2Q9::Q, fluid.capacity);
  initialise_births(exec, fluid, births.first, births.last, fields_);
  born_mass_ += mass() - before;
  for (Carrier<T>& carrier : carriers_) fit_carrier(exec, carrier);
  if (excess_.extent(0) > 0) Kokkos::resize(exec, excess_, geometry_.fluid.capacity);
  if (step_.spread.extent(0) > 0) Kokkos::resize(exec, step_.spread, geometry_.fluid.capacity);
  find_boundaries(exec);
  find_halos();
  velocities_.template exchange<T, 2>(exec, components(fields_.u));
  steady_.wake(exec, geometry_.fluid.capacity);
}

template <class T>
void FlowModule<T>::watch(const Exec& exec, const Clock& clock, Changes& changes) {
  constexpr double margin = 2;
  changes.speed = largest_speed();
  if (clock.time() < raised_) return;
  const double speed = extremes(exec).speed;
  // in pores that have opened, fluid may be faster than the paths at the start allow
  const double bound = pores_open_ ? std::max(*changes.speed, speed) : *changes.speed;
  changes.speed = std::min(bound, margin * speed);
}

template <class T>
void FlowModule<T>::state(StateList& list) {
  visit_shares(SharedFields(geometry_.split.ranks(), &list));
  list.add_value("flow/turned", fields_.turned, {0, 1});
  list.add("flow/limited", step_.limited);
  for (StretchLinks& boundary : boundaries_) {
    const std::string key = "flow/" + boundary.stretch.name + "/" + std::to_string(boundary.stretch.first);
    add_state(list, key + "/gain", boundary.gain);
    list.add_value(key + "/entered", boundary.entered);
    if (steady_.on()) list.add_value(key + "/looked", boundary.looked);
    if (boundary.stretch.conditions.flow.kind == FlowBoundaryKind::outflow)
      list.add(key + "/level", boundary.outflow.level);
  }
  steady_.state(list);
  list.add_value("flow/initial_mass", initial_mass_);
  list.add_value("flow/born_mass", born_mass_);
  list.add_value("flow/slit_changes", slit_changes_, {0, most_steps});
}

template class FlowModule<float>;
template class FlowModule<double>;

}  // namespace vug
