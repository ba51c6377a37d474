#include "host/openmp_places.hpp"

#include <sched.h>
#include <vector>

#if defined(_OPENMP)
#include <omp.h>
#endif

namespace vug {

void leave_openmp_place() {
#if defined(_OPENMP)
  cpu_set_t all;
  CPU_ZERO(&all);
  for (int place = 0; place < omp_get_num_places(); ++place) {
    std::vector<int> processors(static_cast<std::size_t>(omp_get_place_num_procs(place)));
    omp_get_place_proc_ids(place, processors.data());
    for (const int processor : processors) CPU_SET(processor, &all);
  }
  if (CPU_COUNT(&all) > 0) ::sched_setaffinity(0, sizeof all, &all);
#endif
}

}  // namespace vug
