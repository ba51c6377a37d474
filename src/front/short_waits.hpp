#pragma once
// How long threads that have nothing to do stay awake.

namespace vug {

/// Begins the program anew, in its place, with GOMP_SPINCOUNT=10000, unless that or OMP_WAIT_POLICY is set: GCC's
/// OpenMP reads it when it is loaded. The threads of a run meet some twenty times in a step. By itself OpenMP lets them
/// wait awake for milliseconds, on a processor that the last of them may be waiting for: where five other programs ran,
/// two threads were four to sixteen times slower than one, and with this two to seven times. Ten thousand looks are
/// enough for the gaps within a step: on quiet processors nothing is lost (with a thousand some 5 %, with none the
/// fourfold). Returns where nothing is to be changed, or the system does not allow it.
void wait_briefly(char** argv);

}  // namespace vug
