#include "kernels/launch/long_sum.hpp"

#include "kernels/launch/launch.hpp"

namespace vug {

/// sum += recent, and carry += the exact rounding error of this addition, in which the smaller summand has lost its
/// last digits.
struct SettleLongSum {
  ScalarField<double> recent, sum, carry;
  KOKKOS_FUNCTION void operator()(int i) const {
    const double before = sum(i), added = recent(i), after = before + added;
    carry(i) += Kokkos::abs(before) >= Kokkos::abs(added) ? (before - after) + added : (added - after) + before;
    sum(i) = after;
    recent(i) = 0;
  }
};

void LongSum::settle(const Exec& exec) const {
  for_each_node(exec, "vug::long_sum::settle", static_cast<int>(sum_.extent(0)), SettleLongSum{recent_, sum_, carry_});
}

void LongSum::resize(const Exec& exec, std::size_t entries) {
  for (ScalarField<double>* part : {&recent_, &sum_, &carry_}) Kokkos::resize(exec, *part, entries);
}

double LongSum::total() const {
  return sum_in_order(sum_) + (sum_in_order(carry_) + sum_in_order(recent_));
}

}  // namespace vug
