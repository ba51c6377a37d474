#pragma once
// What gauges in the rock read: each asked between steps, summed on the device in a fixed order.
#include "dem/bonds.hpp"

#include <array>

namespace vug {

/// A point of the rock: the triangle that it moves with, and its place in it.
struct RockPoint {
  int particle = 0;
  Vec2 arm;  ///< from the centroid at the start, m
};

/// Displacement of a point since the end of the preload, m, as bonds see it:
///   u - u_0 + ((1 + alpha dT) Q - Q_0) arm,  Q the rotation, `expansion` alpha (MechanicsParameters);
/// the preload counts as done at the temperature without thermal stress, as it is in a run.
Vec2 displacement_of(const Exec& exec, const Particles& particles, double expansion, const RockPoint& point);

/// Force that holds the particles listed for x along x, and those for y along y, N per m of thickness.
Vec2 reaction_of(const Exec& exec, const Particles& particles, const std::array<IndexList, 2>& held);

/// Of the ends of all bonds that have failed the one that lies furthest along `direction`, or `from` where none lies
/// beyond it; places of the undeformed rock, m.
Vec2 furthest_crack_tip(const Exec& exec, const Particles& particles, const Bonds& bonds, Vec2 from, Vec2 direction);

}  // namespace vug
