#pragma once
// Flow through the pores (paper section 2.1).
#include "coupling/body_forces.hpp"
#include "coupling/carrier.hpp"
#include "coupling/flow_paths.hpp"
#include "coupling/module.hpp"
#include "coupling/steady_flow.hpp"
#include "coupling/stretch_links.hpp"
#include "coupling/temperature_range.hpp"
#include "io/units.hpp"
#include "kernels/flow/flow.hpp"
#include "kernels/flow/guards.hpp"
#include "kernels/heat/thermal_flow.hpp"

#include <deque>

namespace vug {

/// Owns the flow populations, velocity and pressure. Of other data it writes only which links of the fluid nodes are
/// open at its sides and openings (mark_open).
template <class T>
class FlowModule final : public Module {
 public:
  /// `paths`: the flow paths at the start.
  FlowModule(const Exec& exec, const Scene& scene, const LatticeUnits& units, const Geometry& geometry,
             const FlowPaths& paths);

  std::string_view name() const override { return "flow"; }
  void step(const Exec& exec, const Clock& clock) override;
  void tasks(std::vector<Task>& schedule) const override;
  void gather(const Exec& exec) override;
  void visit_shares(const SharedFields& visit) const override;
  void births(const Exec& exec, const Births& births) override;
  void guard(const Exec& exec, const Clock& clock) override;
  std::vector<Concern> concerns(const Exec& exec) const override;
  void limits(LimitTable& table) const override;
  void ledger(Ledger& ledger) const override;
  void history(std::vector<HistoryValue>& row) const override;
  void surfaces(const Clock& clock, const OutputSection& wanted, std::vector<HistoryValue>& row) const override;
  void fields(FieldList& list) const override;
  void watch(const Exec& exec, const Clock& clock, Changes& changes) override;
  void state(StateList& list) override;

  const FlowFields<T>& flow() const { return fields_; }
  /// Adds the drag of the fluid in slits (slit_drag.hpp) to force and torque (about `centre`) of triangles.
  void add_slit_drag(const Exec& exec, const VectorField<double>& centre, const VectorField<double>& force,
                     const ScalarField<double>& torque) const;
  /// Whether the forces on the fluid depend on the temperature.
  bool buoyant() const { return section_.buoyant(); }
  /// Whether the forces on the fluid or its viscosity depend on the temperature.
  bool needs_temperature() const { return buoyant() || section_.viscosity_varies(); }
  /// Sets the field with the temperature of the fluid nodes (fluid), which the heat module updates after its steps.
  void be_heated_by(const ScalarField<T>& theta) { theta_ = &theta; }
  /// Whether the flow changes by no more than accuracy.flow_tolerance.
  bool settled() const { return steady_.settled(); }
  /// Largest speed that the case can drive, lattice units: the largest prescribed speed (also in passages) plus that of
  /// free convection (or of warm fluid between open sides), that of the weight that sets in, and that of the pressures
  /// (Bernoulli's, or a higher one of viscous flow), at most the speed limit. Where a body force drives the fluid
  /// (is_driven) it is the speed limit. It does not depend on when the run ends.
  double largest_speed() const;
  /// The carrier of a scalar that takes a step every `interval` lattice steps, on a set of `directions` velocities.
  /// `even_weight` weights the even part of the defect (advective_form.hpp). Called at set-up; the reference stays
  /// valid.
  const Carrier<T>& carrier(const Exec& exec, int interval, int directions, T even_weight = 1);
  /// Changes the interval of a carrier. Where intervals change during the run, no two scalars share a carrier.
  void set_interval(const Carrier<T>& carrier, int interval);
  /// (fluid, axis) By how much the flow through a face is less than the mean velocity of its nodes
  /// (flow/face_flow.hpp), after the last of every `interval` lattice steps. Called at set-up, by one module only; the
  /// reference stays valid.
  const VectorField<T>& face_excess(const Exec& exec, int interval);

