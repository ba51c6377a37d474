#include "host/idle_processors.hpp"

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <string>
#include <thread>

#if defined(__linux__)
#include <sched.h>
#endif

namespace vug {

namespace {

bool may_use(int processor) {
#if defined(__linux__)
  cpu_set_t own;
  if (sched_getaffinity(0, sizeof own, &own) != 0) return true;
  return processor < CPU_SETSIZE && CPU_ISSET(processor, &own);
#else
  (void)processor;
  return true;
#endif
}

std::vector<ProcessorTime> times_now() {
  std::ifstream file("/proc/stat", std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  std::vector<ProcessorTime> times = read_processor_times(text);
  std::erase_if(times, [](const ProcessorTime& time) { return !may_use(time.processor); });
  return times;
}

}  // namespace

std::vector<ProcessorTime> read_processor_times(std::string_view stat) {
  std::vector<ProcessorTime> times;
  while (!stat.empty()) {
    const std::size_t end = std::min(stat.find('\n'), stat.size());
    const std::string line(stat.substr(0, end));
    stat.remove_prefix(std::min(end + 1, stat.size()));
    if (!line.starts_with("cpu") || line.size() < 4 || line[3] < '0' || line[3] > '9') continue;
    char* at = nullptr;
    ProcessorTime time{static_cast<int>(std::strtol(line.c_str() + 3, &at, 10))};
    constexpr int counted = 8;  // up to stolen time; the time of guests is part of user time
    for (int column = 0; column < counted; ++column) {
      const long long ticks = std::strtoll(at, &at, 10);
      time.all += ticks;
      if (column == 3 || column == 4) time.idle += ticks;
    }
    times.push_back(time);
  }
  return times;
}

int idle_processors(const std::vector<ProcessorTime>& before, const std::vector<ProcessorTime>& after) {
  double idle = 0;
  for (std::size_t p = 0; p < std::min(before.size(), after.size()); ++p) {
    const auto all = static_cast<double>(after[p].all - before[p].all);
    idle += all > 0 ? static_cast<double>(after[p].idle - before[p].idle) / all : 1.0;
  }
  return std::max(1, static_cast<int>(idle + 0.4));
}

int idle_processors(double seconds) {
  const std::vector<ProcessorTime> before = times_now();
  if (before.empty()) return 0;
  std::this_thread::sleep_for(std::chrono::duration<double>(seconds));
  return idle_processors(before, times_now());
}

}  // namespace vug
