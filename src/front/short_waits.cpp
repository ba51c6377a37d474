#include "front/short_waits.hpp"

#include "host/this_process.hpp"

#include <cstdlib>
#include <filesystem>
#include <unistd.h>

namespace vug {

void wait_briefly(char** argv) {
  if (std::getenv("GOMP_SPINCOUNT") || std::getenv("OMP_WAIT_POLICY")) return;
  try {
    const std::string program = this_program();
    ::setenv("KMP_BLOCKTIME", "1", 0);
    if (::setenv("GOMP_SPINCOUNT", "10000", 0) == 0) ::execv(program.c_str(), argv);
  } catch (const std::filesystem::filesystem_error&) {
    return;  // the path is unknown: continue as it is
  }
}

}  // namespace vug
