#pragma once
// Whether the triangles resolve what breaks, and the lattice the triangles.
#include "coupling/limits.hpp"
#include "dem/mechanics.hpp"
#include "io/scene.hpp"

#include <optional>
#include <string>
#include <vector>

namespace vug {

/// Mean edge of the bonds against the length over which cracks soften, of the material where it is shortest. `spacing`:
/// of the lattice, m, which finer triangles may ask to be finer; 0 where there is none.
Limit limit_of_edges(const Mechanics& rock, double spacing);

/// Remarks on notches of rock that was read from a mesh (io/notch_remarks.hpp); of generated rock the reader makes
/// them.
std::vector<std::string> remarks_on_notches_of_mesh(const Scene& scene, const Assembly& rock);

/// A remark where the smallest triangle is smaller than an equilateral one with edges of four cells, generated or read.
std::optional<std::string> remark_on_triangles(const Assembly& rock, double spacing);

}  // namespace vug
