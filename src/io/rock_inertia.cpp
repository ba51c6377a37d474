#include "io/rock_inertia.hpp"

#include "io/each_boundary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace vug {

namespace {

constexpr double never = std::numeric_limits<double>::infinity();

/// Shortest time of a change of a value that is `rest` before the run: 0 where it jumps at the start, otherwise that of
/// its ramp or table.
double quickest(const TimeTable& table, double rest, double ramp_time = 0) {
  if (ramp_time > 0) return std::min(ramp_time, table.quickest());
  return table.at(0) == rest ? table.quickest() : 0;
}

double quickest(const FlowBoundary& flow, double initial_pressure) {
  double shortest = quickest(flow.speed, 0, flow.ramp_time);
  if (flow.kind == FlowBoundaryKind::pressure) shortest = quickest(flow.pressure, initial_pressure, flow.ramp_time);
  for (const TimeTable& component : flow.velocity)
    shortest = std::min(shortest, quickest(component, 0, flow.ramp_time));
  if (const TimeTable* rate = flow.given_rate()) shortest = std::min(shortest, quickest(*rate, 0, flow.ramp_time));
  return shortest;
}

/// Stresses at the start count as no jump: the preload applies them before the run.
double quickest(const TractionLoad& load) {
  double shortest = std::min(load.normal_stress.quickest(), load.shear_stress.quickest());
  for (const TimeTable& component : load.velocity) shortest = std::min(shortest, quickest(component, 0));
  return shortest;
}

double quickest(const BoundarySection& side, const Scene& scene) {
  double shortest = quickest(side.traction.load);
  for (const TractionPart& part : side.traction.parts) shortest = std::min(shortest, quickest(part.load));
  return scene.flow ? std::min(shortest, quickest(side.flow, scene.flow->initial_pressure)) : shortest;
}

bool expands(const MechanicsParameters& rock) {
  return rock.thermal_expansion > 0 || std::any_of(rock.materials.begin(), rock.materials.end(),
                                                   [](const auto& m) { return m.thermal_expansion > 0; });
}

/// Time in which heat diffuses through a triangle of generated rock; 0 for a mesh, whose triangle size is not known
/// here.
double heat_through_triangle(const Scene& scene) {
  double diffusivity = scene.heat->solid_diffusivity;
  for (const MineralSection& mineral : scene.minerals) diffusivity = std::max(diffusivity, mineral.diffusivity);
  const double size = scene.rock && !scene.rock->mesh ? scene.rock->element_size / scene.rock->grading : 0;
  return size * size / diffusivity;
}

/// How many times longer than a wave of compression a bending one takes along the rock; 1 for rock that is not slender.
double slenderness(const Scene& scene) {
  const auto [shorter, longer] = std::minmax(scene.lattice.length_x, scene.lattice.length_y);
  return longer > 2 * shorter ? longer / shorter : 1;
}

/// Whether gravity may move rock that nothing holds: all of it, or pieces that notches or cracks of a mesh cut off.
bool falls(const Scene& scene) {
  const auto& gravity = scene.mechanics->gravity;
  const bool may_be_in_pieces = scene.rock && (!scene.rock->notches.empty() || scene.rock->mesh);
  return std::hypot(gravity[0], gravity[1]) > 0 && (may_be_in_pieces || !is_supported(scene));
}

/// Whether its stress or its platen pushes the rock now more, now less.
bool changes(const TractionLoad& load) {
  return quickest(load) < never;
}

double heaviest_material(const MechanicsParameters& rock) {
  double density = rock.density;
  for (const RockMaterial& material : rock.materials) density = std::max(density, material.density);
  return density;
}

/// Visits the load of every side and of every part of one, with the length of the rock behind it (m) and the share of
/// the side that it takes.
template <class Visit>
void for_each_load(const Scene& scene, const Visit& visit) {
  for (const Side side : all_sides) {
    const TractionBoundary& traction = scene.side(side).traction;
    const double behind = is_upright(side) ? scene.lattice.length_x : scene.lattice.length_y;
    const double along = is_upright(side) ? scene.lattice.length_y : scene.lattice.length_x;
    visit(traction.load, behind, 1.0);
    for (const TractionPart& part : traction.parts) visit(part.load, behind, (part.to - part.from) / along);
  }
}

/// Time in which rock swings on the springs of its sides, over 2 pi: sqrt(rho L / K) with the length L of rock behind a
/// side of stiffness K (Pa/m); 0 without.
double time_on_springs(const Scene& scene) {
  const double density = heaviest_material(scene.mechanics->parameters);
  double longest = 0;
  for_each_load(scene, [&](const TractionLoad& load, double behind, double share) {
    if (load.stiffness > 0 && share > 0)
      longest = std::max(longest, std::sqrt(density * behind / (load.stiffness * share)));
  });
  return longest;
}

bool holds(const TractionLoad& load) {
  return load.support != Support::free && load.support != Support::servo;
}

}  // namespace

bool is_supported(const Scene& scene) {
  return std::any_of(all_sides.begin(), all_sides.end(), [&](Side side) {
    const TractionBoundary& traction = scene.side(side).traction;
    return holds(traction.load) || std::any_of(traction.parts.begin(), traction.parts.end(),
                                               [](const TractionPart& part) { return holds(part.load); });
  });
}

double quickest_load(const Scene& scene) {
  if (scene.flow && std::hypot(scene.flow->body_force[0], scene.flow->body_force[1]) > 0) return 0;
  if (!scene.mechanics->initial_velocities.empty()) return 0;
  if (falls(scene)) return 0;
  double shortest = scene.heat && expands(scene.mechanics->parameters) ? heat_through_triangle(scene) : never;
  for_each_boundary(scene,
                    [&](const BoundarySection& given) { shortest = std::min(shortest, quickest(given, scene)); });
  return shortest;
}

bool feels_its_mass(const Scene& scene) {
  bool pressed = false;
  for_each_load(scene, [&](const TractionLoad& load, double, double) { pressed = pressed || changes(load); });
  return pressed || !scene.mechanics->initial_velocities.empty() || slenderness(scene) > 1 || falls(scene) ||
         time_on_springs(scene) > crossing_time(scene);
}

double crossing_time(const Scene& scene) {
  const MechanicsParameters& rock = scene.mechanics->parameters;
  double speed = std::sqrt(rock.bond.normal_modulus / rock.density);
  for (const RockMaterial& material : rock.materials)
    speed = std::min(speed, std::sqrt(material.bond.normal_modulus / material.density));
  return std::max(scene.lattice.length_x, scene.lattice.length_y) / speed;
}

double quasi_static_mass_scaling(const Scene& scene, double tolerance) {
  constexpr double heaviest = 64, share = 6;
  // waves may be slower by this factor
  const double slowest = std::max(slenderness(scene) * crossing_time(scene), time_on_springs(scene));
  const double slower = share * tolerance * quickest_load(scene) / slowest;
  double scaling = heaviest;
  while (scaling > 1 && std::sqrt(scaling) > slower) scaling /= 4;
  return scaling;
}

std::string mass_scaling_note(const Scene& scene) {
  const double time = quickest_load(scene);
  return fmt::format(
      "accuracy.tolerance = {:g} allows mechanics.mass_scaling = {:g}: {}", scene.accuracy.tolerance,
      scene.mechanics->parameters.mass_scaling,
      time == never ? "no load changes" : fmt::format("no load changes within less than {:.3g} s", time));
}

}  // namespace vug
