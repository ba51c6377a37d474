#pragma once
// What neighbours owe each other when the velocity that carried a species between them was not what flowed there.
#include "kernels/solute/solute.hpp"

namespace vug {

/// Adds to each node sum_n (C_n - C)/2 (+-)steps excess over its straight fluid neighbours n in a step of a species
/// that takes `steps` of the flow, `excess` (fluid, axis) being by how much the mean of two velocities is above what
/// flows through the face between them (flow/face_flow.hpp), counted outwards. The advective form gives back C times
/// all that has flowed out too much, from both sides of a face each with its own C, and creates the difference; this
/// takes the same from both sides, so that the two together move what one node gains from the other. What it adds to
/// the total is added to correction(block).
template <class T>
void exchange_at_faces(const Exec& exec, const FluidNodes& nodes, const VectorField<T>& excess, int steps,
                       const SoluteFields<T>& s, const ScalarField<double>& correction);

}  // namespace vug
