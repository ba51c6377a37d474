#pragma once
// Flow through the pores (paper section 2.1).
#include "coupling/carrier.hpp"
#include "coupling/flow_paths.hpp"
#include "coupling/module.hpp"
#include "coupling/steady_flow.hpp"
#include "coupling/stretch_links.hpp"
#include "coupling/temperature_range.hpp"
#include "kernels/base/units.hpp"
#include "kernels/flow/flow.hpp"
#include "kernels/flow/guards.hpp"
#include "kernels/heat/thermal_flow.hpp"

#include <deque>

namespace vug {

/// Owns the flow populations, velocity and pressure. Beside these it writes only which links of the fluid nodes its
/// sides and openings leave open (mark_open).
template <class T>
class FlowModule final : public Module {
 public:
  /// `paths`: those of the fluid at the start.
  FlowModule(const Exec& exec, const Scene& scene, const LatticeUnits& units, const Geometry& geometry,
             const FlowPaths& paths);

  std::string_view name() const override { return "flow"; }
  void step(const Exec& exec, const Clock& clock) override;
  void tasks(std::vector<Task>& schedule) const override;
  void gather(const Exec& exec) override;
  void visit_shares(const SharedFields& visit) const override;
  void births(const Exec& exec, const Births& births) override;
  void guard(const Exec& exec, const Clock& clock) override;
  void limits(LimitTable& table) const override;
  void ledger(Ledger& ledger) const override;
  void history(std::vector<HistoryValue>& row) const override;
  void surfaces(const Clock& clock, const OutputSection& wanted, std::vector<HistoryValue>& row) const override;
  void fields(FieldList& list) const override;
  void watch(const Exec& exec, const Clock& clock, Changes& changes) override;
  void state(StateList& list) override;

  const FlowFields<T>& flow() const { return fields_; }
  /// force and torque of triangles += the drag of the fluid in slits (slit_drag.hpp), of triangles about `centre`.
  void add_slit_drag(const Exec& exec, const VectorField<double>& centre, const VectorField<double>& force,
                     const ScalarField<double>& torque) const;
  /// Whether its forces depend on the temperature.
  bool buoyant() const { return section_.buoyant(); }
  /// Whether its forces or its viscosity do.
  bool needs_temperature() const { return buoyant() || section_.viscosity_varies(); }
  /// Where the temperature of the fluid nodes is found (fluid), brought up to date after every step of the heat.
  void be_heated_by(const ScalarField<T>& theta) { theta_ = &theta; }
  /// Whether it changes by no more than accuracy.flow_tolerance.
  bool settled() const { return steady_.settled(); }
  /// Largest speed that the case can drive, lattice units: what the sides prescribe, in the narrowest passage as well,
  /// and Bernoulli's bound of their pressures, at most the speed limit; that limit where a body force drives.
  double largest_speed() const;
  /// What carries a scalar that steps every `interval` lattice steps with a set of `directions` velocities, the even
  /// part of the defect weighed (advective_form.hpp). Asked for at set-up; the reference stays valid.
  const Carrier<T>& carrier(const Exec& exec, int interval, int directions, T even_weight = 1);
  /// Has a carrier go by another number of lattice steps. Where these change as the run goes, no two scalars share one.
  void set_interval(const Carrier<T>& carrier, int interval);
  /// (fluid, axis) How much less flows through faces than mean velocities say (flow/face_flow.hpp), after the last of
  /// every `interval` lattice steps. Asked for at set-up, by one; the reference stays valid.
  const VectorField<T>& face_excess(const Exec& exec, int interval);

 private:
  double largest_pressure() const;
  double prescribed_speed() const;
  std::string advice_on_divergence() const;
  void prepare_thermal_flow(const Exec& exec, const Scene& scene);
  void find_boundaries(const Exec& exec);
  void find_halos();
  /// What only its rank has booked at sides and openings, and the levels of outflows, on all of them.
  void gather_sums() const;
  /// Has every rank know what leaves through all sides and openings, the velocities that these ask for, and the levels.
  void bring_to_all_links(const Exec& exec) const;
  /// Gives back what our last sweep left in slots of other ranks' nodes, and the other way round.
  void return_populations(const Exec& exec) const;
  /// That of all ranks' nodes; of populations that have been given back.
  double mass() const;
  double sum_mass() const;
  double viscosity() const { return section_.viscosity / units_.diffusivity(); }  ///< lattice units
  FlowExtremes extremes(const Exec& exec) const;
  /// Whether the flow is steady.
  void look(const Exec& exec, const Clock& clock, const FlowExtremes& extremes);
  /// What a velocity, or a flow rate over the surface that it has, gives at a time (s), lattice units.
  double given_speed(const StretchLinks& boundary, double time) const;
  std::array<double, 2> given_velocity(const StretchLinks& boundary, double time) const;
  /// What a boundary says at a time (s); gain(link) += what enters.
  FlowCondition condition(const StretchLinks& boundary, double time, const ScalarField<double>& gain) const;
  void fit_carrier(const Exec& exec, Carrier<T>& carrier);
  void find_excess(const Exec& exec) const;

  FlowSection section_;
  LatticeUnits units_;
  const Geometry& geometry_;
  TemperatureRange range_;
  double buoyant_speed_ = 0;  ///< lattice units, of free convection
  ViscosityLaw viscosity_;
  const ScalarField<T>* theta_ = nullptr;
  FlowPaths paths_;  ///< at the start
  std::vector<StretchLinks> boundaries_;
  std::vector<FlowCondition> conditions_;  ///< those of boundaries_ in this step
  FlowFields<T> fields_;
  FlowStep<T> step_;
  VectorField<T> excess_;  ///< empty: nobody has asked for it
  int excess_interval_ = 1;
  std::deque<Carrier<T>> carriers_;
  bool varies_;        ///< their intervals do (accuracy.tolerance)
  bool fills_slowly_;  ///< cracks may be far narrower than a cell: no look tells that their pressure still changes
  double raised_ = 0;  ///< s, when all conditions have their last values
  SteadyFlow<T> steady_;
  /// What other ranks compute: populations that our sweep pulls; those that leave through the images of our links of
  /// sides and openings; velocities that carry, or that our links need; those of nodes in our rows.
  Halo populations_, dressed_, velocities_, in_rows_, around_;
  double initial_mass_ = 0;  ///< lattice units, as are all sums below
  double born_mass_ = 0;
  std::int64_t slit_changes_ = 0;  ///< those of the geometry that this flow has seen
};

}  // namespace vug
