#pragma once
// Sums of amounts that arrive in every step of a run of millions of steps.
#include "base/base.hpp"

#include <string>

namespace vug {

/// A ledger with one entry per link or block. Nearly equal amounts that are added a million times to a large sum are
/// all rounded the same way, each by up to half of the sum's last digit: an error of 2e-12 after a million steps of a
/// Stefan problem. Kernels therefore add to `recent`. `settle`, called every thousand steps or so, moves this to a sum
/// that keeps its rounding errors as well (Neumaier's summation): an error of 2e-14. The same bits for any number of
/// threads.
class LongSum {
 public:
  LongSum() = default;
  LongSum(const std::string& label, std::size_t entries)
      : recent_(label, entries), sum_(label + "_sum", entries), carry_(label + "_carry", entries) {}

  static constexpr int interval = 1024;  ///< steps between calls of settle

  const ScalarField<double>& recent() const { return recent_; }  ///< (entry) what kernels add to
  const ScalarField<double>& sum() const { return sum_; }        ///< (entry) settled so far, for a checkpoint
  const ScalarField<double>& carry() const { return carry_; }    ///< (entry) its rounding errors, likewise

  /// Moves `recent` to the settled sums; on the device.
  void settle(const Exec& exec) const;
  /// Changes the number of entries. New ones start at 0, the others keep their values. `recent` becomes another View.
  void resize(const Exec& exec, std::size_t entries);
  /// Sum of all entries; waits for the device.
  double total() const;

 private:
  ScalarField<double> recent_, sum_, carry_;
};

}  // namespace vug
