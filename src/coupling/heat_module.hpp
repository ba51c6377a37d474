#pragma once
// Heat through fluid and rock (paper section 2.2).
#include "coupling/face_temperature.hpp"
#include "coupling/flow_module.hpp"
#include "coupling/module.hpp"
#include "coupling/step_times.hpp"
#include "coupling/temperature_range.hpp"
#include "io/units.hpp"
#include "kernels/heat/heat.hpp"
#include "kernels/heat/heat_boundary.hpp"
#include "kernels/heat/heat_sums.hpp"
#include "kernels/launch/long_sum.hpp"

namespace vug {

/// Largest relaxation time, and largest number of cells that the fluid may move in a heat step (docs/stability.md).
inline constexpr double largest_relaxation_time = 3.5, longest_way = 0.5;

/// Owns the temperature of every node. `flow` may be null: conduction only. A step is taken every
/// accuracy.heat_interval lattice steps, with diffusivities and velocity multiplied by that number.
template <class T>
class HeatModule final : public Module {
 public:
  HeatModule(const Exec& exec, const Scene& scene, const LatticeUnits& units, const Geometry& geometry,
             FlowModule<T>* flow);

  std::string_view name() const override { return "heat"; }
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
  void bound(std::optional<double> speed, Intervals& most) const override;
  void watch(const Exec& exec, const Clock& clock, Changes& changes) override;
  void take(const Exec& exec, const Intervals& intervals) override;
  void resume(const Exec& exec, const Intervals& intervals) override;
  void state(StateList& list) override;

  /// (node) present temperatures in our rows and at the `others` (Split::beyond_rows), except in openings, for rock and
  /// reaction. They are taken together with a heat step if the rock needs them before the next one, otherwise when they
  /// are requested; at most once between two steps.
  const ScalarField<T>& temperature(const Exec& exec, const Halo& others) const;
  double initial_theta() const { return initial_theta_; }
  /// Temperature of the faces between solid and fluid, for the reaction.
  FaceTemperature<T> face_temperature(const Exec& exec, const Halo& others) const;
  /// Of all temperatures in the case.
  const TemperatureRange& range() const { return range_; }
  /// Whether given fluxes may lead beyond it.
  bool may_leave_range() const { return largest_flux_ > 0; }
  HeatExtremes extremes(const Exec& exec) const;

 private:
  void find_halos();
  /// The nodes before those at outflows in our rows (kernels/scalar/turning.hpp).
  std::vector<int> nodes_before_outflows() const;
  /// Populations in other ranks' rows that this rank fills in for its own rows to conduct from, beside diagonals and in
  /// openings; a checkpoint has them there.
  std::vector<int> slots_filled_beyond() const;
  /// Brings to all ranks the sums that only one rank has booked: what entered and what was created.
  void gather_sums() const;
  /// Owners of the entries of entered_[boundary].
  Owners owners_of_entries(std::size_t boundary) const;
  /// Sets fluid_theta_ after a step, at the nodes that this rank sweeps.
  void take_temperatures_of_fluid(const Exec& exec) const;
  /// The same before the first step, from fluid node `first` on.
  void begin_temperatures_of_fluid(const Exec& exec, int first) const;
  double energy() const;
  /// Sets minerals_ by number, beginning with rock that is no mineral; empty where no mineral has numbers of its own.
  void set_up_minerals(const Scene& scene);
  HeatParameters parameters() const;
  /// How far temperatures may be outside those of the case at a time (s), K.
  double margin(double time) const;
  bool rock_asks_before_next_step(const Clock& clock) const;
  /// Value of a condition, at a time (s), in the units of the kernels, and its transfer coefficient.
  double value_of(const HeatBoundary& heat, double time) const;
  /// The value for a step with these times.
  double value_of(const HeatBoundary& heat, const StepTimes& times) const;
  double transfer_of(const HeatBoundary& heat) const;
  HeatCrossing<T> crossing() const;
  /// Sets the values of conditions that change to those of a time, s.
  void set_values(double time);
  /// Steps take this many lattice steps, from the next streaming on.
  void set_interval(int interval);
  /// The same for the step that follows, whose collision converts the populations. Returns the factor for the
  /// displacement in this step (turning.hpp).
  double turn(double stretch);
  int directions() const { return section_.velocity_set == ScalarVelocitySet::d2q9 ? D2Q9::Q : D2Q5::Q; }

  /// A mineral as given by the case.
  struct Mineral {
    std::string name;
    double diffusivity, density, heat_capacity;
  };

  /// lambda_s/(lambda_f + lambda_s) for a solid.
  double solid_share(double density, double heat_capacity, double diffusivity) const;

  HeatSection section_;
  std::vector<Mineral> minerals_;
  ScalarField<double> solid_share_;  ///< (mineral) for FaceTemperature; empty without minerals
  LatticeUnits units_;
  const Geometry& geometry_;
  FlowModule<T>* flow_;                  ///< null: the fluid is at rest
  const Carrier<T>* carrier_ = nullptr;  ///< likewise
  int interval_, next_interval_;         ///< lattice steps until the end of the step that follows, and after it
  int update_interval_;                  ///< the rock needs temperatures in the lattice steps that are multiples of it
  HeatFields<T> fields_;
  ScalarField<T> theta_;            ///< (node) result of `temperature`; empty where neither rock nor reaction needs it
  ScalarField<T> watched_;          ///< (node) temperatures at the last look; empty where changes are not watched
  ScalarField<T> fluid_theta_;      ///< (fluid) temperatures for the flow; empty where it does not depend on them
  ScalarField<T> before_;           ///< (fluid) those of the last step; empty unless the fluid is buoyant
  mutable bool fresh_ = false;      ///< theta_ is up to date
  Halo populations_;                ///< of other ranks' nodes, for conduction and outflows in our rows
  Halo filled_;                     ///< in other ranks' rows, filled in by this rank
  Halo in_rows_;                    ///< fluid nodes in our rows that other ranks sweep
  std::vector<Stretch> stretches_;  ///< those of sides_, in the same order
  std::vector<HeatSide> sides_;
  std::vector<HeatOpening> openings_;  ///< those of the geometry, in the same order
  std::array<bool, 2> periodic_;
  ScalarField<T> lagged_;         ///< (fluid) state of the advective correction
  FluidRows rows_;                ///< empty without flow
  std::vector<LongSum> entered_;  ///< energy that entered through each of sides_, then of openings_
  LongSum created_;               ///< (row) energy that the advective form added
  ScalarField<double> born_;      ///< (block) energy that births added
  double initial_theta_ = 0;
  TemperatureRange range_;     ///< that the case names
  double largest_flux_ = 0;    ///< W/m2, of all given ones: temperatures may leave the range that the case names
  double fastest_ = 0;         ///< largest speed that carries heat, lattice units
  double initial_energy_ = 0;  ///< in fluid heat capacities
};

}  // namespace vug
