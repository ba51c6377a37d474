#pragma once
// Number of threads of a run, decided before Kokkos starts: Kokkos aborts or hangs if it is told another number than
// OpenMP provides.
#include <string>

namespace vug {

/// Largest number of threads for which Kokkos's OpenMP back end has room (OpenMPTraits::MAX_THREAD_COUNT); it does not
/// check this.
inline constexpr int most_threads = 512;

struct ThreadChoice {
  int count = 0;       ///< 0: the back end has no threads on the host
  std::string remark;  ///< why there are fewer than requested, or that they have too few processors; else empty
};

/// Chooses `wanted` threads, or for 0 what KOKKOS_NUM_THREADS, OMP_NUM_THREADS or the number of processors says, as far
/// as OpenMP grants them, and passes the number to OpenMP. Where nothing is specified and `looks_around` is set,
/// there are no more than the control groups of the process grant (control_groups.hpp), and processors that other
/// programs keep busy are left to them (idle_processors.hpp). Where `sharing` processes were started together and may
/// use the same processors, each takes its part of them. Throws InputError when a variable of Kokkos's environment is
/// not what Kokkos can read, or when the system refuses the threads. Called once, before Kokkos starts.
ThreadChoice choose_threads(int wanted, bool looks_around = false, int sharing = 1);

}  // namespace vug
