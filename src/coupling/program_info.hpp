#pragma once
// What the program knows about itself: version, compiler, device.
#include <string>

namespace vug {

/// Written to run.json and printed by `vug info`.
struct BuildInfo {
  std::string version, commit, compiler, backend, device;
  int threads = 1;
};
BuildInfo build_info();

/// "vug 0.1.0 (commit c924984, OpenMP)"; Kokkos need not have been started.
std::string version_line();

}  // namespace vug
