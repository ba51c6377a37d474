#pragma once
// The reactions at the walls and the solid they dissolve (paper Eqs. 6-9, 21-24).
#include "coupling/heat_module.hpp"
#include "coupling/module.hpp"
#include "coupling/pore_growth.hpp"
#include "coupling/solute_module.hpp"
#include "kernels/reaction/reactive_wall.hpp"

namespace vug {

/// Acid that has reacted, at the factor by which the rock aged faster when it did (accuracy.dissolution_tolerance).
struct AgedAcid {
  double earlier = 0;  ///< factor times what had reacted until the factor changed last
  double seen = 0;     ///< what had reacted until then
  /// Of `now` in all: what would have dissolved as much at this factor.
  double at(double now, double factor) const { return earlier / factor + (now - seen); }
  void change(double now, double factor) {
    earlier += factor * (now - seen);
    seen = now;
  }
};

/// One reactant at the walls.
template <class T>
struct Attack {
  std::string key;  ///< of its states, and before names in the ledger: empty of the first
  SpeciesState<T>* reactant = nullptr;
  SpeciesState<T>* product = nullptr;  ///< may be null
  RateLaw rate;                        ///< of rock that no mineral holds
  std::vector<RateLaw> rates;          ///< (mineral) number 0 is that rock; empty without minerals
  ReactiveWall wall;
  Kokkos::View<MineralRate*> table;  ///< (mineral) of the wall, where its own constants do not say all
  ReactiveLinks<T> links;            ///< their turnover is booked at every update interval, before pores
  LongSum consumed;                  ///< (block) reactant that has reacted
  ReactionLedger sums;
  double watched = 0;          ///< reactant that had reacted at the last look
  std::vector<AgedAcid> aged;  ///< (mineral) of all rock where there are none

  /// What its states begin with.
  std::string state_key() const { return key.empty() ? "reaction" : "reaction/" + key; }
};

/// How fast every link at a wall reacts, and what that has dissolved. The solutes react at the links when they step:
/// this stands before them in the list of modules, and TurnoverModule after them.
/// `heat` may be null: the temperature of the case is used everywhere. So may `opener`, where there are no pathways.
template <class T, class Set>
class ReactionModule final : public Module {
 public:
  ReactionModule(const Exec& exec, const Scene& scene, const LatticeUnits& units, Geometry& geometry,
                 SoluteModule<T, Set>& solutes, const HeatModule<T>* heat, PathwayOpener* opener);

  std::string_view name() const override { return "reaction"; }
  void step(const Exec& exec, const Clock& clock) override;
  void tasks(std::vector<Task>& schedule) const override;
  void gather(const Exec&) override;
  void births(const Exec& exec, const Births& births) override;
  void limits(LimitTable& table) const override;
  void ledger(Ledger& ledger) const override;
  void history(std::vector<HistoryValue>& row) const override;
  void fields(FieldList& list) const override;
  void bound(std::optional<double> speed, Intervals& most) const override;
  void watch(const Exec& exec, const Clock& clock, Changes& changes) override;
  void take(const Exec& exec, const Intervals& intervals) override;
  void resume(const Exec& exec, const Intervals& intervals) override;
  void state(StateList& list) override;

  /// Names of what each reactant has at its links and of it, as in a checkpoint: "reaction/link_acid".
  std::vector<std::string> names(std::initializer_list<const char*> parts) const;

  /// Takes what has reacted off the solid nodes.
  void book(const Exec& exec);

  /// By how much faster the rock ages than the fluid, from now on; what has reacted is booked before.
  void set_factor(const Exec& exec, double factor);
  /// Volume that all acid consumed so far has paid for, m3/m.
  double paid() const;
  /// Largest share of a cell that a wall node has lost since that was last booked. Waits for the device.
  double largest_loss(const Exec& exec);
  /// A species whose concentration decides how much dissolves, and the most that a lattice unit of its amount dissolves
  /// at the factor 1, m3/m.
  struct Sway {
    const SpeciesState<T>* species;
    double volume;
  };
  std::vector<Sway> sways() const;

  /// What dissolving pixels were overdrawn by without an heir; `all` is empty where nothing dissolves.
  const PoreGrowth::Losses& losses() const { return losses_; }

