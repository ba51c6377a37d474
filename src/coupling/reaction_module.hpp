#pragma once
// The reactions at the walls and the solid that they dissolve (paper Eqs. 6-9, 21-24).
#include "coupling/heat_module.hpp"
#include "coupling/module.hpp"
#include "coupling/pore_growth.hpp"
#include "coupling/solute_module.hpp"
#include "kernels/reaction/reactive_wall.hpp"
#include "kernels/reaction/surface_normal.hpp"

namespace vug {

/// Acid that has reacted, for a factor of ageing that changes (accuracy.dissolution_tolerance).
struct AgedAcid {
  double earlier = 0;  ///< sum of factor times acid that reacted, until the factor last changed
  double seen = 0;     ///< acid that had reacted until then
  /// With `now` the acid that has reacted in all: the amount that would have dissolved as much at this factor.
  double at(double now, double factor) const { return earlier / factor + (now - seen); }
  void change(double now, double factor) {
    earlier += factor * (now - seen);
    seen = now;
  }
};

/// One reactant at the walls.
template <class T>
struct Attack {
  std::string key;  ///< begins the names of its states and in the ledger; empty for the first reactant
  SpeciesState<T>* reactant = nullptr;
  SpeciesState<T>* product = nullptr;  ///< may be null
  RateLaw rate;                        ///< of rock that is no mineral
  std::vector<RateLaw> rates;          ///< (mineral) 0 is rock that is no mineral; empty without minerals
  ReactiveWall wall;
  Kokkos::View<MineralRate*> table;  ///< (mineral) for the wall, where its own constants are not enough
  ReactiveLinks<T> links;            ///< their turnover is booked every update interval, before the pores grow
  LongSum consumed;                  ///< (block) reactant that has reacted
  ReactionLedger sums;
  double watched = 0;          ///< reactant that had reacted at the last look
  std::vector<AgedAcid> aged;  ///< (mineral) one entry for all rock without minerals

  /// Beginning of the names of its states.
  std::string state_key() const { return key.empty() ? "reaction" : "reaction/" + key; }
};

/// Rates of reaction at all links of walls, and the volume that has dissolved. The solutes react at the links in their
/// step: this module comes before them in the list of modules, and TurnoverModule after them. `heat` may be null: then
/// the temperature of the case is used everywhere. `opener` may be null where there are no pathways.
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
  std::vector<Concern> concerns(const Exec& exec) const override;
  void limits(LimitTable& table) const override;
  void ledger(Ledger& ledger) const override;
  void history(std::vector<HistoryValue>& row) const override;
  void fields(FieldList& list) const override;
  void bound(std::optional<double> speed, Intervals& most) const override;
  void watch(const Exec& exec, const Clock& clock, Changes& changes) override;
  void take(const Exec& exec, const Intervals& intervals) override;
  void resume(const Exec& exec, const Intervals& intervals) override;
  void state(StateList& list) override;

  /// Names of the states of each reactant, as in a checkpoint: "reaction/link_acid".
  std::vector<std::string> names(std::initializer_list<const char*> parts) const;

  /// Subtracts what has reacted from the solid nodes.
  void book(const Exec& exec);

  /// Sets by how much faster the rock ages than the fluid from now on; what has reacted before is booked first.
  void set_factor(const Exec& exec, double factor);
  /// Volume that all acid consumed so far accounts for, m3/m.
  double paid() const;
  /// Largest share of a cell that a wall node has lost since its loss was last booked. Waits for the device.
  double largest_loss(const Exec& exec);
  /// A species whose concentration affects how much dissolves, with the largest volume that a lattice unit of its
  /// amount can dissolve at the factor 1, m3/m.
  struct Sway {
    const SpeciesState<T>* species;
    double volume;
  };
  std::vector<Sway> sways() const;

  /// Volume that dissolving pixels were overdrawn by and that no other node took; `all` is empty where nothing
  /// dissolves.
  const PoreGrowth::Losses& losses() const { return losses_; }

