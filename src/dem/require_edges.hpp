#pragma once
#include "dem/loads.hpp"

namespace vug {

/// Throws InputError where a load of a side or part finds no edge of the rock to push, or a support none to hold. What
/// later parts hide wholly, or all but slivers of rounding, is asked for nothing.
void require_edges(const Assembly& assembly, const std::vector<BoundaryEdge>& boundary, const Loads& loads,
                   const Particles& particles);

}  // namespace vug
