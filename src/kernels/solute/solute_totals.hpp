#pragma once
// Sums and ranges of a species for ledgers and guards. They wait for the device: for monitor steps.
#include "kernels/solute/solute.hpp"

namespace vug {

/// total(block) += the solute in its nodes, of our share: the sum of all populations, in double and in a fixed order.
/// Right at any moment of a step.
template <class Set, class T>
void add_solute(const Exec& exec, const FluidNodes& nodes, const SoluteFields<T>& s, const ScalarField<double>& total);

/// total(block) += |C - before| of its nodes below `count`, of our share; before(fluid) is C afterwards, of all nodes.
template <class T>
void add_change(const Exec& exec, const FluidNodes& nodes, const Kokkos::View<const T*>& C, int count,
                const ScalarField<T>& before, const ScalarField<double>& total);

/// Smallest and largest value of our share of the entries of a field, and the first entry that is not finite.
struct FieldRange {
  double min = 0, max = 0;    ///< over the finite entries; +infinity and -infinity if there is none
  int first_not_finite = -1;  ///< -1: all are finite
};
template <class T>
FieldRange field_range(const Exec& exec, const ScalarField<T>& field, const Share& list);

}  // namespace vug
