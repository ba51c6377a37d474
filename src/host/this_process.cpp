#include "host/this_process.hpp"

#include <chrono>
#include <filesystem>
#include <sys/resource.h>
#include <unistd.h>

namespace vug {

std::string machine_name() {
  char name[256] = "";
  return ::gethostname(name, sizeof(name) - 1) == 0 ? name : "an unnamed host";
}

std::string this_program() {
  return std::filesystem::read_symlink("/proc/self/exe").string();
}

std::int64_t peak_memory_bytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return std::int64_t{1024} * usage.ru_maxrss;
}

double steady_seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}  // namespace vug
