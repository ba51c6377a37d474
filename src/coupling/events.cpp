#include "coupling/events.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace vug {

namespace {

constexpr double breakthrough = 0.01;  // share of what was injected
const std::string breakthrough_of = "breakthrough of ";
constexpr double grown = 1e-9;  // share of the solid; smaller values are rounding
const std::string has_grown = "warning: rock has grown";
constexpr double relied_on = 1e-3;  // share of the nodes' steps at which the speed was limited
const std::string has_limited = "warning: the speed limiter";

struct Count {
  std::string what;  ///< of several
  std::string one;   ///< of a single one
  std::int64_t value;
};

std::vector<Count> counts_of(const Simulation& simulation) {
  std::vector<Count> counts;
  const Parts& parts = simulation.parts();
  if (parts.mechanics)
    counts.push_back({"bonds have failed", "bond has failed", parts.mechanics->bond_counts().failed()});
  if (parts.fragments_let_go)
    counts.push_back({"triangles have been let go", "triangle has been let go", parts.fragments_let_go()});
  if (parts.growth) {
    counts.push_back({"nodes have dissolved", "node has dissolved", parts.growth->dissolved_nodes()});
    counts.push_back(
        {"nodes have been opened by damage", "node has been opened by damage", parts.growth->opened_nodes()});
  }
  return counts;
}

/// One line about bonds that the preload broke or damaged; empty if there are none.
std::string damage_of(const PreloadReport& report) {
  const int failed = report.bonds.failed(), damaged = report.bonds.damaged;
  if (failed == 0 && damaged == 0) return {};
  return fmt::format("{} bond{} failed and {} {} damaged in the preload, before the run", failed,
                     failed == 1 ? "" : "s", damaged, damaged == 1 ? "was" : "were");
}

/// A number about accuracy.dissolution_tolerance that may be reported.
struct Pace {
  const char* key;
  std::int64_t value, first;  ///< reported from `first` on
  std::string what;
};
/// Why the rock does not age faster, according to the last look.
std::string why_it_waits(const Ageing& ageing) {
  if (std::isinf(ageing.residual())) return "nothing dissolves";
  if (ageing.residual() <= ageing.tolerance())
    return "the acid is steady; the flow is not (accuracy.flow_tolerance), walls recede too fast, the rock is still "
           "young, or a table over time has a point ahead";
  return fmt::format("the acid is off its steady state by {:.2g}, accuracy.dissolution_tolerance = {:g}",
                     ageing.residual(), ageing.tolerance());
}

std::vector<Pace> paces_of(const Ageing& ageing) {
  return {{"largest factor", static_cast<std::int64_t>(ageing.largest()), 10,
           fmt::format("the rock ages {:.3g} times faster than the fluid", ageing.largest())},
          {"waits", ageing.waits(), 1,
           fmt::format("the rock has waited {} times for the acid to follow (factor 1)", ageing.waits())},
          {"waiting", ageing.waiting_steps(), 100000,
           fmt::format("warning: for {} lattice steps the rock aged no faster than the fluid; now {}",
                       ageing.waiting_steps(), why_it_waits(ageing))}};
}

std::string at(const Clock& clock) {
  return fmt::format("step {}, {:.4g} s: ", clock.step, clock.time());
}

/// Amounts of a species that have entered and left through sides and openings, that reactions have made, and that are
/// there now and have come in whatever way.
struct Passed {
  double in = 0, out = 0, made = 0, stored = 0, gained = 0;
  double at_start() const { return stored - gained; }
};

/// Amounts of each species, from the columns "L1_gain_injected_mol_per_m", "..._outflow_...", "..._shape_<name>_..."
/// and "..._reaction_..." of a row.
std::map<std::string, Passed> passed_by(const std::vector<HistoryValue>& row) {
  std::map<std::string, Passed> passed;
  for (const HistoryValue& value : row) {
    if (!value.name.ends_with("_mol_per_m")) continue;
    if (const std::size_t at = value.name.find("_stored_"); at != std::string::npos)
      passed[value.name.substr(0, at)].stored = value.value;
    if (const std::size_t at = value.name.find("_gain_"); at != std::string::npos)
      passed[value.name.substr(0, at)].gained += value.value;
    for (const char* gain : {"_gain_injected_", "_gain_outflow_", "_gain_shape_"}) {
      const std::size_t at = value.name.find(gain);
      if (at == std::string::npos) continue;
      Passed& of = passed[value.name.substr(0, at)];
      (value.value > 0 ? of.in : of.out) += std::abs(value.value);
    }
    if (const std::size_t at = value.name.find("_gain_reaction"); at != std::string::npos)
      passed[value.name.substr(0, at)].made += std::max(value.value, 0.0);
  }
  return passed;
}

double value_in(const std::vector<HistoryValue>& row, const char* name) {
  const auto found = std::find_if(row.begin(), row.end(), [&](const HistoryValue& v) { return v.name == name; });
  return found == row.end() ? 0 : found->value;
}

/// Volume that the rock has gained on the whole, over its present volume.
double growth_of(const std::vector<HistoryValue>& row) {
  double won = 0, there = 0;
  for (const HistoryValue& value : row) {
    if (value.name == "solid_volume_gain_dissolved_m3_per_m") won = value.value;
    if (value.name == "solid_volume_stored_m3_per_m") there = value.value;
  }
  return there > 0 ? won / there : 0;
}

/// Whether a line of look_at_concerns is about `what` itself, not about something whose name only begins like it: of H2
/// instead of H.
bool tells_of(const std::string& line, const std::string& what) {
  const std::string mark = "warning: " + what;
  const auto found = line.find(mark);
  if (found == std::string::npos) return false;
  const auto end = found + mark.size();
  return end == line.size() || line[end] == ' ' || line[end] == ':';
}

}  // namespace

