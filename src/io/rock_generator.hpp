#pragma once
// Generates a triangulated rock from a seed: Poisson-disc points, Delaunay triangles, smoothing.
#include "dem/assembly.hpp"
#include "io/scene.hpp"

namespace vug {

/// Tiles the rectangle [0, length_x] × [0, length_y], less the holes, with triangles of mean edge `rock.element_size`.
/// With `grading` > 1 they grow linearly with the distance from the holes (from the notches where there is none) until
/// the largest is `grading` times the smallest. The sides, rims of holes, borders and notches are edges of the mesh,
/// and have a corner wherever they cross; circles are polygons with their corners on the circle. Notches are listed in
/// initial_cracks; one that ends less than half an element from a side or a hole is extended to it. The same seed gives
/// the same bits on every machine. Every angle is at least 20 degrees and every area at least 0.2 of the mean
/// (0.2 / grading² when graded); where the geometry does not allow that, throws InputError with the place, the shapes
/// there and what to change.
Assembly generate_rock(double length_x, double length_y, const RockSection& rock);

/// The same for a disc, for the Brazilian test, between flats of `flat_width` (over the diameter) for the platens. Its
/// rectangle is [0, diameter] × [0, diameter sqrt(1 - flat_width²)]. Of `rock` only element size and seed are used.
Assembly generate_disc(double diameter, double flat_width, const RockSection& rock);

}  // namespace vug
