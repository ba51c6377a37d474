// The limits of the solutes' scheme: those that vug check prints, and the guard of a run.
#include "base/require.hpp"
#include "coupling/plane_waves.hpp"
#include "coupling/solute_module.hpp"
#include "kernels/flow/guards.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

namespace vug {

namespace {

// A concentration that exceeds the largest possible one by this factor is no solution of the equations any more.
constexpr double runaway_factor = 100;
// Over what a flux maintains across the lattice; what it puts into a closed space grows with time instead.
constexpr double growth_with_flux = 1000;
// Share of the largest concentration below which negative ones are undershoots of the scheme.
constexpr double undershoot = 1e-3;

/// Moles of product per mole of reactant, over all minerals, and whether the product turns back.
struct Yields {
  double least, most;
  bool reversible;
};

Yields yields_of(const ReactiveWall& wall) {
  if (!wall.minerals.given()) return {wall.product_yield, wall.product_yield, wall.inverse_equilibrium > 0};
  Yields yields{std::numeric_limits<double>::infinity(), 0, false};
  const auto rate = on_host(wall.minerals.rate);
  for (std::size_t m = 0; m < rate.extent(0); ++m) {
    if (rate(m).k0 == 0) continue;
    yields.least = std::min(yields.least, rate(m).product_yield);
    yields.most = std::max(yields.most, rate(m).product_yield);
    yields.reversible = yields.reversible || rate(m).inverse_equilibrium > 0;
  }
  return yields;
}

/// Widens the reach of a species by that of another, of which a mole becomes `yield` moles of it. What diffuses away
/// more slowly than the other comes is denser by the ratio of diffusivities.
void widen(Reach& reach, double diffusivity, const Reach& from, double of_other, double yield) {
  const double most = yield * std::max(1.0, of_other / diffusivity);
  reach.steady = std::max(reach.steady, most * from.steady);
  reach.now = std::max(reach.now, most * from.now);
}

/// The flux of a species at a boundary; null where none is given.
const TimeTable* flux_of(const StretchLinks& boundary, const std::string& species) {
  const auto& fluxes = boundary.stretch.conditions.solute.flux;
  const auto found = fluxes.find(species);
  return found == fluxes.end() ? nullptr : &found->second;
}

}  // namespace

template <class T, class Set>
std::vector<Reach> SoluteModule<T, Set>::reaches(double time) const {
  std::vector<Reach> reaches;
  const double length = std::max(geometry_.lattice.nx, geometry_.lattice.ny) * units_.spacing;
  for (const SpeciesState<T>& s : species_) {
    double given = s.section.initial, flux = 0;
    for (const StretchLinks& boundary : s.boundaries) {
      for (const auto& [species, value] : boundary.stretch.conditions.solute.concentration)
        given = std::max(given, value.highest());
      if (const TimeTable* own = flux_of(boundary, s.section.name)) flux = std::max(flux, std::abs(own->peak()));
    }
    const double steady = std::max(given, growth_with_flux * flux * length / s.section.diffusivity);
    // at most through four sides of a single cell
    reaches.push_back(
        {steady / units_.concentration, (steady + 4 * flux * time / units_.spacing) / units_.concentration});
  }
  for (std::size_t round = 0; round < reacting_.size(); ++round)  // the product of one may be the reactant of another
    for (const ReactingSpecies<T>& pair : reacting_) {
      if (!pair.product) continue;
      Reach& reactant = reaches[pair.reactant - species_.data()];
      Reach& product = reaches[pair.product - species_.data()];
      const double D_reactant = pair.reactant->section.diffusivity, D_product = pair.product->section.diffusivity;
      const Yields yields = yields_of(*pair.wall);
      widen(product, D_product, reactant, D_reactant, yields.most);
      if (yields.reversible) widen(reactant, D_reactant, product, D_product, 1 / yields.least);
    }
  return reaches;
}

template <class T, class Set>
FieldRange SoluteModule<T, Set>::range_of(const Exec& exec, const SpeciesState<T>& s) const {
  const Ranks& ranks = geometry_.split.ranks();
  const FieldRange range = field_range(exec, s.fields.C, geometry_.fluid.share());
  return {ranks.least(range.min), ranks.most(range.max), ranks.most(range.first_outside)};
}

template <class T, class Set>
void SoluteModule<T, Set>::guard(const Exec& exec, const Clock& clock) {
  const std::vector<Reach> reaches = this->reaches(static_cast<double>(clock.step) * units_.time_step);
  for (std::size_t n = 0; n < species_.size(); ++n) {
    const SpeciesState<T>& s = species_[n];
    const double bound = runaway_factor * std::max(1.0, reaches[n].now);
    const FieldRange range = range_of(exec, s);
    if (range.first_outside < 0 && range.min > -bound && range.max < bound) continue;
    if (!geometry_.split.alone()) geometry_.split.make_whole(geometry_.split.of_fluid(geometry_.fluid), s.fields.C);
    int node = 0;
    const int bad = field_range(exec, s.fields.C, geometry_.fluid.count, -bound, bound).first_outside;
    Kokkos::deep_copy(node, Kokkos::subview(geometry_.fluid.node, bad));
    throw StabilityError(fmt::format(
        "solute {} diverged at step {}: node ({}, {}) is not finite or beyond {:g} mol/m3; concentrations from {:.3g} "
        "to {:.3g} mol/m3{}; lower {}{}{}",
        s.section.name, clock.step, geometry_.lattice.x(node), geometry_.lattice.y(node), bound * units_.concentration,
        range.min * units_.concentration, range.max * units_.concentration,
        range.first_outside < 0 ? "" : ", and some that are not finite",
        carrier_ ? "the velocity" : "lattice.time_step", interval_ > 1 ? " or accuracy.solute_interval" : "",
        carrier_ ? " or raise the diffusivity" : ""));
  }
}

template <class T, class Set>
std::vector<Concern> SoluteModule<T, Set>::concerns(const Exec& exec) const {
  std::vector<Concern> concerns;
  const std::vector<Reach> reaches = this->reaches(0);
  for (std::size_t n = 0; n < species_.size(); ++n) {
    const SpeciesState<T>& s = species_[n];
    GivenFluxes given;
    for (const StretchLinks& boundary : s.boundaries)
      if (const TimeTable* flux = flux_of(boundary, s.section.name)) given.add(boundary.stretch.key, *flux);
    if (given.draws.empty() && given.puts_in.empty()) continue;
    const FieldRange range = range_of(exec, s);
    const double scale = std::max({s.section.initial / units_.concentration, range.max, 0.0});
    if (!given.draws.empty() && range.min < -undershoot * scale)
      concerns.push_back({"negative concentrations of " + s.section.name,
                          fmt::format(" (down to {:.3g} mol/m3): {}.solute.flux.{} draws more than there is",
                                      range.min * units_.concentration, given.draws, s.section.name)});
    const double most = runaway_factor * std::max(1.0, reaches[n].steady);
    if (!given.puts_in.empty() && range.max > most)
      concerns.push_back(
          {fmt::format("concentrations of {} above {:g} mol/m3", s.section.name, most * units_.concentration),
           fmt::format(": {}.solute.flux.{} puts in more than leaves", given.puts_in, s.section.name)});
  }
  return concerns;
}

template <class T, class Set>
void SoluteModule<T, Set>::limits(LimitTable& table) const {
  // higher speeds were not tried (docs/stability.md)
  if (carrier_)
    table.push_back({"solute", "cells per step at the largest speed", interval_ * fastest_, "1", 0,
                     longest_way_of_solutes, "lower accuracy.solute_interval, lattice.time_step or flow.speed_limit"});
  for (const SpeciesState<T>& s : species_) {
    table.push_back({"solute", s.section.name + " diffusivity", s.parameters.diffusivity(), "lattice", 1e-3,
                     largest_diffusivity_of_solutes, "change lattice.time_step (docs/stability.md)"});
    table.push_back({"solute", s.section.name + " relaxation time tau_1", s.parameters.tau_1, "1", 0.5003, 3.5,
                     "change lattice.time_step"});
    // With Lambda = 1/4 on D2Q5 the scheme is stable for any speed and diffusivity; all others that were measured are
    // stable at least up to this number (docs/stability.md).
    if (carrier_ && (Set::Q != D2Q5::Q || section_.relaxation_time)) {
      const char* advice = "use solute.velocity_set = \"d2q5\" without solute.relaxation_time, or lower the pressures";
      table.push_back({"solute", s.section.name + " grid Peclet number at the largest speed",
                       fastest_ * units_.diffusivity() / s.section.diffusivity, "1", 0, 10, advice});
      table.push_back({"solute", s.section.name + " growth per step of a plane wave at the largest speed",
                       solute_wave_growth<Set>(s.parameters, interval_ * fastest_), "1", 0, neutral_growth, advice});
    }
    table.push_back({"solute", s.section.name + " relaxation time tau_h", s.parameters.tau_h, "1", 0.5,
                     std::numeric_limits<double>::infinity(), "raise solute.relaxation_time above 1/2"});
  }
}

#define VUG_INSTANTIATE(T, Set)                                                                  \
  template std::vector<Reach> SoluteModule<T, Set>::reaches(double) const;                       \
  template FieldRange SoluteModule<T, Set>::range_of(const Exec&, const SpeciesState<T>&) const; \
  template void SoluteModule<T, Set>::guard(const Exec&, const Clock&);                          \
  template std::vector<Concern> SoluteModule<T, Set>::concerns(const Exec&) const;               \
  template void SoluteModule<T, Set>::limits(LimitTable&) const;
VUG_FOR_NUMBERS_AND_SETS(VUG_INSTANTIATE)
#undef VUG_INSTANTIATE

}  // namespace vug
