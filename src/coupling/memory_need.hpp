#pragma once
// How much memory a case takes at least, known before it is taken.
#include "io/scene.hpp"

#include <cstdint>

namespace vug {

/// Bytes of what has an entry per node of the lattice.
double bytes_of_lattice(const Scene& scene);

/// Bytes of the generated triangles that cover an area of the rock, m2; 0 for a mesh.
double bytes_of_triangles(const RockSection& rock, double area);

/// Bytes of what has an entry per fluid node, of which there are `count`.
double bytes_of_fluid(const Scene& scene, double count);

/// Throws MemoryError unless the fields of all nodes fit the memory of the kernels, and the triangles that of the host.
void require_memory_of_lattice(const Scene& scene);

/// Throws MemoryError unless the fields of `count` fluid nodes fit the memory of the kernels.
void require_memory_of_fluid(const Scene& scene, std::int64_t count);

}  // namespace vug
