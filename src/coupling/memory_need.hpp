#pragma once
// How much memory a case takes at least, known before it is taken.
#include "io/scene.hpp"

namespace vug {

/// Bytes of what has an entry per node of the lattice, and of the triangles.
double bytes_of_lattice(const Scene& scene);

/// Bytes of the generated triangles that cover an area of the rock, m2; 0 for a mesh.
double bytes_of_triangles(const RockSection& rock, double area);

/// Bytes of what has an entry per fluid node, of which there are `count`.
double bytes_of_fluid(const Scene& scene, double count);

}  // namespace vug
