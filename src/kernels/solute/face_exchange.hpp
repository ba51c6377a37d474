#pragma once
// Exchange between neighbours where the velocity that carried a species differs from the flow between them.
#include "kernels/solute/solute.hpp"

namespace vug {

/// Adds sum_n (C_n - C)/2 (+-)steps excess to each node, over its straight fluid neighbours n, in a step of a species
/// that takes `steps` flow steps. `excess` (fluid, axis), counted outwards, is the mean of the two velocities less the
/// flow through the face between them (flow/face_flow.hpp). The advective form returns C times this excess on both
/// sides of a face, each side with its own C, and so creates the difference. The exchange adds the same to both sides;
/// together with the advective form, one node then gains what the other loses. What it adds to the total is added to
/// correction(block).
template <class T>
void exchange_at_faces(const Exec& exec, const FluidNodes& nodes, const VectorField<T>& excess, int steps,
                       const SoluteFields<T>& s, const ScalarField<double>& correction);

}  // namespace vug
