#pragma once
// Derived numbers of a case with their measured safe ranges, which `vug check` prints and about which a run warns.
#include <limits>
#include <string>
#include <vector>

namespace vug {

/// One derived number.
struct Limit {
  std::string module;
  std::string name;  ///< for instance "relaxation time tau"
  double value = 0;
  std::string unit;
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
  /// What to do when it is out of range; where it begins with "change", it is said whether to raise or to lower what
  /// the value grows with.
  std::string advice;

  bool inside() const { return value >= low && value <= high; }
};

using LimitTable = std::vector<Limit>;

}  // namespace vug
