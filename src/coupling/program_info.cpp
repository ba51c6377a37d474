#include "coupling/program_info.hpp"

#include "kernels/launch/launch.hpp"

#include <fmt/format.h>

#ifndef VUG_COMMIT
#define VUG_COMMIT "unknown"
#endif

namespace vug {

BuildInfo build_info() {
  BuildInfo info;
  info.version = VUG_VERSION;
  info.commit = VUG_COMMIT;
  info.compiler = VUG_COMPILER;
  info.backend = Exec::name();
  info.threads = Exec().concurrency();
  info.device =
      shares_host_memory ? fmt::format("host, {} threads", info.threads) : std::string(Exec::name()) + " device";
  return info;
}

std::string version_line() {
  return fmt::format("vug {} (commit {}, {})", VUG_VERSION, VUG_COMMIT, Exec::name());
}

}  // namespace vug
