#pragma once
// The specimen and the test of a case with a [laboratory].
#include "coupling/limits.hpp"
#include "dem/laboratory.hpp"
#include "dem/quench.hpp"
#include "io/scene.hpp"

namespace vug {

/// The specimen of a case: generated, or read from its mesh.
Assembly build_specimen(const Scene& scene);

/// Gives the bonds of a specimen the chemical damage of its test, on which its critical step depends.
void age_chemically(const Scene& scene, const Mechanics& rock);

/// Throws InputError where the specimen has no edge for the platens to hold or for the confinement to act on, where a
/// quenched slab is too low for counting cracks, and where a test has more steps than a double can count.
void require_testable(const Scene& scene, const Assembly& specimen, const Mechanics& rock);

/// Longest simulated time of a test, s.
double longest_test(const Scene& scene, const Assembly& specimen);

/// Limits of a test: its time step, its number of steps, the mean edge of its triangles and, where they apply, the
/// speed of thermal strain and the width of the flats.
LimitTable limits_of_specimen(const Scene& scene, const Assembly& specimen, const Mechanics& rock);

/// The loading test of a case; not for a quench.
PlatenTest platen_test(const Scene& scene, const Assembly& specimen);
QuenchTest quench_test(const Scene& scene);

}  // namespace vug
