#pragma once
// By which share of itself an amount has changed.

namespace vug {

/// change / amount; 1 where all of it is gone, and 0 where there is exactly none and was none. Nothing arrives
/// unforeseen: what a table brings is known (given_changes.hpp), and ahead of what is carried or diffuses go traces, a
/// cell per step of the solutes, far below what matters but not exactly none.
inline double amount_share(double change, double amount) {
  if (amount > 0) return change / amount;
  return amount == 0 && change == 0 ? 0 : 1;
}

}  // namespace vug
