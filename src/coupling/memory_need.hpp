#pragma once
// The least memory that a case takes, computed before it is allocated.
#include "io/scene.hpp"

#include <cstdint>

namespace vug {

/// Bytes of the fields with an entry per node of the lattice.
double bytes_of_lattice(const Scene& scene);

/// Bytes of the generated triangles that cover an area of the rock, m2; 0 for a mesh.
double bytes_of_triangles(const RockSection& rock, double area);

/// Bytes of the fields with an entry per fluid node, for `count` fluid nodes.
double bytes_of_fluid(const Scene& scene, double count);

/// Throws MemoryError unless the fields of all nodes fit into the memory of the kernels, and the triangles into that of
/// the host.
void require_memory_of_lattice(const Scene& scene);

/// Throws MemoryError unless the fields of `count` fluid nodes fit into the memory of the kernels.
void require_memory_of_fluid(const Scene& scene, std::int64_t count);

}  // namespace vug
