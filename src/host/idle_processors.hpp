#pragma once
// How many processors have nothing to do. Threads that wait for each other at the end of every kernel lose more than a
// processor shared with another program has to give: one thread is then faster than two.
#include <string_view>
#include <vector>

namespace vug {

/// Of one processor since the system began, in its ticks.
struct ProcessorTime {
  int processor = 0;
  long long idle = 0, all = 0;
};

/// The lines "cpuN user nice system idle iowait ..." of /proc/stat; waiting for a disk counts as idle.
std::vector<ProcessorTime> read_processor_times(std::string_view stat);

/// Threads that find a processor each: of every processor the share of its time that was idle, added up and rounded, a
/// processor busy for less than two fifths counting as idle; at least 1. Both lists have the same processors.
int idle_processors(const std::vector<ProcessorTime>& before, const std::vector<ProcessorTime>& after);

/// The same of the processors that this process may use, watched for `seconds`; 0 where the system does not tell.
int idle_processors(double seconds);

}  // namespace vug
