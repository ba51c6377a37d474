#include "front/short_waits.hpp"

#include <cstdlib>
#include <filesystem>
#include <unistd.h>

namespace vug {

void wait_briefly(char** argv) {
  if (std::getenv("GOMP_SPINCOUNT") || std::getenv("OMP_WAIT_POLICY")) return;
  std::error_code unknown;
  const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe", unknown);
  if (!unknown && ::setenv("GOMP_SPINCOUNT", "10000", 0) == 0) ::execv(program.c_str(), argv);
}

}  // namespace vug
