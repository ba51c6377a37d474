#pragma once
// Sums of a field by mineral, for the ledger of each.
#include "kernels/base/base.hpp"

#include <string>
#include <vector>

namespace vug {

/// sums[m] = sum of value(i) over the i < n whose mineral(i) is m, for m < minerals. In a fixed order: the same bits
/// for any number of threads. Waits for the device: for rows of a history, not inside a step.
std::vector<double> sums_by_mineral(const Exec& exec, const std::string& label, int n,
                                    const Kokkos::View<const double*>& value,
                                    const Kokkos::View<const std::uint8_t*>& mineral, int minerals);

}  // namespace vug
