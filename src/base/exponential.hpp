#pragma once
// An exponential function that vectorises in loops over nodes, with the same bits on every processor.
#include "base/base.hpp"

#include <cstdint>

namespace vug {

/// Arguments outside of this range are clamped to it; exponential() is then 1e-304 or 1e304.
inline constexpr double least_exponent = -700, largest_exponent = 700;

/// e^x with a relative error of at most 2.2e-16 (a unit in the last place) for |x| <= 700: x = n ln 2 + r with |r| <=
/// ln(2)/2, and 2^n times the series of e^r to r^13, whose next term is below 5e-18. Uses additions, multiplications
/// and a shift only. The library's function differs from system to system and is called number by number.
KOKKOS_FORCEINLINE_FUNCTION double exponential(double x) {
  constexpr double per_ln2 = 1.4426950408889634;
  // ln 2 in two parts, the first of 32 bits, so that its product with n is exact
  constexpr double ln2_high = 0x1.62e42feep-1, ln2_low = 0x1.a39ef35793c76p-33;
  constexpr double shift = 0x1.8p52;  // adding it leaves the nearest integer in the lowest bits
  const double t = x < least_exponent ? least_exponent : x > largest_exponent ? largest_exponent : x;
  const double shifted = t * per_ln2 + shift;
  const double n = shifted - shift;
  const double r = (t - n * ln2_high) - n * ln2_low;
  double sum = 1.0 / 6227020800;  // 1/13!
  sum = sum * r + 1.0 / 479001600;
  sum = sum * r + 1.0 / 39916800;
  sum = sum * r + 1.0 / 3628800;
  sum = sum * r + 1.0 / 362880;
  sum = sum * r + 1.0 / 40320;
  sum = sum * r + 1.0 / 5040;
  sum = sum * r + 1.0 / 720;
  sum = sum * r + 1.0 / 120;
  sum = sum * r + 1.0 / 24;
  sum = sum * r + 1.0 / 6;
  sum = sum * r + 0.5;
  const double exponential_of_r = 1 + (r + r * r * sum);
  const auto bits = Kokkos::bit_cast<std::uint64_t>(shifted);
  const double power = Kokkos::bit_cast<double>((bits + 1023) << 52);  // 2^n: the biased n in the exponent bits
  return exponential_of_r * power;
}

}  // namespace vug
