#pragma once
// The mineral of each node of the rock.
#include "base/lattice.hpp"
#include "dem/assembly.hpp"
#include "io/scene.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace vug {

/// The triangle of each node of the rock (row by row, without halo), -1 where there is none.
struct TriangleOfNodes {
  const Assembly& assembly;
  const std::vector<int>& owner;
};

/// Number of the mineral of each node (row by row, without halo), from 1 in the order of the case. 0 is rock that is no
/// mineral, and nodes that are not `solid`. Empty when the case has no minerals. `of_label` has the numbers from a
/// label map and is empty for other geometries; `triangles` is null where there are none. Throws InputError when a
/// mineral without labels has no solid node.
std::vector<std::uint8_t> mineral_of_nodes(const Scene& scene, const std::vector<bool>& solid,
                                           std::vector<std::uint8_t> of_label, const TriangleOfNodes* triangles);

/// The same on the device, 0 in the halo; empty where `mineral` is.
Kokkos::View<std::uint8_t*> mineral_field(const Lattice& lattice, const std::vector<std::uint8_t>& mineral);

/// A remark for each mineral of labels that no node has.
std::vector<std::string> remarks_on_absent_minerals(const Scene& scene, const Kokkos::View<std::uint8_t*>& field);

/// Names by number: "rock", then those of the case.
std::vector<std::string> mineral_names(const Scene& scene);

}  // namespace vug
