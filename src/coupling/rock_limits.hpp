#pragma once
// Whether the triangles resolve what breaks, and the lattice the triangles.
#include "coupling/limits.hpp"
#include "dem/mechanics.hpp"

#include <optional>
#include <string>

namespace vug {

/// Mean edge of the bonds against the length over which cracks soften, of the material where it is shortest.
/// The advice speaks of cells where there are any.
Limit limit_of_edges(const Mechanics& rock, bool on_lattice);

/// A remark where the smallest triangle is smaller than an equilateral one with edges of four cells, generated or read.
std::optional<std::string> remark_on_triangles(const Assembly& rock, double spacing);

}  // namespace vug
