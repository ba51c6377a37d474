#include "front/short_waits.hpp"

#include "host/openmp_places.hpp"
#include "host/this_process.hpp"

#include <cstdlib>
#include <exception>
#include <unistd.h>

namespace vug {

void wait_briefly(char** argv) {
  if (std::getenv("GOMP_SPINCOUNT") || std::getenv("OMP_WAIT_POLICY")) return;
  try {
    const std::string program = this_program();
    ::setenv("KMP_BLOCKTIME", "1", 0);
    if (::setenv("GOMP_SPINCOUNT", "10000", 0) != 0) return;
    leave_openmp_place();
    ::execv(program.c_str(), argv);
  } catch (const std::exception&) {
    return;  // the path is unknown, or there is no memory for it: continue as it is
  }
}

}  // namespace vug
