#pragma once
// The push of the fluid on what is left of triangles that are gone.
#include "coupling/solid_spread.hpp"
#include "dem/particles.hpp"

namespace vug {

/// Hands force and torque of triangles that are gone on to the present ones beyond their edges on which they lean: in
/// proportion to how far the force points to their centroids, along its own line. What is left of such a triangle still
/// holds the fluid up, and no other part of the rock would feel the pressure there. The force of what is gone is left
/// as it is and moves nothing; where nothing is ahead, it is lost.
void hand_on_push(const Exec& exec, const TriangleNeighbours& neighbours, const Particles& particles);

}  // namespace vug
