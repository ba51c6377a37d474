#pragma once
// Conserved sums: the amount stored now, the initial amount, and every gain.
#include <cstddef>
#include <string>
#include <vector>

namespace vug {

/// The balance of one conserved quantity: stored = initial + sum of gains, each gain under its own name.
struct Balance {
  struct Term {
    std::string name;
    double value;
  };
  std::string quantity;  ///< for instance "L1"
  std::string unit;      ///< for instance "mol/m"
  double initial = 0;
  double stored = 0;
  std::vector<Term> gains;  ///< positive where they increase what is stored; numerical terms have names of their own
  double negligible = 0;    ///< amounts up to this are rounding errors of differences

  /// stored - initial - sum of gains, over the largest of these amounts (0 when all are negligible).
  double relative_error() const;
};

/// All balances of a scene. Several modules may add gains to the same quantity.
struct Ledger {
  std::vector<Balance> balances;
  /// The balance of `quantity`, added where it does not exist yet.
  Balance& of(const std::string& quantity, const std::string& unit);
};

}  // namespace vug
