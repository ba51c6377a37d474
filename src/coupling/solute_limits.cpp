// The limits of the solutes' scheme: those that vug check prints, and the guard of a run.
#include "coupling/plane_waves.hpp"
#include "coupling/solute_module.hpp"
#include "kernels/base/require.hpp"
#include "kernels/flow/guards.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

namespace vug {

namespace {

// A concentration that exceeds the largest given one by this factor is no solution of the equations any more.
constexpr double runaway_factor = 100;
// There is no bound for what a flux puts into a closed space; this factor is over what the flux maintains across the
// lattice.
constexpr double growth_with_flux = 1000;

}  // namespace

template <class T, class Set>
void SoluteModule<T, Set>::guard(const Exec& exec, const Clock& clock) {
  for (const SpeciesState<T>& s : species_) {
    double largest = s.section.initial / units_.concentration;
    for (const StretchLinks& boundary : s.boundaries)
      for (const auto& [species, value] : boundary.stretch.conditions.solute.concentration)
        largest = std::max(largest, value.highest() / units_.concentration);
    for (const StretchLinks& boundary : s.boundaries)
      for (const auto& [species, value] : boundary.stretch.conditions.solute.flux)
        largest = std::max(largest, growth_with_flux * std::abs(value.peak()) *
                                        std::max(geometry_.lattice.nx, geometry_.lattice.ny) * units_.spacing /
                                        (s.section.diffusivity * units_.concentration));
    const double bound = runaway_factor * std::max(1.0, largest);
    const Ranks& ranks = geometry_.split.ranks();
    FieldRange range = field_range(exec, s.fields.C, geometry_.fluid.share());
    range = {ranks.least(range.min), ranks.most(range.max), ranks.most(range.first_outside)};
    if (range.first_outside < 0 && range.min > -bound && range.max < bound) continue;
    if (!ranks.alone()) geometry_.split.make_whole(geometry_.split.of_fluid(geometry_.fluid), s.fields.C);
    int node = 0;
    const int bad = field_range(exec, s.fields.C, geometry_.fluid.count, -bound, bound).first_outside;
    Kokkos::deep_copy(node, Kokkos::subview(geometry_.fluid.node, bad));
    throw StabilityError(fmt::format(
        "solute {} diverged at step {}: node ({}, {}) is not finite or beyond {:g} mol/m3; concentrations from {:.3g} "
        "to {:.3g} mol/m3{}; lower the velocity{} or raise the diffusivity",
        s.section.name, clock.step, geometry_.lattice.x(node), geometry_.lattice.y(node), bound * units_.concentration,
        range.min * units_.concentration, range.max * units_.concentration,
        range.first_outside < 0 ? "" : ", and some that are not finite",
        interval_ > 1 ? " or accuracy.solute_interval" : ""));
  }
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

#define VUG_INSTANTIATE(T, Set)                                         \
  template void SoluteModule<T, Set>::guard(const Exec&, const Clock&); \
  template void SoluteModule<T, Set>::limits(LimitTable&) const;
VUG_FOR_NUMBERS_AND_SETS(VUG_INSTANTIATE)
#undef VUG_INSTANTIATE

}  // namespace vug