Events::Events(const Simulation& simulation, const std::vector<std::string>& earlier, bool reversible)
    : earlier_(earlier), reversible_(reversible) {
  look(simulation);
  begun_ = true;
  for (const std::string& line : earlier) {  // the state of the run does not contain whether these were reported
    if (const auto at = line.find(breakthrough_of); at != std::string::npos)
      next_.try_emplace(line.substr(at, line.find(':', at) - at), 0);
    for (const std::string& once : {has_grown, has_limited})
      if (line.find(once) != std::string::npos) next_.try_emplace(once, 0);
  }
}

bool Events::runs_backwards(const Scene& scene) {
  const auto reversible = [](const RateLaw& rate) { return rate.inverse_equilibrium_constant > 0; };
  if (!scene.reaction) return false;
  const std::vector<FurtherReactant>& further = scene.reaction->further;
  return reversible(*scene.reaction) || std::any_of(further.begin(), further.end(), reversible) ||
         std::any_of(scene.minerals.begin(), scene.minerals.end(), [&](const MineralSection& mineral) {
           return std::any_of(mineral.rates.begin(), mineral.rates.end(), reversible);
         });
}

std::vector<std::string> Events::look_at_concerns(const Simulation& simulation) {
  std::vector<std::string> news;
  for (const auto& module : simulation.parts().modules)
    for (const Concern& concern : module->concerns(Exec{})) {
      const auto tells = [&](const std::string& line) { return tells_of(line, concern.what); };
      if (std::any_of(earlier_.begin(), earlier_.end(), tells) || !next_.try_emplace(concern.what, 0).second) continue;
      news.push_back(at(simulation.clock()) + "warning: " + concern.what + concern.detail);
    }
  return news;
}

