#pragma once
// What the flow's own populations carry through the faces between a node and its straight neighbours.
#include "kernels/flow/flow.hpp"

namespace vug {

/// Sets excess(i, axis) = (u_i + u_n)/2 - F for fluid node i and its neighbour n in the positive direction of the axis:
/// the mean velocity of both, less what their populations carry through the face between them; 0 where n is not fluid.
/// A diagonal link passes by way of its two corners, half each, or of the one that is fluid. In a steady flow what
/// enters a node through its faces leaves it through them, to rounding, except where a diagonal link squeezes between
/// two corners of rock and beside links out of the lattice. Belongs to the last sweep of `fields`. excess: (fluid,
/// axis), cells per step.
template <class T>
void face_excess(const Exec& exec, const FluidNodes& nodes, const FlowFields<T>& fields, const VectorField<T>& excess);

}  // namespace vug
