#pragma once
// What the flow's own populations carry through the faces between a node and its straight neighbours.
#include "kernels/flow/flow.hpp"

namespace vug {

/// excess(i, axis) = (u_i + u_n)/2 - F: by how much the mean velocity along an axis of fluid node i and its neighbour n
/// in positive direction is above F, what their populations carry through the face between them; 0 where n is not
/// fluid. A diagonal link goes by way of its two corners, half each, or of the one that is fluid. In a steady flow
/// what enters a node through its faces leaves it through them, to rounding, but where a diagonal link squeezes
/// between two corners of rock and beside links out of the lattice. Of the sweep that `fields` has just been through.
/// excess: (fluid, axis), cells per step.
template <class T>
void face_excess(const Exec& exec, const FluidNodes& nodes, const FlowFields<T>& fields, const VectorField<T>& excess);

}  // namespace vug
