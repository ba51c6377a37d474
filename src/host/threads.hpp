#pragma once
// How many threads a run gets, settled before Kokkos starts: Kokkos ends the program or waits for ever where the number
// it is told is not the number that OpenMP gives it.
#include <string>

namespace vug {

/// The most threads that Kokkos's OpenMP back end has places for (OpenMPTraits::MAX_THREAD_COUNT); it does not check.
inline constexpr int most_threads = 512;

struct ThreadChoice {
  int count = 0;       ///< 0: the back end has no threads on the host
  std::string remark;  ///< why there are fewer than asked for, or that they have too few processors; else empty
};

/// `wanted` threads, or for 0 what KOKKOS_NUM_THREADS, OMP_NUM_THREADS or the processors say, as far as OpenMP grants
/// them, and tells OpenMP so. Where nobody says and `looks_around` is set, processors that other programs keep busy are
/// left to them (idle_processors.hpp); where `sharing` processes were started together and may use the same processors,
/// each takes its part of them. Throws InputError when a variable of Kokkos's environment is not what Kokkos can
/// read, or when the system refuses the threads. Called once, before Kokkos starts.
ThreadChoice choose_threads(int wanted, bool looks_around = false, int sharing = 1);

}  // namespace vug