std::vector<std::string> Events::look(const Simulation& simulation) {
  std::vector<std::string> news;
  if (begun_) news = look_at_concerns(simulation);
  if (const IntervalChooser* chooser = simulation.chooser()) {
    const auto& lines = chooser->news();
    for (auto l = static_cast<std::size_t>(next_["intervals"]); l < lines.size(); ++l) news.push_back(lines[l]);
    next_["intervals"] = static_cast<std::int64_t>(lines.size());
  }
  for (const Count& count : counts_of(simulation)) {
    std::int64_t& next = next_.try_emplace(count.what, 1).first->second;
    if (count.value < next) continue;
    if (begun_)
      news.push_back(
          fmt::format("{}{} {}", at(simulation.clock()), count.value, count.value == 1 ? count.one : count.what));
    while (next <= count.value) next *= 10;
  }
  if (!simulation.parts().ageing) return news;
  for (const Pace& pace : paces_of(*simulation.parts().ageing)) {
    std::int64_t& next = next_.try_emplace(pace.key, pace.first).first->second;
    if (pace.value < next) continue;
    if (begun_) news.push_back(at(simulation.clock()) + pace.what);
    while (next <= pace.value) next *= 10;
  }
  return news;
}

std::vector<std::string> Events::of_the_start(const Simulation& simulation) {
  const Mechanics* rock = simulation.parts().mechanics;
  std::vector<std::string> lines;
  if (!rock || !rock->ramped()) return lines;
  for (const std::string& line : {unrest_of(*rock->ramped()), damage_of(*rock->ramped())})
    if (!line.empty()) lines.push_back(at(simulation.clock()) + "warning: " + line);
  return lines;
}

std::vector<std::string> Events::sum_up(const Simulation& simulation) const {
  const Ageing* ageing = simulation.parts().ageing;
  const Clock& clock = simulation.clock();
  std::vector<std::string> lines;
  if (limited_ > 0)
    lines.push_back(
        fmt::format("{} limited {:.4g} times, at {:.3g} % of the nodes and steps: momentum was removed "
                    "there (flow.speed_limit)",
                    limited_share_ > relied_on ? has_limited : has_limited.substr(has_limited.find("the")), limited_,
                    100 * limited_share_));
  if (!ageing || clock.step == 0) return lines;
  lines.push_back(
      fmt::format("the rock has aged {:.4g} times faster than the fluid in the mean, the dissolved volume is {:.2g} "
                  "off for it at most",
                  clock.time() / (static_cast<double>(clock.step) * clock.time_step), ageing->error()));
  if (ageing->error() > ageing->tolerance())
    lines.push_back(
        fmt::format("warning: that is more than accuracy.dissolution_tolerance = {:g}: something other than "
                    "the rock has changed in the fluid while the rock aged",
                    ageing->tolerance()));
  return lines;
}

std::vector<std::string> Events::look_at_row(const Simulation& simulation, const std::vector<HistoryValue>& row) {
  std::vector<std::string> news;
  const double steps = static_cast<double>(simulation.clock().step) - value_in(row, "flow_held_steps_1");
  limited_ = value_in(row, "speed_limiter_uses_1");
  limited_share_ = limited_ > 0 ? limited_ / (value_in(row, "fluid_nodes_1") * steps) : 0;
  if (limited_share_ > relied_on && next_.try_emplace(has_limited, 0).second)
    news.push_back(
        fmt::format("{}{} acts at {:.3g} % of the nodes and steps: momentum is removed there, and the result "
                    "is not a solution (flow.speed_limit)",
                    at(simulation.clock()), has_limited, 100 * limited_share_));
  if (growth_of(row) > grown && next_.try_emplace(has_grown, 0).second)
    news.push_back(fmt::format(
        "{}{} on the whole, by {}: it grows in place and narrows no pore", at(simulation.clock()), has_grown,
        reversible_ ? "a reaction that runs backwards (product over equilibrium_constant exceeds the "
                      "reactant)"
                    : "negative concentrations of the reactant (a given flux that draws more than there "
                      "is, or undershoots)"));
  // of a product no more than a trace enters, beside the reactant, and what was there from the start leaves first: what
  // has left is no share of what was injected
  for (const auto& [species, passed] : passed_by(row))
    if (passed.in > passed.made && passed.at_start() < breakthrough * passed.in &&
        passed.out > breakthrough * passed.in && next_.try_emplace(breakthrough_of + species, 0).second)
      news.push_back(fmt::format("{}{}{}: {:.2g} % of what was injected has left", at(simulation.clock()),
                                 breakthrough_of, species, 100 * passed.out / passed.in));
  return news;
}

}  // namespace vug
