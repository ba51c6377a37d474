#pragma once
// How long idle threads stay awake.

namespace vug {

/// Restarts the program in the same process with GOMP_SPINCOUNT=10000, unless that or OMP_WAIT_POLICY is set, and with
/// KMP_BLOCKTIME=1 (ms), unless that is set: GCC's OpenMP reads the first variable when it is loaded, that of LLVM and
/// Intel the second, in whole milliseconds. The threads of a run synchronise some twenty times in a step. By
/// default OpenMP lets them spin for milliseconds, on a processor for which the last of them may be waiting: beside
/// five other programs two threads were four to sixteen times slower than one, and with this setting two to seven
/// times. Ten thousand spins suffice for the gaps within a step: on idle processors nothing is lost (with a thousand
/// some 5 %, with none a factor of four). Returns if nothing is to be changed, or if the system does not allow it.
void wait_briefly(char** argv);

}  // namespace vug
