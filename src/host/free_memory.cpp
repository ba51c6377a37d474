#include "host/free_memory.hpp"

#include "host/control_groups.hpp"
#include "host/this_process.hpp"

#include <array>
#include <cstdio>
#include <fstream>
#include <limits>
#include <sstream>
#include <sys/resource.h>
#include <unistd.h>

namespace vug {
namespace {

constexpr double unlimited = std::numeric_limits<double>::infinity();

/// Number in a file that contains nothing else; infinite if it is none ("max").
double number_in(const std::string& path) {
  double value = unlimited;
  std::ifstream(path) >> value;
  return value > 0 ? value : unlimited;
}

/// The number after a name in a file of lines "name number"; 0 if there is none.
double entry(const std::string& path, const std::string& name) {
  std::ifstream file(path);
  std::string line, found;
  while (std::getline(file, line)) {
    std::istringstream words(line);
    double value = 0;
    if (words >> found >> value && found == name) return value;
  }
  return 0;
}

/// Free memory in one control group. `limit`, `use` and `cache` are the names that this version of control groups has
/// for the limit, the use and the entry of caches that can be dropped.
double free_in_group(const std::string& folder, const char* limit, const char* use, const char* cache) {
  const double most = number_in(folder + "/" + limit), used = number_in(folder + "/" + use);
  if (most == unlimited || used == unlimited) return unlimited;
  return most - used + entry(folder + "/memory.stat", cache);
}

/// The least free memory over the groups from that of this process up to the root, in either version of control groups.
double free_in_groups() {
  double least = unlimited;
  for (const auto& [folder, unified] : control_groups("memory")) {
    const double found =
        unified ? free_in_group(folder, "memory.max", "memory.current", "inactive_file")
                : free_in_group(folder, "memory.limit_in_bytes", "memory.usage_in_bytes", "total_inactive_file");
    if (found < least) least = found;
  }
  return least;
}

/// Memory that a limit of this process leaves when it already holds the given number of pages.
double under_limit(int resource, double pages) {
  rlimit limit{};
  if (getrlimit(resource, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY) return unlimited;
  return static_cast<double>(limit.rlim_cur) - pages * static_cast<double>(sysconf(_SC_PAGESIZE));
}

std::string readable(double bytes) {
  constexpr std::array units{"B", "KiB", "MiB", "GiB", "TiB", "PiB"};
  std::size_t unit = 0;
  for (; bytes >= 1024 && unit + 1 < units.size(); ++unit) bytes /= 1024;
  char text[40];
  std::snprintf(text, sizeof text, "%.3g %s", bytes > 0 ? bytes : 0, units[unit]);
  return text;
}

}  // namespace

FreeMemory free_memory() {
  FreeMemory least{unlimited, ""};
  const auto bound = [&](double bytes, const char* by) {
    if (bytes < least.bytes) least = {bytes, by};
  };
  if (const double available = entry("/proc/meminfo", "MemAvailable:"); available > 0)
    bound(1024 * (available + entry("/proc/meminfo", "SwapFree:")), "the machine");
  bound(free_in_groups(), "the control group");
  double size = 0, ignored = 0, data = 0;  // pages
  if (std::ifstream("/proc/self/statm") >> size >> ignored >> ignored >> ignored >> ignored >> data) {
    bound(under_limit(RLIMIT_AS, size), "ulimit -v");
    bound(under_limit(RLIMIT_DATA, data), "ulimit -d");
  }
  return least;
}

std::string memory_taken() {
  const FreeMemory free = free_memory();
  const std::string taken = readable(static_cast<double>(peak_memory_bytes())) + " had been taken";
  return free.bytes < unlimited ? taken + "; that given back, " + free.bound_by + " leaves " + readable(free.bytes)
                                : taken;
}

void require_memory(double bytes, const std::string& what) {
  const FreeMemory free = free_memory();
  if (bytes <= free.bytes) return;
  refuse_memory(bytes, what, free.bound_by + " leaves " + readable(free.bytes));
}

void refuse_memory(double bytes, const std::string& what, const std::string& reason) {
  throw MemoryError(what + " needs " + readable(bytes) + " of memory at least, and " + reason);
}

}  // namespace vug
