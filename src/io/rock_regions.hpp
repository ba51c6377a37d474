#pragma once
// Which triangles belong to which material.
#include "dem/assembly.hpp"
#include "io/scene.hpp"

namespace vug {

/// The triangles of a region; `minerals` are those of the case. Throws InputError, beginning with `what`, for a group
/// that the mesh does not have and for a region without triangles.
std::vector<int> triangles_of_region(const RockRegion& region, const std::vector<MineralSection>& minerals,
                                     const std::string& what, const Assembly& assembly);

/// Fills `region` of an assembly: triangles whose centroid is in a form, or those of a mesh's group; where regions
/// overlap, the later one counts. Without regions it stays empty. `path` of the case is for messages.
void assign_regions(const std::vector<RockRegion>& regions, const std::vector<MineralSection>& minerals,
                    const std::string& path, Assembly& assembly);

}  // namespace vug
