#pragma once
// Which triangles are of which material.
#include "dem/assembly.hpp"
#include "io/scene.hpp"

namespace vug {

/// The triangles of a region; `minerals` are those of the case. Throws InputError, beginning with `what`, for a group
/// that the mesh does not have and where there are none.
std::vector<int> triangles_of_region(const RockRegion& region, const std::vector<MineralSection>& minerals,
                                     const std::string& what, const Assembly& assembly);

/// Fills `region` of an assembly: triangles whose centroid a form holds, or those of a mesh's group; later regions
/// paint over earlier ones. Without regions it stays empty. `path` of the case is for messages.
void assign_regions(const std::vector<RockRegion>& regions, const std::vector<MineralSection>& minerals,
                    const std::string& path, Assembly& assembly);

}  // namespace vug
