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
  return largest > negligible ? error / largest : 0;
}

Balance& Ledger::of(const std::string& quantity, const std::string& unit) {
  for (Balance& balance : balances)
    if (balance.quantity == quantity) return balance;
  return balances.emplace_back(Balance{quantity, unit, 0, 0, {}});
}

}  // namespace vug
