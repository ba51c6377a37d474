#include "coupling/rock_loads.hpp"

#include <fmt/format.h>

#include <algorithm>
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

}  // namespace

RockSide rock_side(std::string_view name) {
  return name == "right"  ? RockSide::right
         : name == "top"  ? RockSide::top
         : name == "left" ? RockSide::left
                          : RockSide::bottom;
}

Loads boundary_loads(const Scene& scene) {
  Loads loads;
  loads.gravity = scene.mechanics->gravity;
  const auto add = [&](RockSide which, const char* side, const TractionBoundary& boundary, double length) {
    const auto s = static_cast<std::size_t>(which);
    loads.name[s] = fmt::format("{}: boundary.{}.traction", scene.path, side);
    loads.support[s] = boundary.load.support;
    loads.stiffness[s] = boundary.load.stiffness;
    loads.traction[s] = traction_at(boundary.load, which, 0);
    if (changes(boundary.load) || moves(boundary.load))
      loads.parts.push_back(side_part(boundary.load, which, -1, length + 1, loads.name[s]));
    const double last = length * (1 - 1e-12);  // of a point at the end of the side
    for (std::size_t n = 0; n < boundary.parts.size(); ++n) {
      const TractionPart& part = boundary.parts[n];
      const std::string name = fmt::format("{}.parts.{}", loads.name[s], n);
      const bool point = part.from == part.to;
      loads.parts.push_back(side_part(part.load, which, point ? std::min(part.from, last) : part.from,
                                      point ? std::min(part.to, last) : part.to, name));
    }
  };
  add(RockSide::right, "right", scene.right.traction, scene.lattice.length_y);
  add(RockSide::top, "top", scene.top.traction, scene.lattice.length_x);
  add(RockSide::left, "left", scene.left.traction, scene.lattice.length_y);
  add(RockSide::bottom, "bottom", scene.bottom.traction, scene.lattice.length_x);
  return loads;
}

}  // namespace vug
