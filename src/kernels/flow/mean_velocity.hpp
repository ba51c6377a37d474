#pragma once
// The sum of a component of the velocity, for the history.
#include "kernels/flow/flow.hpp"

namespace vug {

/// total(block) += sum of u(i, axis) over the fluid nodes of the block; `total` has at least block_count(nodes.count)
/// entries. The same bits for any number of threads.
template <class T>
void add_velocity(const Exec& exec, const FluidNodes& nodes, const VectorField<T>& u, int axis,
                  const ScalarField<double>& total);

}  // namespace vug
