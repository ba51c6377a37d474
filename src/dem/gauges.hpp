#pragma once
// Readings of gauges in the rock: each is requested between steps and summed on the device in a fixed order.
#include "dem/bonds.hpp"

#include <array>

namespace vug {

/// A point of the rock: the triangle that it moves with, and its position in it.
struct RockPoint {
  int particle = 0;
  Vec2 arm;  ///< from the centroid at the start, m
};

/// Displacement of a point since the end of the preload, m, consistent with the openings of bonds:
///   u - u_0 + ((1 + alpha dT) Q - Q_0) arm,  Q the rotation, `expansion` alpha (MechanicsParameters).
/// With output_from_unloaded since before it: u_0 = 0, Q_0 = 1.
/// The preload is taken to have been done at the temperature without thermal stress, as it is in a run.
Vec2 displacement_of(const Exec& exec, const Particles& particles, double expansion, const RockPoint& point);

/// Force that holds the particles listed for x along x, and those for y along y, N per m of thickness.
Vec2 reaction_of(const Exec& exec, const Particles& particles, const std::array<IndexList, 2>& held);

/// Of the ends of all failed bonds, the one that lies furthest along `direction`, or `from` if none lies beyond it.
/// Positions in the undeformed rock, m.
Vec2 furthest_crack_tip(const Exec& exec, const Particles& particles, const Bonds& bonds, Vec2 from, Vec2 direction);

}  // namespace vug
