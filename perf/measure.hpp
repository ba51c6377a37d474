#pragma once
// Timing against the machine's own limit: every repetition times the kernel and a bare copy of the same number of
// streams in turn, so that a ratio is of the same seconds of a noisy machine.
#include "kernels/launch/launch.hpp"
#include "kernels/nodes/source_windows.hpp"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <string>
#include <type_traits>
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

/// Bytes of the indices by which a node of the fluid list pulls `directions` moving directions.
constexpr double index_bytes(int directions) {
  return directions * (has_source_windows ? double(sizeof(SourceWindow)) / nodes_per_window : double(sizeof(int)));
}

/// Calls per timing: some 50 ms on a few cores, 10 ms on a GPU; even, because steps in place come in pairs.
inline int batch_of(int nodes) {
  return std::clamp((runs_on_host ? 20'000'000 : 200'000'000) / std::max(nodes, 1), 2, 1000) / 2 * 2;
}

/// Nothing to compare with.
struct NoRival {};

/// Runs `step` (one update of `nodes` nodes) in batches beside a copy of `streams` streams of T, and reports
/// MLUPS and its median, bytes moved per node as stated, GB/s of them, and the share of the copy's rate of updates.
/// With a `rival`, another step over the same nodes in turn with them: the rate over the rival's.
template <class T, int streams, class Step, class Rival = NoRival>
void measure(benchmark::State& state, int nodes, double bytes_per_node, const Step& step, const Rival& rival = {}) {
  constexpr bool has_rival = !std::is_same_v<Rival, NoRival>;
  const int capacity = (nodes + 15) / 16 * 16;
  const InPlaceCopy<T, streams> copy{ScalarField<T>("copy", static_cast<std::size_t>(streams) * capacity), capacity};
  const int batch = batch_of(nodes);
  const auto time = [&](const auto& call) {
    return seconds([&] {
      for (int k = 0; k < batch; ++k) call();
    });
  };
  std::vector<double> kernel_times, copy_times, rival_times;
  step();  // first touch
  for (auto _ : state) {
    kernel_times.push_back(time(step));
    copy_times.push_back(time([&] { for_each_node(Exec{}, "vug::perf::copy", nodes, copy); }));
    if constexpr (has_rival) rival_times.push_back(time(rival));
    state.SetIterationTime(kernel_times.back());
  }
  const double updates = static_cast<double>(nodes) * batch, kernel = median(kernel_times), bare = median(copy_times);
  state.counters["nodes"] = nodes;
  state.counters["MLUPS"] = updates / kernel / 1e6;
  state.counters["bytes_per_node"] = bytes_per_node;
  state.counters["GB_per_s"] = updates * bytes_per_node / kernel / 1e9;
  state.counters["copy_MLUPS"] = updates / bare / 1e6;
  state.counters["of_copy"] = bare / kernel;
  if constexpr (has_rival) state.counters["of_hand_written"] = median(rival_times) / kernel;
}

/// Registers a benchmark timed by `measure`: medians of seven.
template <class Function, class... Arguments>
void add(const std::string& name, Function function, Arguments... arguments) {
  benchmark::RegisterBenchmark(name.c_str(), function, arguments...)
      ->UseManualTime()
      ->Iterations(7)
      ->Unit(benchmark::kMillisecond);
}

}  // namespace vug::perf
