#pragma once
// The reaction at the walls and the solid it dissolves (paper Eqs. 6-9, 21-24).
#include "coupling/heat_module.hpp"
#include "coupling/module.hpp"
#include "coupling/solute_module.hpp"
#include "kernels/reactive_wall.hpp"

namespace vug {

/// How fast every link at a wall reacts, and what that has dissolved. The solutes react at the links when they step:
/// this stands before them in the list of modules, and TurnoverModule after them.
/// `heat` may be null: the temperature of the case is used everywhere.
template <class T, class Set>
class ReactionModule final : public Module {
 public:
  ReactionModule(const Exec& exec, const Scene& scene, const LatticeUnits& units, Geometry& geometry,
                 SoluteModule<T, Set>& solutes, const HeatModule<T>* heat);

  std::string_view name() const override { return "reaction"; }
  void step(const Exec& exec, const Clock& clock) override;
  void births(const Exec& exec, const Births& births) override;
  void limits(LimitTable& table) const override;
  void ledger(Ledger& ledger) const override;
  void history(std::vector<HistoryValue>& row) const override;
  void fields(FieldList& list) const override;
  void state(StateList& list) override;

  /// Takes what has reacted off the solid nodes.
  void book(const Exec& exec);

  /// (block) volume that dissolving pixels were overdrawn by and that found no neighbour, pixels.
  const ScalarField<double>& lost() const { return lost_; }

 private:
  /// Surface normals and what the links conduct, where they are due: the solid shrinks and the temperature changes
  /// slowly, so both are renewed at every wall interval, sooner at the start of a run, and where the links are new.
  void refresh(const Exec& exec, std::int64_t step);
  /// Volume that has reacted and is not yet taken off the solid, pixels.
  double dissolving() const;

  ReactionSection section_;
  LatticeUnits units_;
  Geometry& geometry_;
  const SoluteModule<T, Set>& solutes_;
  SpeciesState<T>& reactant_;
  SpeciesState<T>* product_;
  const HeatModule<T>* heat_;
  ReactiveWall wall_;
  LongSum consumed_;  ///< (block) reactant that has reacted
  ReactionLedger sums_;
  VectorField<double> normal_;  ///< (surface, axis); empty when the stair-step area is not corrected
  ReactiveLinks<T> links_;      ///< their turnover is booked at every update interval, before pores
  ScalarField<double> lost_;
  int wall_interval_;
  std::int64_t refreshed_ = -1;  ///< the step in which the links were refreshed last; -1: they are new
  bool faster_;  ///< the rock ages faster than the fluid (accuracy.dissolution_factor)
  double initial_volume_ = 0;  ///< pixels
};

/// Books what has reacted at the end of every update interval, before mechanics and pore growth ask for it.
template <class T, class Set>
class TurnoverModule final : public Module {
 public:
  TurnoverModule(ReactionModule<T, Set>& reaction, int update_interval)
      : reaction_(reaction),
        update_interval_(update_interval) {}

  std::string_view name() const override { return "turnover"; }
  void step(const Exec& exec, const Clock& clock) override {
    if (clock.every(update_interval_)) reaction_.book(exec);
  }

 private:
  ReactionModule<T, Set>& reaction_;
  int update_interval_;
};

}  // namespace vug
