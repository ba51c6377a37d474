#pragma once
// Dissolved species carried by the fluid (paper sections 2.3, 3.2).
#include "coupling/flow_module.hpp"
#include "coupling/module.hpp"
#include "coupling/step_times.hpp"
#include "coupling/stretch_links.hpp"
#include "io/units.hpp"
#include "kernels/flow/guards.hpp"
#include "kernels/reaction/dissolution.hpp"
#include "kernels/reaction/reactive_wall.hpp"
#include "kernels/solute/solute_boundary.hpp"

namespace vug {

/// One species: its state, its boundaries and the terms of its balance.
template <class T>
struct SpeciesState {
  Species section;
  SoluteParameters parameters;
  SoluteFields<T> fields;
  std::vector<StretchLinks> boundaries;
  LongSum correction;           ///< (block) added by the advective form
  ScalarField<double> created;  ///< (block) added by filling newborn nodes
  ScalarField<T> watched;       ///< (fluid) concentration at the last look; empty where changes are not watched
  double initial = 0;           ///< lattice units

  SteppingSolute<T> stepping() { return {parameters, fields, correction.recent()}; }
  void settle(const Exec& exec) const {
    correction.settle(exec);
    for (const StretchLinks& boundary : boundaries) boundary.gain.settle(exec);
  }
};

/// Reactant and product (which may be null), and the wall at which one turns into the other.
template <class T>
struct ReactingSpecies {
  const ReactiveWall* wall = nullptr;
  const ReactiveLinks<T>* links = nullptr;
  SpeciesState<T>* reactant = nullptr;
  SpeciesState<T>* product = nullptr;
  std::string key{};  ///< of the states of the links
};

/// Largest concentrations of a species, lattice units: what is given or what fluxes and reactions can maintain across
/// the lattice; and what fluxes can have put into the smallest closed space by now.
struct Reach {
  double steady = 0, now = 0;
};

/// Largest number of cells that the fluid may move in a step (higher ones were not tried), and the largest diffusivity
/// (docs/stability.md).
inline constexpr double longest_way_of_solutes = 0.4, largest_diffusivity_of_solutes = 1;

/// Owns the populations of all species. `flow` may be null: diffusion only. A step is taken every
/// accuracy.solute_interval lattice steps, with diffusivity, velocity and rate constant multiplied by that number.
template <class T, class Set>
class SoluteModule final : public Module {
 public:
  SoluteModule(const Exec& exec, const Scene& scene, const LatticeUnits& units, const Geometry& geometry,
               FlowModule<T>* flow);

  std::string_view name() const override { return "solute"; }
  void step(const Exec& exec, const Clock& clock) override;
  void tasks(std::vector<Task>& schedule) const override;
  void gather(const Exec& exec) override;
  void visit_shares(const SharedFields& visit) const override;
  void births(const Exec& exec, const Births& births) override;
  void guard(const Exec& exec, const Clock& clock) override;
  std::vector<Concern> concerns(const Exec& exec) const override;
  void limits(LimitTable& table) const override;
  void ledger(Ledger& ledger) const override;
  void surfaces(const Clock& clock, const OutputSection& wanted, std::vector<HistoryValue>& row) const override;
  void fields(FieldList& list) const override;
  void bound(std::optional<double> speed, Intervals& most) const override;
  void watch(const Exec& exec, const Clock& clock, Changes& changes) override;
  void take(const Exec& exec, const Intervals& intervals) override;
  void resume(const Exec& exec, const Intervals& intervals) override;
  void state(StateList& list) override;

  bool due(const Clock& clock) const { return clock.every(interval_); }
  /// Amount on the nodes of all ranks, lattice units.
  double total(const SpeciesState<T>& s) const;
  /// State of the species with that name.
  SpeciesState<T>& species(const std::string& name);
  /// From now on these pairs react in every step; `jointly`: one reads what another one changes.
  void react(std::vector<ReactingSpecies<T>> reacting, bool jointly) {
    reacting_ = std::move(reacting);
    jointly_ = jointly;
  }

 private:
  void find_boundaries(const Exec& exec);
  void find_halos();
  /// The fluid nodes before those at outflows (kernels/scalar/turning.hpp).
  std::vector<int> nodes_before_outflow() const;
  SoluteParameters parameters_of(const Species& species) const;
  /// (species) The largest concentrations that the case may cause at a time (s), lattice units.
  std::vector<Reach> reaches(double time) const;
  FieldRange range_of(const Exec& exec, const SpeciesState<T>& s) const;
  /// Steps take this many lattice steps, from the next streaming on.
  void set_interval(int interval);
  /// A sweep whose collision converts the populations to steps of another length (turning.hpp).
  void turn(const Exec& exec);
  /// The velocity that carries all species alike.
  SoluteCarrier<T> carrier_of_all() const;
  /// Sweeps all species and lets them react.
  void sweep(const Exec& exec);
  /// The same for several pairs, which may have species in common: all species step, then the walls take from each.
  void step_pairs(const Exec& exec, const SoluteCarrier<T>& carrier);
  /// Brings to all ranks the sums of what has entered, left and been added.
  void gather_sums(const SpeciesState<T>& s) const;
  /// After the sweep: applies what links hold back or exchange in addition.
  void act_on_links(const Exec& exec);
  /// Brings to this rank the populations that the next sweep of a species pulls.
  void exchange(const Exec& exec, const SoluteFields<T>& fields) const;
  /// The condition of a species at a boundary, averaged over these times; gain(link) += what enters.
  SoluteCondition<T> condition(const SpeciesState<T>& s, const StretchLinks& boundary, const StepTimes& times,
                               const ScalarField<double>& gain) const;
  Crossing<T> crossing() const;

  SoluteSection section_;
  LatticeUnits units_;
  const Geometry& geometry_;
  FlowModule<T>* flow_;                     ///< null: the fluid is at rest
  const Carrier<T>* carrier_;               ///< likewise
  const VectorField<T>* excess_ = nullptr;  ///< what faces exchange (solute/face_exchange.hpp); null: nothing
  int interval_, next_interval_;            ///< lattice steps until the end of the step that follows, and after it
  int compared_ = 0;                        ///< number of fluid nodes at the last look
  BirthFill fill_;
  double fastest_ = 0;  ///< largest speed that carries them, lattice units
  bool ages_ = false;   ///< looks compare concentrations (ageing_module.hpp), for which random rounding is a change
  std::vector<SpeciesState<T>> species_;
  std::vector<SoluteCondition<T>> conditions_;  ///< at the boundaries of all species, in this step
  bool narrow_ = false;                         ///< see is_narrow; of links of an outflow
  Halo populations_;                            ///< of other ranks' nodes, which our sweeps pull
  Halo before_outflow_;                         ///< other ranks' nodes before those at outflows
  Halo neighbours_;                             ///< of our nodes, for act_on_links
  std::vector<ReactingSpecies<T>> reacting_;
  bool jointly_ = false;
};

}  // namespace vug
