#include "host/work_time.hpp"

#include "base/base.hpp"
#include "host/this_process.hpp"

#include <ctime>

namespace vug {

double work_seconds() {
  Kokkos::fence();
  if (!shares_host_memory) return steady_seconds();
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

}  // namespace vug
