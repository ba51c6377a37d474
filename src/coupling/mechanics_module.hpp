#pragma once
// The rock's mechanics, driven by fluid, heat and dissolution (paper sections 2.4, 3.1, 3.4).
#include "coupling/chemical_damage.hpp"
#include "coupling/flow_module.hpp"
#include "coupling/heat_module.hpp"
#include "coupling/module.hpp"
#include "coupling/rock.hpp"
#include "coupling/rock_gauges.hpp"
#include "coupling/thermal_exchange.hpp"
#include "dem/mechanics.hpp"
#include "kernels/flow/momentum_exchange.hpp"

#include <optional>

namespace vug {

/// Owns particles and bonds. `flow` and `heat` may be null; dissolution acts where rock_dissolves.
template <class T>
class MechanicsModule final : public Module {
 public:
  MechanicsModule(const Exec& exec, const Scene& scene, const LatticeUnits& units, const Geometry& geometry,
                  const Rock& rock, const FlowModule<T>* flow, const HeatModule<T>* heat);

  std::string_view name() const override { return "mechanics"; }
  void begin(const Exec& exec) override;
  void step(const Exec& exec, const Clock& clock) override;
  void tasks(std::vector<Task>& schedule) const override;
  void catch_up(const Exec& exec) override;
  void births(const Exec& exec, const Births& births) override;
  void guard(const Exec& exec, const Clock& clock) override;
  void limits(LimitTable& table) const override;
  std::vector<Concern> concerns(const Exec& exec) const override;
  void history(std::vector<HistoryValue>& row) const override;
  void fields(FieldList& list) const override;
  void watch(const Exec& exec, const Clock& clock, Changes& changes) override;
  void take(const Exec& exec, const Intervals& intervals) override;
  void resume(const Exec& exec, const Intervals& intervals) override { take(exec, intervals); }
  void state(StateList& list) override;

  const Mechanics& mechanics() const { return mechanics_; }
  /// Number of triangles of fragments that have been let go so far; waits for the device.
  int fragments_let_go() const { return section_.lets_fragments_go ? dissolved_->let_go_count() : 0; }

 private:
  void choose_substeps();
  void find_links(const Exec& exec);
  void share_links();
  void share_temperatures();
  /// Gives triangles the mean temperature of their nodes, or the given temperature of the opening that contains them.
  void warm(const Exec& exec, double time);

  MechanicsSection section_;
  LatticeUnits units_;
  const Geometry& geometry_;
  const FlowModule<T>* flow_;
  const HeatModule<T>* heat_;
  int update_interval_, exchange_interval_, guard_interval_;
  double warming_ = 0;           ///< largest change of temperature that the case names, K
  bool holds_forces_;            ///< forces of the fluid are held for more than a step
  VectorField<double> watched_;  ///< (triangle, axis) force of the fluid at the last look; empty where unused
  TriangleNeighbours neighbours_;
  ThermalNodes thermal_;  ///< only with heat
  Mechanics mechanics_;
  std::vector<std::pair<std::vector<int>, std::array<double, 2>>> initial_velocities_;  ///< triangles, m/s
  RockGauges gauges_;
  std::vector<std::string> fields_asked_for_;  ///< output.fields
  std::optional<WetNodes> wet_;                ///< only with flow or dissolution
  std::optional<IndexList> our_triangles_;     ///< whose force of the fluid this rank sums; only with several ranks
  std::optional<IndexList> our_warmed_;        ///< whose mean temperature this rank computes; only with several ranks
  Owners of_warmed_;                           ///< (particle)
  Halo temperatures_;                          ///< of other ranks' nodes in our_warmed_
  Halo walls_;                                 ///< populations of other ranks' nodes that push our_triangles_
  Halo forces_;                                ///< on triangles of other ranks
  WallLinks links_;                            ///< of each particle, about its centroid; only with flow
  std::optional<DissolvedShares> dissolved_;   ///< only with dissolution
  int substeps_ = 1;
  int owed_ = 0;  ///< lattice steps whose sub-steps are still to be taken
  RockIs rock_ = RockIs::the_same;
};

}  // namespace vug
