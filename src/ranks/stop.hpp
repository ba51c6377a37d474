#pragma once
// Requests to stop that reach some of the ranks only.
#include "ranks/ranks.hpp"

namespace vug {

/// Whether a stop was requested on any of the ranks; from then on it is requested on all of them, by the same signal.
/// Called by all ranks, in the same order.
bool any_is_to_stop(const Ranks& ranks);

/// Throws Interrupted on all ranks where it is.
void throw_if_any_is_to_stop(const Ranks& ranks);

}  // namespace vug