 private:
  /// Largest difference between the given pressures, or from the initial one, lattice units.
  double pressure_difference() const;
  /// The part of it that drives fluid: where body forces f act, the difference of p - f.x (driving_pressure.hpp).
  double driving_pressure() const;
  /// Whether body forces act on the fluid at the start where it can follow them: along joined sides, or with a side or
  /// opening through which the flow follows from the pressure. In a closed box they are its weight.
  bool is_driven() const;
  double speed_limit() const { return section_.speed_limit > 0 ? section_.speed_limit : speed_bound; }
  double prescribed_speed() const;
  double lowest_viscosity() const;  ///< lattice units, in the range of temperatures
  std::string advice_on_divergence() const;
  void prepare_thermal_flow(const Exec& exec, const Scene& scene);
  void find_boundaries(const Exec& exec);
  void find_halos();
  /// Makes the gains of all links of sides and openings, and the levels of outflows, known on all ranks.
  void gather_sums() const;
  /// Makes known on all ranks, for all sides and openings: the populations that leave, the velocities at links, and
  /// what gather_sums() does.
  void bring_to_all_links(const Exec& exec) const;
  /// Sends back the populations that our last sweep left in slots of other ranks' nodes, and receives our own.
  void return_populations(const Exec& exec) const;
  /// Mass in the nodes of all ranks; sum_mass needs populations that have been returned.
  double mass() const;
  double sum_mass() const;
  double viscosity() const { return section_.viscosity / units_.diffusivity(); }  ///< lattice units
  FlowExtremes extremes(const Exec& exec) const;
  /// Checks whether the flow is steady.
  void look(const Exec& exec, const Clock& clock, const FlowExtremes& extremes);
  /// Speed (or velocity) at a boundary with a given velocity or flow rate at a time (s), lattice units.
  double given_speed(const StretchLinks& boundary, double time) const;
  std::array<double, 2> given_velocity(const StretchLinks& boundary, double time) const;
  /// The condition of a boundary at a time (s), which adds what enters to gain (link).
  FlowCondition condition(const StretchLinks& boundary, double time, const ScalarField<double>& gain) const;
  FlowCondition sliding(const StretchLinks& boundary, double time, const ScalarField<double>& gain) const;
  /// The condition of a pressure or an outflow, with what other boundaries do to the links past its ends.
  FlowCondition joined(FlowCondition made, const StretchLinks& boundary, double time) const;
  void fit_carrier(const Exec& exec, Carrier<T>& carrier);
  void find_excess(const Exec& exec) const;

  FlowSection section_;
  LatticeUnits units_;
  const Geometry& geometry_;
  BodyForces forces_;
  TemperatureRange range_;
  double buoyant_speed_ = 0;  ///< lattice units, of free convection
  ViscosityLaw viscosity_;
  const ScalarField<T>* theta_ = nullptr;
  FlowPaths paths_;  ///< at the start
  std::vector<StretchLinks> boundaries_;
  std::vector<FlowCondition> conditions_;  ///< of boundaries_ in this step
  FlowFields<T> fields_;
  FlowStep<T> step_;
  VectorField<T> excess_;  ///< empty where no module uses it
  int excess_interval_ = 1;
  std::deque<Carrier<T>> carriers_;
  bool varies_;        ///< whether intervals of carriers change (accuracy.tolerance)
  bool fills_slowly_;  ///< cracks may be far narrower than a cell: velocities do not show that their pressure changes
  bool pores_open_;    ///< rock may become fluid, so that paths_ are not those of the whole run
  bool pathways_in_cells_;  ///< there is [rock], whose pathways are a number of cells wide: the pressure may be scaled
  double raised_ = 0;       ///< s, from when on all conditions have their final values
  SteadyFlow<T> steady_;
  /// Values that other ranks compute: populations that our sweep pulls; populations that leave through links that we
  /// dress; velocities that carry scalars or that our links need; values of fluid nodes in our rows; all populations of
  /// the neighbours of our nodes (for face_excess).
  Halo populations_, dressed_, velocities_, in_rows_, around_;
  double initial_mass_ = 0;  ///< lattice units, as are all sums below
  double born_mass_ = 0;
  std::int64_t slit_changes_ = 0;  ///< of the geometry, up to which this flow has adapted
};

}  // namespace vug
