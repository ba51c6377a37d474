#pragma once
// Error of a number, estimated from the same number on coarser lattices (Richardson 1911; the index of Roache 1994).
#include <algorithm>
#include <cmath>
#include <optional>

namespace vug {

/// How a number converges over three lattices; `rounding`: it is 0 but for the rounding of larger ones; `walls_stand`:
/// it cannot be told, because walls that recede have not moved yet;
/// `by_chance`: faster than staircase walls let it.
enum class Convergence { monotone, by_chance, oscillating, none, unknown, rounding, walls_stand };

struct ErrorBar {
  double bar = 0;               ///< half its length, in the unit of the number
  std::optional<double> order;  ///< observed; only for monotone convergence
  Convergence convergence = Convergence::unknown;
};

/// Error bar of `fine` from `coarse`, on `ratio` times the spacing, and `coarser`, on ratio² times the spacing.
///
/// With d = coarse - fine and D = coarser - coarse the observed order is p = ln(D/d) / ln(ratio), and
///
///     bar = 1.25 |d| / (ratio^p - 1)
///
/// (Roache 1994, grid convergence index), with p limited to 1/2 ... 2, the order of the schemes. Walls that lattices
/// draw as staircases (`staircase`) have errors of first order whose share changes from lattice to lattice, so that
/// two of the three may agree by chance: p is then at most 1, and d at least D / ratio. Without `coarser`, and
/// where the numbers do not converge (|d| >= |D|), the bar is that of first order with Roache's factor of 3 for two
/// lattices: 3 |d| / (ratio - 1). Otherwise, where they oscillate (d/D < 0), it is the larger of 3 |d| and |D|; where
/// the first two agree (d = 0), it is |D|. Numbers that agree to twelve digits differ by rounding: 3 max(|d|, |D|) /
/// (ratio - 1).
inline ErrorBar error_bar(double fine, double coarse, std::optional<double> coarser, double ratio,
                          bool staircase = false) {
  const double d = std::abs(coarse - fine);
  if (!coarser) return {3 * d / (ratio - 1), std::nullopt, Convergence::unknown};
  const double D = std::abs(*coarser - coarse);
  constexpr double rounding = 1e-12;
  if (const double largest = std::max(d, D); largest <= rounding * std::abs(fine))
    return {3 * largest / (ratio - 1), std::nullopt, Convergence::monotone};
  if (d >= D) return {3 * d / (ratio - 1), std::nullopt, Convergence::none};
  if ((coarse - fine) * (*coarser - coarse) < 0) return {std::max(3 * d, D), std::nullopt, Convergence::oscillating};
  if (d == 0) return {D, std::nullopt, Convergence::unknown};
  const double order = std::log(D / d) / std::log(ratio);
  const double counted = staircase ? std::max(d, D / ratio) : d, highest = staircase ? 1 : 2;
  return {1.25 * counted / (std::pow(ratio, std::clamp(order, 0.5, highest)) - 1), order,
          staircase && order > 2 ? Convergence::by_chance : Convergence::monotone};
}

}  // namespace vug
