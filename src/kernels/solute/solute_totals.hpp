#pragma once
// Sums of a species over its nodes, for ledgers.
#include "kernels/solute/solute.hpp"

namespace vug {

/// total(block) += the solute in the block's nodes, for the blocks of this process: the sum of all populations, in
/// double and in a fixed order. Valid at any moment of a step.
template <class Set, class T>
void add_solute(const Exec& exec, const FluidNodes& nodes, const SoluteFields<T>& s, const ScalarField<double>& total);

/// total(block) += |C - before| over the block's nodes below `count`, for the blocks of this process; before (fluid) is
/// C afterwards, for all their nodes.
template <class T>
void add_change(const Exec& exec, const FluidNodes& nodes, const Kokkos::View<const T*>& C, int count,
                const ScalarField<T>& before, const ScalarField<double>& total);

}  // namespace vug