 private:
  /// Renews surface normals and the conductances of links where that is due. The solid shrinks and the temperature
  /// changes slowly, so that every wall interval is enough, except at the start of a run (sooner) and where links are
  /// new.
  void refresh(const Exec& exec, std::int64_t step);
  /// Gathers the turnover of the links on all ranks.
  void gather_links() const;
  void make_room_for_losses(const Exec& exec);
  /// Volume that has dissolved although no node had it, over all that has dissolved. Before a look has come, only what
  /// exceeds all rock is known. Called after gather_links().
  double overdrawn_share() const;
  /// Given fluxes that lead temperatures out of the range of Arrhenius' law, which the case does not name.
  std::vector<Concern> concerns_of_rates(const Exec& exec) const;
  Owners owners_of_links(const Attack<T>& attack) const;
  /// Determines which links this rank has, the surface nodes from which they lead, and the nodes whose temperature they
  /// need.
  void share_links();
  Share our_surface() const;
  void set_rates(const Exec& exec, Attack<T>& attack, double ahead);
  void set_up_minerals(const Scene& scene, double waiting);
  void set_up(Attack<T>& attack);
  /// Sets the volumes that acid dissolves, at the present factor, where the links read them.
  void set_volumes(Attack<T>& attack);
  /// Acid that an attack has consumed, booked or not.
  double consumed(const Attack<T>& attack) const;
  void find_links(const Exec& exec);
  bool has_minerals() const { return geometry_.mineral.extent(0) > 0; }
  int minerals() const { return static_cast<int>(solids_.size()); }
  double scaled(const RateLaw& rate) const;
  /// `volume` plus (sign 1) or minus (sign -1) the volume that has reacted but is not booked yet, pixels.
  double with_dissolving(double volume, double sign) const;
  /// That volume for each mineral.
  std::vector<double> dissolving_of_minerals() const;
  /// Volume that the amount `consumed` of the reactant of an attack accounts for, m3/m.
  double paid_for(const Attack<T>& attack, double consumed) const;
  double volume_per_acid(const Attack<T>& attack, std::size_t mineral) const;
  /// Pixels that are dissolved by one pixel of unit concentration, for a solid with this molar volume, m3/mol.
  double volume_per_acid(double molar_volume, const RateLaw& rate) const {
    return factor_ * molar_volume * units_.concentration / rate.stoichiometry;
  }
  /// Product that an attack has released into the fluid.
  double released(const Attack<T>& attack, double consumed) const;
  /// The nodes that some reactant can dissolve.
  ReactingNodes reacting_nodes() const;
  /// Amount of reactant that each mineral has consumed.
  std::vector<double> acid_of_minerals(const Attack<T>& attack) const;
  /// Sums for each mineral over the solid nodes, or over the links of an attack.
  std::vector<double> of_minerals(const ScalarField<double>& values) const;
  std::vector<double> of_links(const Attack<T>& attack, const ScalarField<double>& values) const;
  void limits_of(const Attack<T>& attack, const RateLaw& rate, const std::string& name, LimitTable& table) const;
  void mineral_ledger(Ledger& ledger) const;

  /// A kind of solid: number 0 is rock that is no mineral.
  struct Solid {
    std::string name;         ///< empty: this solid does not occur
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
  int own_surface_count_ = -1;  ///< number of blocks of the surface whose normals this rank needs; -1: all
  IndexList own_surface_;       ///< (own) their numbers
  Halo temperatures_;           ///< of other ranks' nodes at links of this rank
  ScalarField<double> lost_;    ///< (block) volume that dissolving pixels were overdrawn by and no node took, pixels
  PoreGrowth::Losses losses_;
  int wall_interval_;
  std::int64_t refreshed_ = -1;  ///< step in which the links were last refreshed; -1: they are new
  double factor_;                ///< how many times faster the rock ages than the fluid (accuracy.dissolution_factor)
  double factor_of_walls_ = 0;   ///< the factor with which set_volumes was last called
  bool varies_;                  ///< the factor varies (accuracy.dissolution_tolerance)
  bool watches_;                 ///< changes are watched (accuracy.tolerance)
  double watched_ = 0;           ///< volume that had dissolved at the last look, m3/m
  int solute_interval_;          ///< lattice steps per solute step, as used for the rates
  ScalarField<double> loss_{"vug::reaction::loss", 0};  ///< (surface) for largest_loss
  SurfaceLosses wall_losses_;  ///< from one look for dissolved nodes to the next; empty where nothing dissolves
  bool dissolves_;
  double initial_volume_ = 0;  ///< pixels
};

/// Books what has reacted at the end of every update interval, before mechanics and pore growth need it.
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
