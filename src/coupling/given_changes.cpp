#include "coupling/given_changes.hpp"

#include "io/each_boundary.hpp"

#include <algorithm>
#include <cmath>

namespace vug {

double steepest(const TimeTable& table, double from, double to) {
  const std::vector<double>& time = table.moments();
  double slope = 0;
  for (auto end = std::upper_bound(time.begin(), time.end(), from); end != time.end(); ++end) {
    if (end == time.begin()) continue;  // constant before its first point
    const double begin = *(end - 1);
    if (begin >= to) break;
    slope = std::max(slope, std::abs(table.at(*end) - table.at(begin)) / (*end - begin));
  }
  return slope;
}

GivenChanges::GivenChanges(const Scene& scene) {
  std::vector<double Changes::*> of_flow;
  if (scene.heat) of_flow.push_back(&Changes::heat);
  if (scene.solute) of_flow.push_back(&Changes::solute);
  if (scene.mechanics) of_flow.push_back(&Changes::force);
  const auto add = [&](const TimeTable& table, double rest, const std::vector<double Changes::*>& acts_on) {
    if (!table.constant()) tables_.push_back({table, rest, acts_on});
  };
  for_each_boundary(scene, [&](const BoundarySection& given) {
    given.flow.for_each_table([&](const TimeTable& table) {
      add(table, scene.flow && &table == &given.flow.pressure ? scene.flow->initial_pressure : 0, of_flow);
    });
    if (scene.heat) add(given.heat.temperature, scene.heat->initial_temperature, {&Changes::heat});
    add(given.heat.flux, 0, {&Changes::heat});
    for (const auto* tables : {&given.solute.concentration, &given.solute.flux})
      for (const auto& [species, table] : *tables) add(table, 0, {&Changes::solute});
  });
}

void GivenChanges::raise(Changes& changes, const Clock& clock, int steps) const {
  const double span = steps * clock.time_step;
  for (const Given& given : tables_) {
    const double steep = steepest(given.table, clock.time(), clock.time() + span);
    if (steep == 0) continue;
    const double share = steep * span / given.table.farthest(given.rest, clock.time() + span);
    for (double Changes::*changed : given.acts_on) changes.*changed = std::max(changes.*changed, share);
  }
}

}  // namespace vug
