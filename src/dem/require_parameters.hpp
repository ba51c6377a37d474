#pragma once
// Ranges in which the mechanics is defined.
#include "dem/parameters.hpp"

namespace vug {

/// Throws InputError naming the first parameter that is out of range.
void require_parameters(const MechanicsParameters& parameters);

}  // namespace vug
