#pragma once
// Time for which threads that have nothing to do stay awake.

namespace vug {

/// Restarts the program in the same process with GOMP_SPINCOUNT=10000, unless that or OMP_WAIT_POLICY is set, because
/// GCC's OpenMP reads the variable when it is loaded. The threads of a run meet some twenty times in a step. By default
/// OpenMP lets them wait awake for milliseconds, on a processor that the last of them may be waiting for: where five
/// other programs ran, two threads were four to sixteen times slower than one, and with this setting two to seven
/// times. Ten thousand spins are enough for the gaps within a step: on idle processors nothing is lost (with a thousand
/// some 5 %, with none a factor of four). Returns where nothing is to be changed, or where the system does not allow
/// it.
void wait_briefly(char** argv);

}  // namespace vug
