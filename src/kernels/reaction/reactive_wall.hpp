#pragma once
// The reaction L1 + S1 -> y L2 at every link between solid and fluid, and the solid that it dissolves (paper Eqs. 7, 9,
// 21-24). It dresses the outgoing populations of acid and product after the sweep, before they return with the next.
//
// Rock dissolves over thousands of steps and warms as slowly. The list of links, their conductances and the solid that
// they have dissolved are therefore updated only now and then (find_reactive_links, set_conductances, book_turnover),
// so that a step is one loop over a list of links.
#include "base/choices.hpp"
#include "kernels/reaction/link_area.hpp"
#include "kernels/reaction/reaction.hpp"
#include "kernels/solute/solute.hpp"

#include <string>
#include <vector>

namespace vug {

/// Losses of surface nodes, pixels. `largest` may be empty: then nothing is kept.
struct SurfaceLosses {
  ScalarField<double> recent;   ///< (surface) in this booking, by the reactants booked so far
  ScalarField<double> largest;  ///< (surface) the largest of all bookings

  /// `first`: no other reactant has been booked before in this booking.
  KOKKOS_FORCEINLINE_FUNCTION void note(int s, double loss, bool first) const {
    if (largest.extent(0) == 0) return;
    const double all = first ? loss : recent(s) + loss;
    recent(s) = all;
    if (all > largest(s)) largest(s) = all;
  }
};

/// Constants of one reactant on one mineral, in lattice units.
struct MineralRate {
  double k0 = 0;                      ///< rate constant at the reference temperature
  double activation_temperature = 0;  ///< Ea/R in K
  double inverse_equilibrium = 0;     ///< 1/K_eq
  double order = 1;
  double molar_volume = 0;   ///< pixels dissolved per pixel of unit concentration of the reactant
  double product_yield = 1;  ///< y, moles of product that a mole of the reactant becomes
};

/// The constants of all minerals. Empty where rock is of one kind that reacts in first order: its constants are then
/// those of the wall itself.
struct MineralRates {
  Kokkos::View<const std::uint8_t*> of_node;  ///< (dense node) number of its mineral; empty: 0 everywhere
  Kokkos::View<const MineralRate*> rate;      ///< (mineral)

  bool given() const { return rate.extent(0) > 0; }
  KOKKOS_FORCEINLINE_FUNCTION const MineralRate& at(int node) const {
    return rate(of_node.extent(0) > 0 ? of_node(node) : 0);
  }
};

/// Constants of a reactive wall, in lattice units.
struct ReactiveWall {
  ReactiveWallLaw law = ReactiveWallLaw::kinetic;
  double molar_volume = 0;         ///< pixels dissolved per pixel of unit concentration; 0 = reacts, does not dissolve
  double inverse_equilibrium = 0;  ///< 1/K_eq
  double product_yield = 1;        ///< y
  double D_reactant = 1, D_product = 1;  ///< used by the paper's law
  MineralRates minerals;                 ///< where given, instead of the first three constants above
  double reference_concentration = 1;    ///< C_ref of orders other than 1
};

/// The links through which a wall reacts, in the order of their fluid nodes and directions out of them, and what each
/// has turned over since the last booking.
template <class T>
struct ReactiveLinks {
  int count = 0;
  IndexList first;            ///< (fluid + 1) fluid node i has the links [first(i), first(i + 1))
  IndexList of_surface;       ///< (surface + 1) surface node s has entries [of_surface(s), of_surface(s + 1)) of
  IndexList of_surface_link;  ///< (entry) the link, in order of direction from s
  IndexList slot;             ///< (link) slot of the population that leaves the fluid through it
  IndexList root;             ///< (link) 8 s + q - 1: it leads from surface node s = surface_of(link) along
                              ///< q = direction_of(link) into the fluid
  Kokkos::View<std::uint8_t*> mineral;  ///< (link) of the surface node; empty without minerals
  ScalarField<T> rate;                  ///< (link) rate constant times share of true area, of the last update
  ScalarField<T> conductance;  ///< (link) flux per driving population or concentration, see set_conductances; for an
                               ///< order other than 1 the rate constant
  ScalarField<double> acid;    ///< (link) moles taken from the acid
  ScalarField<double> product, solid;  ///< (link) given to the product, taken off the solid; `acid` itself (1/y of the
                                       ///< product) except for the paper's law, where the three differ
  int own_count = -1;                  ///< number of blocks with links of nodes of this process; -1: all
  IndexList own_blocks;                ///< (own) their numbers

