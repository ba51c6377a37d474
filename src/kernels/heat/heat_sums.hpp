#pragma once
// Sums and extremes of the heat fields, for ledgers and guards.
#include "kernels/heat/heat.hpp"

namespace vug {

/// Adds the energy of the nodes in the rows of this process to `total` (row): theta in fluid, sigma theta in solid.
template <class T>
void add_heat_energy(const Exec& exec, const HeatFields<T>& fields, const ScalarField<double>& total);

/// total(block) += energy gained because the nodes list[first, last) turn from solid to fluid at constant temperature,
/// (1 - sigma) theta each. They must still be solid in `fields`; others add nothing.
template <class T>
void add_birth_energy(const Exec& exec, const HeatFields<T>& fields, const IndexList& list, int first, int last,
                      const ScalarField<double>& total);

/// For the nodes in the rows of this process, change(row) += |theta - before| and amount(row) += |theta|; nothing in
/// openings. before (node) is theta afterwards.
template <class T>
void add_temperature_change(const Exec& exec, const HeatFields<T>& fields, const ScalarField<T>& before,
                            const ScalarField<double>& change, const ScalarField<double>& amount);

/// Extremes of theta over the rows of this process and the number of entries that are not finite. Read on the host: for
/// guards, not in a step.
struct HeatExtremes {
  double lowest = 0, highest = 0;
  int not_finite = 0;
};
template <class T>
HeatExtremes heat_extremes(const Exec& exec, const HeatFields<T>& fields);

}  // namespace vug
