#pragma once
// What a case with a [laboratory] tests, and how.
#include "coupling/limits.hpp"
#include "dem/laboratory.hpp"
#include "dem/quench.hpp"
#include "io/scene.hpp"

namespace vug {

/// The specimen of a case: generated, or read from its mesh.
Assembly build_specimen(const Scene& scene);

/// Throws InputError where a test's platens find no edge of the specimen to hold, or its confinement none to push, where
/// a quenched slab is too low for cracks to be counted, and where a test has more steps than can be counted.
void require_testable(const Scene& scene, const Assembly& specimen, const Mechanics& rock);

/// How long the mechanics of a test takes at most, s.
double longest_test(const Scene& scene, const Assembly& specimen);

/// The time step of a test, how many it takes at most, and whether its triangles resolve what breaks.
LimitTable limits_of_specimen(const Scene& scene, const Assembly& specimen, const Mechanics& rock);

/// The loading test of a case; not for a quench.
PlatenTest platen_test(const Scene& scene, const Assembly& specimen);
QuenchTest quench_test(const Scene& scene);

}  // namespace vug
