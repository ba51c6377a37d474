#pragma once
#include "dem/loads.hpp"

namespace vug {

/// Throws InputError where a load of a side or part finds no edge of the rock to push, or a support none to hold. Sides
/// and parts that later parts hide completely, or except for slivers due to rounding, are not checked.
void require_edges(const Assembly& assembly, const std::vector<BoundaryEdge>& boundary, const Loads& loads,
                   const Particles& particles);

}  // namespace vug
