#pragma once
// Timing against the machine's own limit: every repetition times the kernel and a bare copy of the same number of
// streams in turn, so that a ratio is of the same seconds of a noisy machine.
#include "kernels/launch.hpp"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <vector>

namespace vug::perf {

/// a(stream, i) = -a(stream, i): reads and writes each stream once, in place.
template <class T, int streams>
struct InPlaceCopy {
  ScalarField<T> a;
  int capacity;
  KOKKOS_FORCEINLINE_FUNCTION void operator()(int i) const {
    for (int s = 0; s < streams; ++s) a(s * capacity + i) = -a(s * capacity + i);
  }
};

inline double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

/// Seconds of one call, device included.
template <class Call>
double seconds(const Call& call) {
  Kokkos::fence();
  const Kokkos::Timer timer;
  call();
  Kokkos::fence();
  return timer.seconds();
}

/// Runs `step` (one update of `nodes` nodes) in batches beside a copy of `streams` streams of T, and reports
/// MLUPS and its median, bytes moved per node as stated, GB/s of them, and the share of the copy's rate of updates.
template <class T, int streams, class Step>
void measure(benchmark::State& state, int nodes, double bytes_per_node, const Step& step) {
  const int capacity = (nodes + 15) / 16 * 16;
  const InPlaceCopy<T, streams> copy{ScalarField<T>("copy", static_cast<std::size_t>(streams) * capacity), capacity};
  const int batch = std::clamp(20'000'000 / std::max(nodes, 1), 2, 1000) / 2 * 2;  // some 50 ms on a few cores
  std::vector<double> kernel_times, copy_times;
  step();  // first touch
  for (auto _ : state) {
    kernel_times.push_back(seconds([&] {
      for (int k = 0; k < batch; ++k) step();
    }));
    copy_times.push_back(seconds([&] {
      for (int k = 0; k < batch; ++k) for_each_node(Exec{}, "vug::perf::copy", nodes, copy);
    }));
    state.SetIterationTime(kernel_times.back());
  }
  const double updates = static_cast<double>(nodes) * batch, kernel = median(kernel_times), bare = median(copy_times);
  state.counters["nodes"] = nodes;
  state.counters["MLUPS"] = updates / kernel / 1e6;
  state.counters["bytes_per_node"] = bytes_per_node;
  state.counters["GB_per_s"] = updates * bytes_per_node / kernel / 1e9;
  state.counters["copy_MLUPS"] = updates / bare / 1e6;
  state.counters["of_copy"] = bare / kernel;
}

}  // namespace vug::perf