  KOKKOS_FORCEINLINE_FUNCTION int surface_of(int l) const { return root(l) / 8; }
  KOKKOS_FORCEINLINE_FUNCTION int direction_of(int l) const { return root(l) % 8 + 1; }
  /// The links that this process computes.
  Share share() const { return {count, own_count, own_blocks.data()}; }
};

/// Lists the links of `surface` to the fluid along the velocities of Set. The turnover of the former links must have
/// been booked. Reuses the allocations when they fit; waits for the device. `mineral` as in MineralRates::of_node.
template <class Set, class T>
void find_reactive_links(const Exec& exec, const FluidNodes& nodes, const Surface& surface, ReactiveWallLaw law,
                         ReactiveLinks<T>& links, const Kokkos::View<const std::uint8_t*>& mineral = {});

// Rate policies: kelvin(dense solid node, dense fluid node) looks up the temperature of their common face, and
// at(dense solid node, kelvin) computes the rate constant there, in lattice units.

/// Rate constant after Arrhenius (Eq. 8) at the temperature `temperature(solid, fluid)`, in K, of the face.
template <class FaceTemperature>
struct ArrheniusRate {
  double k0 = 0;                      ///< rate constant at the reference temperature, lattice units
  double activation_temperature = 0;  ///< Ea/R in K
  double reference_temperature = 0;   ///< K
  FaceTemperature temperature;
  KOKKOS_FORCEINLINE_FUNCTION void announce(int solid, int fluid) const { temperature.announce(solid, fluid); }
  KOKKOS_FORCEINLINE_FUNCTION double kelvin(int solid, int fluid) const { return temperature(solid, fluid); }
  KOKKOS_FORCEINLINE_FUNCTION double at(int, double kelvin) const {
    return arrhenius<double>(k0, activation_temperature, kelvin, reference_temperature);
  }
};

/// The same with the constants of the solid node's mineral.
template <class FaceTemperature>
struct MineralArrhenius {
  MineralRates minerals;
  double reference_temperature = 0;  ///< K
  FaceTemperature temperature;
  KOKKOS_FORCEINLINE_FUNCTION void announce(int solid, int fluid) const { temperature.announce(solid, fluid); }
  KOKKOS_FORCEINLINE_FUNCTION double kelvin(int solid, int fluid) const { return temperature(solid, fluid); }
  KOKKOS_FORCEINLINE_FUNCTION double at(int solid, double kelvin) const {
    const MineralRate& mineral = minerals.at(solid);
    return arrhenius<double>(mineral.k0, mineral.activation_temperature, kelvin, reference_temperature);
  }
};

/// The same temperature everywhere, K.
struct UniformTemperature {
  double kelvin = 0;
  KOKKOS_FORCEINLINE_FUNCTION void announce(int, int) const {}
  KOKKOS_FORCEINLINE_FUNCTION double operator()(int, int) const { return kelvin; }
};

/// Sets links.conductance from the rate at every face and the area that the link stands for: `normal` from find_normals
/// corrects the area of the stair-step; with extent 0 it is not corrected. To be called when the links are new and
/// again every few steps. `ahead` times the change of the rate since the last call is added: with ahead = 1/2, and as
/// many steps until the next call, the mean over them is right to second order. The result stays between half and
/// double the rate. ahead is 0 where the links are new. Include reactive_wall_kernel.hpp.
template <class Set, class T, class Rate>
void set_conductances(const Exec& exec, const FluidNodes& nodes, const Surface& surface, const ReactiveWall& wall,
                      const Rate& rate, const VectorField<double>& normal, const ReactiveLinks<T>& links,
                      double ahead = 0);

/// One step of reaction at all links. `product` may be null (L2 is not modelled; 1/K_eq must then be 0, else
/// InputError). Acid + product / y are conserved by the kinetic law. Memory traffic per link: 2 populations (4 with
/// product), its slot, conductance and turnover.
template <class Set, class T>
void react_at_wall(const Exec& exec, const FluidNodes& nodes, const ReactiveWall& wall, const ReactiveLinks<T>& links,
                   const SoluteFields<T>& reactant, const SoluteFields<T>* product);

/// What the reaction took from the solid and from the fluid.
struct ReactionLedger {
  ScalarField<double> V;          ///< (dense node) solid volume, 1 -> 0 pixels; M times the moles is subtracted from it
  ScalarField<double> dissolved;  ///< (dense node) volume dissolved so far; the same is added to it
  ScalarField<double>
      consumed;  ///< (block of surface nodes) acid taken from the fluid; block_count(lattice.size()) suffices
  /// (dense node) product given to the fluid; needed only with the paper's law, where it differs from the acid consumed
  ScalarField<double> released;
  ScalarField<double> acid;  ///< (dense node) acid that reacted with it; needed only with minerals
};

/// Moves what the links have turned over to the ledger, and notes it in `losses`; `first`: no other reactant has been
/// booked before in this booking. Call it before the solid volume is read and before the links are listed anew.
template <class T>
void book_turnover(const Exec& exec, const Surface& surface, const ReactiveWall& wall, const ReactiveLinks<T>& links,
                   const ReactionLedger& ledger, const SurfaceLosses& losses = {}, bool first = true);

/// loss(s) += what the links have taken off surface node s since the last booking, pixels.
template <class T>
void add_losses(const Exec& exec, const Surface& surface, const ReactiveWall& wall, const ReactiveLinks<T>& links,
                const ScalarField<double>& loss);

/// sums[m] = sum of value(i) over the i < n whose mineral(i) is m, for m < minerals. The same bits for any number of
/// threads. Waits for the device: for rows of a history, not inside a step.
std::vector<double> sums_by_mineral(const Exec& exec, const std::string& label, int n,
                                    const Kokkos::View<const double*>& value,
                                    const Kokkos::View<const std::uint8_t*>& mineral, int minerals);

/// A lattice step of reactant and product (which may be null), then react_at_wall. Both must have taken the same number
/// of steps. On a host this runs block by block, so that the reaction finds the populations in the cache, where the
/// sweep has left them: alone it would fetch nearly every line of them and use one number in five. The results are the
/// same to the bit as those of the three calls in turn.
template <class Set, class T>
void advance_reacting_solutes(const Exec& exec, const FluidNodes& nodes, const SoluteCarrier<T>& carrier,
                              const ReactiveWall& wall, const ReactiveLinks<T>& links,
                              const SteppingSolute<T>& reactant, const SteppingSolute<T>* product);

}  // namespace vug
