#include "coupling/pressed_speed.hpp"

#include "coupling/body_forces.hpp"
#include "coupling/driving_pressure.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <utility>

namespace vug {

namespace {

using Vector = std::array<double, 2>;

/// Pores in series: the nodes at one distance after the other.
struct Pores {
  double sum = 0;  ///< of w^-3
  double narrowest = std::numeric_limits<double>::infinity();

  void add(const std::vector<std::size_t>& front, const std::vector<int>& width) {
    int widest = 0;
    for (const std::size_t n : front) widest = std::max(widest, width[n]);
    if (widest == 0) return;
    narrowest = std::min(narrowest, static_cast<double>(widest));
    sum += std::pow(widest, -3);
  }
  /// Speed times viscosity over the pressure, lattice units.
  double speed() const { return sum > 0 ? 1 / (8 * sum * narrowest) : std::numeric_limits<double>::infinity(); }
  /// The same for a hole of that width, at the pressure, in the wall of a wide space.
  double speed_through_hole() const { return narrowest / 4; }
};

/// A mouth to which fluid may be pressed, and by how much the pressure at the other one is above its own.
struct Target {
  const Mouth* mouth;
  Span above;
};

/// Body forces at the start as far as they have a potential, lattice units: none along an axis whose sides are joined.
Vector force_with_potential(const Scene& scene, const LatticeUnits& units) {
  Vector force = body_forces(scene, units).at_start;
  for (int axis = 0; axis < 2; ++axis)
    if (periodic_sides(scene)[axis]) force[axis] = 0;
  return force;
}

std::array<int, 2> cell_of(std::size_t node, const FluidPicture& picture) {
  return {static_cast<int>(node % picture.nx), static_cast<int>(node / picture.nx)};
}

/// Potential -f.x of a force beside a node of a mouth: on the side of the lattice, or in the middle of the opening.
double potential(const Mouth& mouth, std::array<int, 2> cell, Vector force) {
  Vector place = mouth.centre;
  if (mouth.side) place[is_upright(*mouth.side)] = 0.5 + cell[is_upright(*mouth.side)];
  return -force[0] * place[0] - force[1] * place[1];
}

/// Largest difference of p - f.x between the nodes of a mouth and those of a target that are within a distance.
double drive(const Mouth& from, const Target& to, const std::vector<bool>& within, int distance, Vector force,
             const FluidPicture& picture) {
  if (force == Vector{}) return std::max(std::abs(to.above.low), std::abs(to.above.high));
  double largest = 0;
  for (const std::size_t end : to.mouth->nodes) {
    if (!within[end]) continue;
    const auto there = cell_of(end, picture);
    const double below = potential(*to.mouth, there, force);
    for (const std::size_t start : from.nodes) {
      const auto here = cell_of(start, picture);
      bool near = true;
      for (int axis = 0; axis < 2; ++axis)
        near = near && (force[axis] == 0 || std::abs(here[axis] - there[axis]) <= distance);
      if (!near) continue;
      const double offset = potential(from, here, force) - below;
      largest = std::max({largest, std::abs(to.above.low + offset), std::abs(to.above.high + offset)});
    }
  }
  return largest;
}

/// Whether two mouths are on sides that meet, or on one side, so that they may touch.
bool are_neighbours(const Mouth& a, const Mouth& b) {
  return a.side && b.side && (a.side == b.side || is_upright(*a.side) != is_upright(*b.side));
}

/// Follows the fluid from a mouth until it has reached all targets, of which there are some, or no more.
void follow(const Mouth& from, std::vector<Target> targets, Vector force, const FluidPicture& picture,
            const std::vector<int>& width, PressedFlow& fastest) {
  Pores pores;
  int distance = 0;
  picture.for_each_front(from.nodes, [&](const std::vector<std::size_t>& front, const std::vector<bool>& within) {
    pores.add(front, width);
    std::erase_if(targets, [&](const Target& to) {
      const auto& ends = to.mouth->nodes;
      if (std::none_of(ends.begin(), ends.end(), [&](std::size_t n) { return within[n]; })) return false;
      const double pressure = drive(from, to, within, distance, force, picture);
      const double alone = pores.speed();
      const double along = are_neighbours(from, *to.mouth) ? std::min(alone, pores.speed_through_hole()) : alone;
      const double speed = pressure > 0 ? pressure * along : 0;  // and not 0 times infinity
      if (speed > fastest.speed) fastest = {speed, from.key, to.mouth->key};
      return true;
    });
    ++distance;
    return !targets.empty();
  });
}

}  // namespace

PressedFlow pressed_flow(const Scene& scene, const FluidPicture& picture, const std::vector<Mouth>& mouths,
                         const std::vector<int>& width, const LatticeUnits& units) {
  const Vector force = force_with_potential(scene, units);
  PressedFlow fastest;
  for (const Mouth& from : mouths) {
    if (from.conditions->flow.kind != FlowBoundaryKind::pressure) continue;
    std::vector<Target> targets;
    for (const Mouth& to : mouths) {
      if (!to.yields() || to.key == from.key) continue;
      const Span above = difference_over_time(from.conditions->flow, to.conditions->flow, units);
      if (above.low != 0 || above.high != 0 || force != Vector{}) targets.push_back({&to, above});
    }
    if (!targets.empty()) follow(from, std::move(targets), force, picture, width, fastest);
  }
  return fastest;
}

}  // namespace vug
