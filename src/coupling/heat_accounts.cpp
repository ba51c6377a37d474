// What the heat module reports: limits, its balance, how far temperatures have changed.
#include "coupling/heat_module.hpp"
#include "kernels/launch/launch.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace vug {

template <class T>
void HeatModule<T>::limits(LimitTable& table) const {
  const auto tau = [&](double diffusivity) { return 0.5 + 3 * interval_ * diffusivity / units_.diffusivity(); };
  table.push_back({"heat", "relaxation time, fluid", tau(section_.fluid_diffusivity), "1", 0.5003,
                   largest_relaxation_time, "change lattice.time_step"});
  if (carrier_ && interval_ > 1)  // what is carried beyond the neighbouring nodes is lost
    table.push_back({"heat", "cells per step at the largest speed", interval_ * fastest_, "1", 0, longest_way,
                     "lower accuracy.heat_interval, lattice.time_step or flow.speed_limit"});
  // without walls of rock or openings no staircase can excite the mode
  if (carrier_ && (geometry_.surface.count > 0 || !geometry_.openings.empty()))
    table.push_back({"heat", "grid Peclet number at the largest speed",
                     fastest_ * units_.diffusivity() / section_.fluid_diffusivity, "1", 0, 4,
                     "lower the pressures or flow.speed_limit, or raise heat.fluid_diffusivity (docs/stability.md)"});
  table.push_back({"heat", "relaxation time, solid", tau(section_.solid_diffusivity), "1", 0.5003,
                   largest_relaxation_time, "change lattice.time_step"});
  for (std::size_t m = 1; m < minerals_.size(); ++m)
    table.push_back({"heat", "relaxation time, " + minerals_[m].name, tau(minerals_[m].diffusivity), "1", 0.5003,
                     largest_relaxation_time, "change lattice.time_step"});
}

template <class T>
void HeatModule<T>::ledger(Ledger& ledger) const {
  // theta nodes in fluid heat capacities -> J per m of thickness
  const double joule = section_.fluid_density * section_.fluid_heat_capacity * units_.volume();
  Balance& balance = ledger.of("heat", "J/m");
  balance.initial = joule * initial_energy_;
  balance.stored = joule * energy();
  gather_sums();
  double injected = 0, sides = 0;
  for (std::size_t s = 0; s < sides_.size(); ++s)
    (stretches_[s].name == name_of(stretches_[s].side) ? sides : injected) += entered_[s].total();
  balance.gains.push_back({"injection", joule * injected});
  balance.gains.push_back({"sides", joule * sides});
  for (std::size_t o = 0; o < openings_.size(); ++o)
    balance.gains.push_back({geometry_.openings[o].name, joule * entered_[sides_.size() + o].total()});
  balance.gains.push_back({"births", joule * sum_in_order(born_)});
  balance.gains.push_back({"advective_form", joule * created_.total()});
  // where as much leaves as enters, what is stored may be rounding alone
  constexpr double roundings = 16 * std::numeric_limits<T>::epsilon();
  const double largest = std::max(std::abs(units_.lattice_temperature(range_.coldest)),
                                  std::abs(units_.lattice_temperature(range_.hottest)));
  balance.negligible = roundings * joule * largest * geometry_.lattice.nx * geometry_.lattice.ny;
}

template <class T>
void HeatModule<T>::history(std::vector<HistoryValue>& row) const {
  const HeatExtremes extremes = this->extremes(Exec{});
  const double change =
      std::max(std::abs(extremes.lowest - initial_theta_), std::abs(extremes.highest - initial_theta_));
  row.push_back({"largest_temperature_change_K", change});
}

template <class T>
std::vector<Concern> HeatModule<T>::concerns(const Exec& exec) const {
  if (largest_flux_ == 0) return {};
  GivenFluxes given;
  const auto add = [&](const std::string& key, const HeatBoundary& heat) {
    if (heat.kind == HeatCondition::flux) given.add(key, heat.flux);
  };
  for (const Stretch& stretch : stretches_) add(stretch.key, stretch.conditions.heat);
  for (const InnerOpening& opening : geometry_.openings) add(opening.key, opening.conditions.heat);
  constexpr double absurd = 1e5;  // K
  const HeatExtremes seen = extremes(exec);
  const double lowest = seen.lowest + units_.reference_temperature;
  const double highest = seen.highest + units_.reference_temperature;
  std::vector<Concern> concerns;
  if (lowest < 0)
    concerns.push_back(
        {"temperatures below 0 K",
         fmt::format(" (down to {:.4g} K){}", lowest,
                     given.draws.empty() ? "" : ": " + given.draws + ".heat.flux draws more heat than there is")});
  if (highest > range_.hottest + absurd && !given.puts_in.empty())
    concerns.push_back(
        {fmt::format("temperatures more than {:g} K above those of the case", absurd),
         fmt::format(" (up to {:.4g} K): {}.heat.flux puts in more heat than leaves", highest, given.puts_in)});
  return concerns;
}

#define VUG_INSTANTIATE(T)                                                  \
  template void HeatModule<T>::limits(LimitTable&) const;                   \
  template std::vector<Concern> HeatModule<T>::concerns(const Exec&) const; \
  template void HeatModule<T>::ledger(Ledger&) const;                       \
  template void HeatModule<T>::history(std::vector<HistoryValue>&) const;
VUG_FOR_NUMBERS(VUG_INSTANTIATE)
#undef VUG_INSTANTIATE

}  // namespace vug
