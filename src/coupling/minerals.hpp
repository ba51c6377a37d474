#pragma once
// Which mineral each node of the rock is.
#include "dem/assembly.hpp"
#include "io/scene.hpp"
#include "kernels/base/lattice.hpp"

#include <cstdint>
#include <vector>

namespace vug {

/// The triangle of each node of a rock, -1 where there is none (row by row, without halo).
struct TriangleOfNodes {
  const Assembly& assembly;
  const std::vector<int>& owner;
};

/// Number of the mineral of each node, from 1 in the order of the case; 0 is rock that no mineral holds, and what is
/// not `solid` (row by row, without halo). Empty when the case has no minerals. `of_label` is what a label map says,
/// empty for other geometries; `triangles` is null where there are none. Throws InputError when no solid node is left
/// to a mineral.
std::vector<std::uint8_t> mineral_of_nodes(const Scene& scene, const std::vector<bool>& solid,
                                           std::vector<std::uint8_t> of_label, const TriangleOfNodes* triangles);

/// The same on the device, 0 in the halo; empty where `mineral` is.
Kokkos::View<std::uint8_t*> mineral_field(const Lattice& lattice, const std::vector<std::uint8_t>& mineral);

/// Names by number: "rock", then those of the case.
std::vector<std::string> mineral_names(const Scene& scene);

}  // namespace vug
