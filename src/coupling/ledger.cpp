#include "coupling/ledger.hpp"

#include <algorithm>
#include <cmath>

namespace vug {

double Balance::relative_error() const {
  double error = stored - initial;
  double largest = std::max(std::abs(stored), std::abs(initial));
  for (const Term& gain : gains) {
    error -= gain.value;
    largest = std::max(largest, std::abs(gain.value));
  }
  return largest > 0 ? error / largest : 0;
}

}  // namespace vug
