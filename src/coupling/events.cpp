#include "coupling/events.hpp"

#include <fmt/format.h>

#include <cmath>

namespace vug {

namespace {

constexpr double breakthrough = 0.01;  // of what was injected

struct Count {
  std::string what;
  std::int64_t value;
};

std::vector<Count> counts_of(const Simulation& simulation) {
  std::vector<Count> counts;
  const Parts& parts = simulation.parts();
  if (parts.mechanics)
    counts.push_back({"bonds have failed", static_cast<std::int64_t>(parts.mechanics->bond_counts().failed())});
  if (parts.growth) {
    counts.push_back({"nodes have dissolved", parts.growth->dissolved_nodes()});
    counts.push_back({"nodes have been opened by damage", parts.growth->opened_nodes()});
  }
  return counts;
}

std::string at(const Clock& clock) {
  return fmt::format("step {}, {:.4g} s: ", clock.step, clock.time());
}

/// The species of a column of the history, "L1" of "L1_gain_outflow_mol_per_m", or nothing.
std::string species_of(const std::string& column, const std::string& gain) {
  const std::string ending = "_gain_" + gain + "_mol_per_m";
  return column.ends_with(ending) ? column.substr(0, column.size() - ending.size()) : "";
}

}  // namespace

Events::Events(const Simulation& simulation) {
  look(simulation);
  begun_ = true;
}

std::vector<std::string> Events::look(const Simulation& simulation) {
  std::vector<std::string> news;
  for (const Count& count : counts_of(simulation)) {
    std::int64_t& next = next_.try_emplace(count.what, 1).first->second;
    if (count.value < next) continue;
    if (begun_) news.push_back(fmt::format("{}{} {}", at(simulation.clock()), count.value, count.what));
    while (next <= count.value) next *= 10;
  }
  return news;
}

std::vector<std::string> Events::look_at_row(const Simulation& simulation, const std::vector<HistoryValue>& row) {
  std::vector<std::string> news;
  for (const HistoryValue& value : row) {
    const std::string species = species_of(value.name, "outflow");
    if (species.empty()) continue;
    for (const HistoryValue& other : row) {
      if (species_of(other.name, "injected") != species || !(-value.value > breakthrough * other.value)) continue;
      if (other.value > 0 && next_.try_emplace("breakthrough of " + species, 0).second)
        news.push_back(fmt::format("{}breakthrough of {}: {:.2g} % of what was injected has left",
                                   at(simulation.clock()), species, -100 * value.value / other.value));
    }
  }
  return news;
}

}  // namespace vug
