// What crosses the sides of the lattice and the surfaces of openings at present, and the force of the fluid on them:
// the conditions of the next step are applied there, and then undone.
#include "coupling/corner_forces.hpp"
#include "coupling/flow_module.hpp"
#include "coupling/heat_module.hpp"
#include "coupling/solute_module.hpp"
#include "coupling/stretch_ends.hpp"
#include "kernels/flow/link_populations.hpp"
#include "kernels/launch/launch.hpp"

#include <algorithm>
#include <map>

namespace vug {

namespace {

/// Adds to the value of that name, because a side may consist of several parts.
void add_value(std::vector<HistoryValue>& row, const std::string& name, double value) {
  const auto found = std::find_if(row.begin(), row.end(), [&](const HistoryValue& v) { return v.name == name; });
  if (found == row.end())
    row.push_back({name, value});
  else
    found->value += value;
}

/// A boundary whose conditions have been applied for this purpose.
template <class T>
struct DressedBoundary {
  const StretchLinks& boundary;
  ScalarField<T> outgoing;    ///< (link) the populations there before
  ScalarField<double> gain;   ///< (link) what enters in a step
  ScalarField<double> level;  ///< what an outflow of the fluid keeps from step to step
};

template <class T>
DressedBoundary<T> dressing(const Exec& exec, const FluidNodes& fluid, const StretchLinks& boundary,
                            const ScalarField<T>& populations) {
  const BoundaryLinks& links = boundary.links;
  return {boundary, outgoing_populations(exec, fluid, links, populations),
          ScalarField<double>("vug::surfaces::gain", links.count),
          Kokkos::create_mirror(typename Exec::memory_space{}, boundary.outflow.level)};
}

/// The nodes at links, as a halo that brings them to other ranks.
template <class Boundaries>
Halo nodes_at(const Split& split, const FluidNodes& fluid, const Boundaries& boundaries) {
  if (split.alone()) return {};
  std::vector<int> nodes;
  for (const StretchLinks& boundary : boundaries) {
    const auto node = on_host(boundary.links.fluid);
    nodes.insert(nodes.end(), node.data(), node.data() + boundary.links.count);
  }
  return split.slots(fluid, nodes);
}

}  // namespace

template <class T>
void FlowModule<T>::surfaces(const Clock& clock, const OutputSection& wanted, std::vector<HistoryValue>& row) const {
  const Exec exec;
  const FluidNodes& fluid = geometry_.fluid;
  bring_to_all_links(exec);
  std::vector<DressedBoundary<T>> dressed;
  for (const StretchLinks& boundary : boundaries_) {
    dressed.push_back(dressing(exec, fluid, boundary, fields_.f));
    Kokkos::deep_copy(dressed.back().level, boundary.outflow.level);
  }
  std::vector<FlowCondition> conditions;
  for (const DressedBoundary<T>& d : dressed) {
    conditions.push_back(condition(d.boundary, clock.time(), d.gain));
    conditions.back().take_all();
  }
  dress<T>(exec, fluid, conditions, fields_);
  const double kg_per_s = units_.fluid_density * units_.diffusivity();
  for (const DressedBoundary<T>& d : dressed) {
    const Stretch& stretch = d.boundary.stretch;
    const FlowBoundary& flow = stretch.conditions.flow;
    if (wanted.forces && flow.kind != FlowBoundaryKind::periodic) {
      const LinkForce force = force_on_links(exec, fluid, d.boundary.links, d.outgoing, fields_.f, stretch.centre);
      add_value(row, stretch.name + "_force_x_N_per_m", units_.force() * force.x);
      add_value(row, stretch.name + "_force_y_N_per_m", units_.force() * force.y);
      add_value(row, stretch.name + "_torque_N", units_.force() * units_.spacing * force.torque);
    }
    if (wanted.flows && is_open(flow))
      add_value(row, stretch.name + "_mass_flow_kg_per_m_s", kg_per_s * sum_in_order(d.gain));
  }
  // now that all columns are there: rock that dissolves in a corner must not change their order
  for (const DressedBoundary<T>& d : dressed) {
    const Stretch& stretch = d.boundary.stretch;
    if (!wanted.flows || stretch.conditions.flow.kind != FlowBoundaryKind::velocity) continue;
    for (int e = 0; e < 2; ++e) {
      const StretchEnd& end = d.boundary.ends[e];
      if (end.link < 0 || end.other < 0) continue;
      const StretchLinks& other = boundaries_[end.other];
      const auto theirs = given_velocity(other, clock.time());
      if (end.beyond == StretchEnd::Beyond::same_side) {
        const auto at_end = velocity_at_end(d.boundary, end, given_velocity(d.boundary, clock.time()), theirs);
        add_value(row, stretch.name + "_mass_flow_kg_per_m_s", -kg_per_s * passed_along(d.boundary, e, at_end));
      } else if (is_open(
                     other.stretch.conditions.flow)) {  // the link at a corner also has what enters through the other
        const double entered = kg_per_s * entered_for(other.stretch.side, end, theirs);
        add_value(row, stretch.name + "_mass_flow_kg_per_m_s", -entered);
        add_value(row, other.stretch.name + "_mass_flow_kg_per_m_s", entered);
      }
    }
  }
  if (wanted.forces) {
    std::vector<PassedLinks<T>> passed;
    for (const DressedBoundary<T>& d : dressed) {
      const auto returned = outgoing_populations(exec, fluid, d.boundary.links, fields_.f);
      exec.fence("vug::surfaces::returned");
      passed.emplace_back(d.boundary, d.outgoing, returned);
    }
    for (const CornerForce& corner : corner_forces(geometry_.lattice, passed, on_host(fluid.node)))
      for (const auto& [side, sign] : {std::pair{corner.from, -1.0}, {corner.to, 1.0}}) {
        add_value(row, side->name + "_force_x_N_per_m", sign * units_.force() * corner.force[0]);
        add_value(row, side->name + "_force_y_N_per_m", sign * units_.force() * corner.force[1]);
        add_value(row, side->name + "_torque_N", sign * units_.force() * units_.spacing * corner.torque_about(*side));
      }
  }
  for (const DressedBoundary<T>& d : dressed) {
    const Stretch& wall = d.boundary.stretch;
    const FlowBoundary& flow = wall.conditions.flow;
    if (!wanted.flows || wall.opening || flow.kind != FlowBoundaryKind::wall || flow.peak_speed() == 0) continue;
    // a sliding wall has the links out of its corners; what they carry crosses the open side there
    const auto at = on_host(d.boundary.links.fluid), node = on_host(fluid.node);
    const auto direction = on_host(d.boundary.links.direction);
    const auto gain = on_host(d.gain);
    for (int link = 0; link < d.boundary.links.count; ++link)
      for (const StretchLinks& open : boundaries_)
        if (is_open(open.stretch.conditions.flow) && is_upright(open.stretch.side) != is_upright(wall.side) &&
            crosses(open.stretch, geometry_.lattice, node(at(link)), direction(link)))
          add_value(row, open.stretch.name + "_mass_flow_kg_per_m_s", kg_per_s * gain(link));
  }
  for (const DressedBoundary<T>& d : dressed) {
    restore_outgoing(exec, fluid, d.boundary.links, d.outgoing, fields_.f);
    Kokkos::deep_copy(d.boundary.outflow.level, d.level);
  }
}

template <class T>
void HeatModule<T>::surfaces(const Clock& clock, const OutputSection& wanted, std::vector<HistoryValue>& row) const {
  if (!wanted.flows) return;
  const Exec exec;
  populations_.template exchange<T, 1>(exec, {fields_.g});
  if (carrier_) in_rows_.template exchange<T, 2>(exec, components(carrier_->u));
  HeatFields<T> fields = fields_;
  fields.rounding = rounding_of_step<T>(clock.step / interval_);  // as in the last step, also after a restart
  const double watt = section_.fluid_density * section_.fluid_heat_capacity * units_.diffusivity() / interval_;
  const Split& split = geometry_.split;
  const auto look = [&](const std::string& name, const HeatBoundary& heat, std::size_t number, auto surface,
                        const auto& fill) {
    surface.energy_in = ScalarField<double>("vug::surfaces::energy_in", surface.energy_in.extent(0));
    surface.value = value_of(heat, next_step(clock, interval_));
    fill(surface);
    if (surface.condition == HeatCondition::adiabatic) return;
    if (!split.alone()) split.make_whole(owners_of_entries(number), surface.energy_in);
    add_value(row, name + "_heat_flow_W_per_m", watt * sum_in_order(surface.energy_in));
  };
  for (std::size_t o = 0; o < openings_.size(); ++o)
    look(geometry_.openings[o].name, geometry_.openings[o].conditions.heat, sides_.size() + o, openings_[o],
         [&](const HeatOpening& opening) {
           fill_heat_openings(exec, fields, {&opening, 1}, crossing());
         });
  for (int axis = 0; axis < 2; ++axis)
    if (periodic_[axis]) join_heat_sides(exec, fields, axis);
  for (std::size_t s = 0; s < sides_.size(); ++s)
    look(stretches_[s].name, stretches_[s].conditions.heat, s, sides_[s], [&](const HeatSide& side) {
      fill_heat_sides(exec, fields, {&side, 1}, crossing());
    });
  filled_.template exchange_back<T, 1>(exec, {fields_.g});
}

template <class T, class Set>
void SoluteModule<T, Set>::surfaces(const Clock& clock, const OutputSection& wanted,
                                    std::vector<HistoryValue>& row) const {
  if (!wanted.flows) return;
  const Exec exec;
  const FluidNodes& fluid = geometry_.fluid;
  const double mol_per_s = units_.amount() / (interval_ * units_.time_step);
  const VectorField<T> u = carrier_ ? carrier_->u : VectorField<T>();
  const Split& split = geometry_.split;
  const Halo others = nodes_at(split, fluid, species_[0].boundaries);  // all species have the same links
  if (carrier_) others.template exchange<T, 2>(exec, components(u));
  for (SpeciesState<T> s : species_) {
    if (!ages_) s.fields.rounding = rounding_of_step<T>(clock.step / interval_);  // likewise
    others.template exchange<T, 1>(exec, {s.fields.C});
    before_outflow_.template exchange<T, 1>(exec, {s.fields.C});
    const auto column = [&](const StretchLinks& boundary, const char* what) {
      return boundary.stretch.name + "_" + s.section.name + "_" + what;
    };
    std::vector<DressedBoundary<T>> dressed;
    for (const StretchLinks& boundary : s.boundaries) dressed.push_back(dressing(exec, fluid, boundary, s.fields.h));
    std::vector<SoluteCondition<T>> conditions;
    for (const DressedBoundary<T>& d : dressed)
      conditions.push_back(condition(s, d.boundary, next_step(clock, interval_), d.gain));
    dress<Set, T>(exec, fluid, conditions, narrow_, crossing());
    exec.fence("vug::solute::surfaces");
    for (const DressedBoundary<T>& d : dressed) {
      if (!split.alone()) split.make_whole(split.of_links(d.boundary.links), d.gain);
      add_value(row, column(d.boundary, "flow_mol_per_m_s"), mol_per_s * sum_in_order(d.gain));
    }
    for (const DressedBoundary<T>& d : dressed) restore_outgoing(exec, fluid, d.boundary.links, d.outgoing, s.fields.h);
    std::map<std::string, LinkMean> mean;
    for (const StretchLinks& boundary : s.boundaries)
      mean[column(boundary, "mean_mol_per_m3")] += mean_at_links(exec, boundary.links, s.fields.C, u);
    for (const auto& [name, value] : mean) row.push_back({name, units_.concentration * value.value()});
  }
}

#define VUG_INSTANTIATE(T)                                                                                             \
  template void FlowModule<T>::surfaces(const Clock&, const OutputSection&, std::vector<HistoryValue>&) const;         \
  template void HeatModule<T>::surfaces(const Clock& clock, const OutputSection&, std::vector<HistoryValue>&) const;   \
  template void SoluteModule<T, D2Q5>::surfaces(const Clock&, const OutputSection&, std::vector<HistoryValue>&) const; \
  template void SoluteModule<T, D2Q9>::surfaces(const Clock&, const OutputSection&, std::vector<HistoryValue>&) const;
VUG_FOR_NUMBERS(VUG_INSTANTIATE)
#undef VUG_INSTANTIATE

}  // namespace vug
