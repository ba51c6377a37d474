#pragma once
// Number of idle processors. Threads wait for each other at the end of every kernel: a processor that is shared with
// another program costs them more time than it contributes, so that one thread is then faster than two.
#include <string_view>
#include <vector>

namespace vug {

/// Time of one processor since the system started, in ticks.
struct ProcessorTime {
  int processor = 0;
  long long idle = 0, all = 0;
};

/// The lines "cpuN user nice system idle iowait ..." of /proc/stat; waiting for a disk counts as idle.
std::vector<ProcessorTime> read_processor_times(std::string_view stat);

/// Number of threads that can have a processor each: sum of the idle shares of all processors, rounded up from a
/// fraction of 0.6, else down; at least 1. Both lists have the same processors.
int idle_processors(const std::vector<ProcessorTime>& before, const std::vector<ProcessorTime>& after);

/// The same for the processors that this process may use, measured over `seconds`; 0 where the system does not say.
int idle_processors(double seconds);

}  // namespace vug
