#pragma once
// What every run directory records about its origin.
#include "io/run_record.hpp"
#include "io/scene.hpp"

#include <string>

namespace vug {

/// What a program knows about itself; written to run.json and printed by `vug info`.
struct BuildInfo {
  std::string version, commit, compiler, backend, device;
  int threads = 1;
};
BuildInfo build_info();

/// "vug 0.1.0 (commit c924984, OpenMP)"; Kokkos need not have been started.
std::string version_line();

/// The record of a run of `scene` that begins now; reads the files that the scene names. Throws FileError.
RunRecord first_record(const Scene& scene);

/// `wanted`, or runs/<name of the case file> where it is empty.
std::string run_directory(const Scene& scene, const std::string& wanted);

}  // namespace vug
