#pragma once
// How long idle threads stay awake.

namespace vug {

/// Restarts the program in the same process with GOMP_SPINCOUNT=10000, unless that or OMP_WAIT_POLICY is set. GCC's
/// OpenMP reads the variable when it is loaded. The threads of a run synchronise some twenty times in a step. By
/// default OpenMP lets them spin for milliseconds, on a processor for which the last of them may be waiting: beside
/// five other programs two threads were four to sixteen times slower than one, and with this setting two to seven
/// times. Ten thousand spins suffice for the gaps within a step: on idle processors nothing is lost (with a thousand
/// some 5 %, with none a factor of four). Returns if nothing is to be changed, or if the system does not allow it.
void wait_briefly(char** argv);

}  // namespace vug