 private:
  /// Surface normals and what the links conduct, where they are due: the solid shrinks and the temperature changes
  /// slowly, so both are renewed at every wall interval, sooner at the start of a run, and where the links are new.
  void refresh(const Exec& exec, std::int64_t step);
  /// Brings on every rank what the links have turned over.
  void gather_links() const;
  Owners owners_of_links(const Attack<T>& attack) const;
  /// Which links are ours, the surface nodes that they lead from, and the nodes whose temperature they ask for.
  void share_links();
  Share our_surface() const;
  void set_rates(const Exec& exec, Attack<T>& attack, double ahead);
  void set_up_minerals(const Scene& scene, double waiting);
  void set_up(Attack<T>& attack);
  /// What acid dissolves, at the factor that holds, where the links read it.
  void set_volumes(Attack<T>& attack);
  /// Acid that an attack has consumed, booked or not.
  double consumed(const Attack<T>& attack) const;
  void find_links(const Exec& exec);
  bool has_minerals() const { return geometry_.mineral.extent(0) > 0; }
  int minerals() const { return static_cast<int>(solids_.size()); }
  double scaled(const RateLaw& rate) const;
  /// A volume with that which has reacted and is not yet taken off the solid added to it (sign 1) or taken off, pixels.
  double with_dissolving(double volume, double sign) const;
  /// That of each mineral.
  std::vector<double> dissolving_of_minerals() const;
  /// Volume that the reactant which an attack has consumed pays for, m3/m.
  double paid_for(const Attack<T>& attack, double consumed) const;
  double volume_per_acid(const Attack<T>& attack, std::size_t mineral) const;
  /// Pixels that a pixel of unit concentration dissolves of a solid with this molar volume, m3/mol.
  double volume_per_acid(double molar_volume, const RateLaw& rate) const {
    return factor_ * molar_volume * units_.concentration / rate.stoichiometry;
  }
  /// Product that an attack has given to the fluid.
  double released(const Attack<T>& attack, double consumed) const;
  /// Reactant that each mineral has taken.
  std::vector<double> acid_of_minerals(const Attack<T>& attack) const;
  /// Sums by mineral of what solid nodes have, or the links of an attack.
  std::vector<double> of_minerals(const ScalarField<double>& values) const;
  std::vector<double> of_links(const Attack<T>& attack, const ScalarField<double>& values) const;
  void limits_of(const Attack<T>& attack, const RateLaw& rate, const std::string& name, LimitTable& table) const;
  void mineral_ledger(Ledger& ledger) const;

  /// A kind of solid: number 0 is rock that no mineral holds.
  struct Solid {
    std::string name;         ///< empty: there is none of it
    double molar_volume = 0;  ///< m3/mol
    double initial = 0;       ///< pixels
  };

  ReactionSection section_;
  LatticeUnits units_;
  Geometry& geometry_;
  const SoluteModule<T, Set>& solutes_;
  const HeatModule<T>* heat_;
  std::vector<Attack<T>> attacks_;
  std::vector<Solid> solids_;   ///< empty without minerals
  VectorField<double> normal_;  ///< (surface, axis); empty when the stair-step area is not corrected
  int own_surface_count_ = -1;  ///< blocks of the surface with normals that we ask for; -1: all
  IndexList own_surface_;       ///< (own) their numbers
  Halo temperatures_;           ///< of other ranks' nodes at our links
  ScalarField<double> lost_;    ///< (block) volume that dissolving pixels were overdrawn by without an heir, pixels
  PoreGrowth::Losses losses_;
  int wall_interval_;
  std::int64_t refreshed_ = -1;  ///< the step in which the links were refreshed last; -1: they are new
  double factor_;                ///< how many times faster the rock ages than the fluid (accuracy.dissolution_factor)
  double factor_of_walls_ = 0;   ///< with which set_volumes was called last
  bool varies_;                  ///< the factor does (accuracy.dissolution_tolerance)
  bool watches_;                 ///< somebody asks for changes (accuracy.tolerance)
  double watched_ = 0;           ///< volume that had dissolved at the last look, m3/m
  int solute_interval_;          ///< lattice steps per step of the solutes for which the rates are set
  ScalarField<double> loss_{"vug::reaction::loss", 0};  ///< (surface) for largest_loss
  bool dissolves_;
  double initial_volume_ = 0;  ///< pixels
};

/// Books what has reacted at the end of every update interval, before mechanics and pore growth ask for it.
template <class T, class Set>
class TurnoverModule final : public Module {
 public:
  TurnoverModule(ReactionModule<T, Set>& reaction, int update_interval)
      : reaction_(reaction), update_interval_(update_interval) {}

  std::string_view name() const override { return "turnover"; }
  void step(const Exec& exec, const Clock& clock) override {
    if (clock.every(update_interval_)) reaction_.book(exec);
  }
  void tasks(std::vector<Task>& schedule) const override;
  void take(const Exec&, const Intervals& intervals) override { update_interval_ = intervals.update; }
  void resume(const Exec& exec, const Intervals& intervals) override { take(exec, intervals); }

 private:
  ReactionModule<T, Set>& reaction_;
  int update_interval_;
};

}  // namespace vug
