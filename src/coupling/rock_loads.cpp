#include "coupling/rock_loads.hpp"

#include "coupling/temperature_range.hpp"
#include "io/each_boundary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace vug {

namespace {

/// Outward normal of a side and the direction in which a shear stress counts as positive.
struct Directions {
  std::array<double, 2> normal, along;
};

Directions directions_of(RockSide side) {
  switch (side) {
    case RockSide::right:
      return {{1, 0}, {0, 1}};
    case RockSide::left:
      return {{-1, 0}, {0, 1}};
    case RockSide::top:
      return {{0, 1}, {1, 0}};
    default:
      return {{0, -1}, {1, 0}};
  }
}

std::array<double, 2> traction_at(const TractionLoad& load, RockSide side, double time) {
  const auto [normal, along] = directions_of(side);
  const double pressure = load.normal_stress.at(time), shear = load.shear_stress.at(time);
  return {-pressure * normal[0] + shear * along[0], -pressure * normal[1] + shear * along[1]};
}

bool changes(const TractionLoad& load) {
  return !load.normal_stress.constant() || !load.shear_stress.constant();
}

bool moves(const TractionLoad& load) {
  return load.velocity[0].peak() != 0 || load.velocity[1].peak() != 0;
}

SidePart side_part(const TractionLoad& load, RockSide side, double from, double to, const std::string& name) {
  SidePart part{side, from, to, load.support, {}, load.stiffness, {}, changes(load), name};
  for (std::size_t axis = 0; axis < 2; ++axis) {
    part.traction[axis] = [load, side, axis](double time) { return traction_at(load, side, time)[axis]; };
    if (moves(load)) part.velocity[axis] = [table = load.velocity[axis]](double time) { return table.at(time); };
  }
  return part;
}

/// Enlarges a load by another one.
void include(LargestLoad& load, const LargestLoad& other) {
  load = {std::max(load.ever, other.ever), std::max(load.change, other.change)};
}

LargestLoad largest(const TractionLoad& load) {
  LargestLoad found;
  for (const TimeTable* stress : {&load.normal_stress, &load.shear_stress}) {
    const double start = stress->at(0);
    include(found, {std::abs(stress->peak()), std::max(stress->highest() - start, start - stress->lowest())});
  }
  return found;
}

/// The smallest change of those of its stresses that change; infinite where none does.
double least_change(const TractionLoad& load) {
  double least = std::numeric_limits<double>::infinity();
  for (const TimeTable* stress : {&load.normal_stress, &load.shear_stress})
    if (stress->highest() > stress->lowest()) least = std::min(least, stress->highest() - stress->lowest());
  return least;
}

LargestLoad largest(const BoundarySection& side, const Scene& scene) {
  LargestLoad found = largest(side.traction.load);
  for (const TractionPart& part : side.traction.parts) include(found, largest(part.load));
  if (scene.flow && side.flow.kind == FlowBoundaryKind::pressure) {
    const double start = scene.flow->initial_pressure;
    const double gauge = std::max(side.flow.pressure.highest() - start, start - side.flow.pressure.lowest());
    include(found, {gauge, gauge});
  }
  return found;
}

/// Of loads on the whole volume of a material; warming in K.
LargestLoad largest(double density, double expansion, const BondParameters& bond, const Scene& scene, double warming) {
  const double length = std::max(scene.lattice.length_x, scene.lattice.length_y);
  const auto& gravity = scene.mechanics->gravity;
  const double expanding = bond.normal_modulus * expansion * warming;
  LargestLoad found{std::max(expanding, density * std::hypot(gravity[0], gravity[1]) * length), expanding};
  for (const InitialVelocity& start : scene.mechanics->initial_velocities) {
    const double wave = std::sqrt(bond.normal_modulus * density) * std::hypot(start.velocity[0], start.velocity[1]);
    include(found, {wave, wave});
  }
  return found;
}

}  // namespace

Loads boundary_loads(const Scene& scene) {
  Loads loads;
  loads.gravity = scene.mechanics->gravity;
  const LargestLoad load = largest_load(scene);
  loads.largest = load.ever;
  loads.change = load.change;
  for (const Side side : {Side::right, Side::top, Side::left, Side::bottom}) {
    const TractionBoundary& boundary = scene.side(side).traction;
    const double length = scene.lattice.length_of(side);
    const RockSide which = rock_side(side);
    const auto s = static_cast<std::size_t>(which);
    loads.name[s] = fmt::format("{}: boundary.{}.traction", scene.path, name_of(side));
    loads.support[s] = boundary.load.support;
    loads.stiffness[s] = boundary.load.stiffness;
    loads.traction[s] = traction_at(boundary.load, which, 0);
    if (changes(boundary.load) || moves(boundary.load))
      loads.parts.push_back(side_part(boundary.load, which, -1, length + 1, loads.name[s]));
    const double last = length * (1 - 1e-12);  // for a point at the end of the side
    for (std::size_t n = 0; n < boundary.parts.size(); ++n) {
      const TractionPart& part = boundary.parts[n];
      const std::string name = fmt::format("{}.parts.{}", loads.name[s], n);
      const bool point = part.from == part.to;
      loads.parts.push_back(side_part(part.load, which, point ? std::min(part.from, last) : part.from,
                                      point ? std::min(part.to, last) : part.to, name));
    }
  }
  return loads;
}

LargestLoad largest_load(const Scene& scene) {
  const MechanicsParameters& rock = scene.mechanics->parameters;
  const double warming = scene.heat ? temperature_range(scene).span() : 0;
  LargestLoad found = largest(rock.density, rock.thermal_expansion, rock.bond, scene, warming);
  for (const RockMaterial& material : rock.materials)
    include(found, largest(material.density, material.thermal_expansion, material.bond, scene, warming));
  for_each_boundary(scene, [&](const BoundarySection& given) { include(found, largest(given, scene)); });
  if (scene.flow) {
    const double length = std::max(scene.lattice.length_x, scene.lattice.length_y);
    const double drive =
        scene.flow->density * length * std::hypot(scene.flow->body_force[0], scene.flow->body_force[1]);
    include(found, {drive, drive});
  }
  if (scene.reaction) found.change = found.ever;
  // rock must not sleep through the least of the tables either, whatever changes beside it
  for_each_boundary(scene, [&](const BoundarySection& given) {
    found.change = std::min(found.change, least_change(given.traction.load));
    for (const TractionPart& part : given.traction.parts)
      found.change = std::min(found.change, least_change(part.load));
  });
  return found;
}

}  // namespace vug
