// Speed of every lattice kernel beside the machine's copy bandwidth. Each family registers its own benchmarks.
#include "base/base.hpp"
#include "host/memory.hpp"

#include <benchmark/benchmark.h>

int main(int argc, char** argv) {
  Kokkos::ScopeGuard kokkos(argc, argv);
  vug::watch_allocations();  // as vug itself: large fields in large pages
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  benchmark::AddCustomContext("back end", vug::Exec::name());
  benchmark::AddCustomContext("concurrency", std::to_string(vug::Exec().concurrency()));
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
}
