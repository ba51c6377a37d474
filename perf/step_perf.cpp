// The whole coupled step of the paper's rock, by its parts, each beside the time that its bytes take in a copy. Every
// step of a cycle (of looks for new pores, of longer steps of heat, of looks at resting rock) is timed by itself and
// its median counts, the copy's likewise; on a GPU, whose parts are timed by waiting for each kernel, a whole step is
// one among many without waits. An event of new pores, which is in no step of a cycle, is timed apart.
#include "coupling/simulation.hpp"
#include "host/memory.hpp"
#include "host/subnormals.hpp"
#include "measure.hpp"
#include "step_lines.hpp"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <numeric>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

using namespace vug;
using namespace vug::perf;

/// Seconds for a byte in a copy as large as the case, so that both have the same caches.
class Copy {
 public:
  explicit Copy(double bytes) : capacity_(static_cast<int>(bytes / (streams * sizeof(double)))) { seconds_per_byte(); }
  double seconds_per_byte() const {
    constexpr int repeats = 1;
    const double time = seconds([&] {
      for (int k = 0; k < repeats; ++k) for_each_node(Exec{}, "vug::perf::copy", capacity_, copy_);
    });
    return time / (repeats * 2.0 * streams * sizeof(double) * capacity_);
  }

 private:
  static constexpr int streams = 9;
  int capacity_;
  InPlaceCopy<double, streams> copy_{ScalarField<double>("copy", static_cast<std::size_t>(streams) * capacity_),
                                     capacity_};
};

/// The median times of every step of a cycle, whole and by parts.
class Cycle {
 public:
  explicit Cycle(int length) : whole_(length), parts_(length) {}
  void time(Simulation& simulation) {
    const auto at = static_cast<std::size_t>(simulation.clock().step) % whole_.size();
    const PartClock clock;  // some ten nanoseconds per kernel
    whole_[at].push_back(seconds([&] { simulation.step(); }));
    for (std::size_t p = 0; p < part_count; ++p) {
      parts_[at][p].push_back(clock[static_cast<int>(p)].seconds);
      launches_[p] += clock[static_cast<int>(p)].launches;
    }
    ++steps_;
  }
  /// Means over the cycle, s.
  double whole() const {
    double sum = 0;
    for (const auto& times : whole_) sum += median(times);
    return sum / static_cast<double>(whole_.size());
  }
  double part(std::size_t p) const {
    double sum = 0;
    for (const auto& parts : parts_) sum += median(parts[p]);
    return sum / static_cast<double>(parts_.size());
  }
  double launches(std::size_t p) const { return launches_[p] / steps_; }

 private:
  std::vector<std::vector<double>> whole_;
  std::vector<std::array<std::vector<double>, part_count>> parts_;
  std::array<double, part_count> launches_{};
  double steps_ = 0;
};

/// Seconds of a step among `steps` that nobody looks at, and until the host has sent it: a GPU is sent the next while
/// it works at one.
struct Unwatched {
  double sent, done;
};
Unwatched unwatched_step(Simulation& simulation, int steps) {
  double sent = 0;
  const double done = seconds([&] {
    const Kokkos::Timer timer;
    for (int k = 0; k < steps; ++k) simulation.step();
    sent = timer.seconds();
  });
  return {sent / steps, done / steps};
}

/// Seconds that an event of new pores takes: `interval` steps in which a node dissolves, less as many in which none
/// does.
double birth_seconds(Simulation& simulation, int interval) {
  constexpr int events = 9;
  const Geometry& geometry = simulation.parts().geometry;
  const auto steps = [&] {
    return seconds([&] {
      for (int k = 0; k < interval; ++k) simulation.step();
    });
  };
  std::vector<double> extra;
  for (int event = 0; event < events; ++event) {
    const double without = steps();
    int node = 0;
    Kokkos::deep_copy(node, Kokkos::subview(geometry.surface.node, geometry.surface.count / events * event));
    Kokkos::deep_copy(Kokkos::subview(geometry.volume, node), 0.0);
    const int before = geometry.fluid.count;
    extra.push_back(steps() - without);
    if (geometry.fluid.count == before) throw std::runtime_error("no pore was born");
  }
  return median(extra);
}

struct Choice {
  const char* name;
  std::vector<std::string> overrides;
  bool of_coarse = true;  ///< makes sense on the coarse lattice, too
};

/// A preset with the intervals that scripts/paper/compute.py (FULL_SIZE) takes at full size, where a step is 25 times
/// shorter than on the coarse lattice for which presets are made.
Choice of_full_size(const char* name, const char* preset) {
  return {name,
          {preset, "accuracy.heat_interval=7", "accuracy.solute_interval=4", "accuracy.exchange_interval=16",
           "accuracy.wall_interval=400", "accuracy.update_interval=80", "mechanics.mass_scaling=4.1"},
          false};
}

void step(benchmark::State& state, const char* path, const Choice& choice) {
  std::vector<std::string> overrides = choice.overrides;
  // a step takes as long in rock that is not yet at rest, unless it may sleep
  if (read_scene(path, overrides).mechanics->parameters.rest_tolerance == 0)
    overrides.push_back("mechanics.preload_time=1e-6");
  const Scene scene = read_scene(path, overrides);
  const double before = allocated_bytes();
  Simulation simulation(scene);
  const double held = allocated_bytes() - before;
  simulation.begin();
  Sizes sizes = sizes_of(simulation);
  const Copy copy(held);
  const AccuracySection& accuracy = scene.accuracy;
  constexpr int streaming = 2;  // in place: two kinds of step in turn
  int length = scene.mechanics->parameters.rest_tolerance > 0 ? steps_between_looks : streaming;
  for (const int interval : {accuracy.update_interval, accuracy.wall_interval, accuracy.heat_interval,
                             accuracy.solute_interval, accuracy.exchange_interval})
    length = std::lcm(length, interval);
  const int batch = std::max(length, (sizes.nodes > 1e6 ? 20 : 100) / length * length);
  // until the walls, which are renewed sooner at the start of a run, keep to their interval
  for (int k = 0; k < std::max(20, 8 * accuracy.wall_interval); ++k) simulation.step();
  Cycle cycle(length);
  std::vector<double> byte_times, awake, whole, sent;
  for (auto _ : state) {
    for (int k = 0; k < batch; ++k) {
      if (k % (batch / 20) == 0) {
        byte_times.push_back(copy.seconds_per_byte());
        awake.push_back(simulation.parts().mechanics->awake_share());
      }
      cycle.time(simulation);
    }
    if constexpr (runs_on_host) {
      whole.push_back(cycle.whole());
    } else {
      const Unwatched step = unwatched_step(simulation, batch);
      whole.push_back(step.done);
      sent.push_back(step.sent);
    }
    state.SetIterationTime(whole.back());
  }
  const double step_seconds = runs_on_host ? cycle.whole() : median(whole);
  const double byte_time = median(byte_times);
  while (simulation.clock().step % accuracy.update_interval != 0) simulation.step();
  state.counters["birth_ms"] = 1e3 * birth_seconds(simulation, accuracy.update_interval);
  sizes.awake = std::accumulate(awake.begin(), awake.end(), 0.0) / static_cast<double>(awake.size());
  state.counters["awake"] = sizes.awake;
  const auto bytes = bytes_of(scene, sizes);
  const auto lines = lines_of(scene, sizes, simulation.parts().geometry, bytes);
  double limit = 0, known = 0;
  for (std::size_t p = 0; p < part_count; ++p) {
    const std::string name = part_names[p];
    const double time = cycle.part(p);
    state.counters[name + "_ms"] = 1e3 * time;
    state.counters[name + "_limit_ms"] = 1e3 * bytes[p] * byte_time;
    if (lines[p] > 0) state.counters[name + "_lines_ms"] = 1e3 * lines[p] * byte_time;
    state.counters[name + "_launches"] = cycle.launches(p);
    limit += bytes[p] * byte_time;
    known += time;
  }
  state.counters["step_ms"] = 1e3 * step_seconds;
  if (!sent.empty()) state.counters["sent_ms"] = 1e3 * median(sent);
  state.counters["parts_ms"] = 1e3 * known;
  state.counters["limit_ms"] = 1e3 * limit;
  state.counters["of_limit"] = limit / step_seconds;
  state.counters["copy_GB_per_s"] = 1e-9 / byte_time;
  state.counters["host_threads"] = Exec().concurrency();
  state.counters["nodes"] = sizes.nodes;
  state.counters["fluid_nodes"] = sizes.fluid;
  state.counters["particles"] = sizes.particles;
  state.counters["surface_nodes"] = sizes.surface;
  state.counters["wall_links"] = sizes.links9;
  state.counters["bonds"] = sizes.bonds;
  state.counters["substeps"] = sizes.substeps;
  state.counters["steps_of_condition"] = *scene.time.end / scene.lattice.time_step;
  state.counters["held_MiB"] = held / 1048576;
}

constexpr int repetitions = 9;
const char* const full = "cases/acid_fracturing/p20_da1.5e-3.toml";
const char* const coarse = "cases/acid_fracturing/coarse/p20_da1.5e-3.toml";
const Choice choices[] = {
    {"reference", {"accuracy.preset=reference"}},
    {"careful", {"accuracy.preset=careful"}},
    {"balanced", {"accuracy.preset=balanced"}},
    {"balanced_single", {"accuracy.preset=balanced", "accuracy.precision=single"}},
    {"fast", {"accuracy.preset=fast"}},
    of_full_size("balanced_long_intervals", "accuracy.preset=balanced"),
    of_full_size("fast_long_intervals", "accuracy.preset=fast"),
};

}  // namespace

int main(int argc, char** argv) {
  vug::watch_allocations();
  Kokkos::ScopeGuard kokkos(argc, argv);
  vug::flush_subnormals();
  for (const Choice& choice : choices) {
    for (const auto& [lattice, path] : {std::pair{"coarse", coarse}, {"full", full}}) {
      if (path == coarse && !choice.of_coarse) continue;
      benchmark::RegisterBenchmark((std::string(lattice) + "/" + choice.name).c_str(), step, path, choice)
          ->UseManualTime()
          ->Iterations(repetitions)
          ->Unit(benchmark::kMillisecond);
    }
  }
  benchmark::Initialize(&argc, argv);
  benchmark::AddCustomContext("back end", Exec::name());
  benchmark::AddCustomContext("concurrency", std::to_string(Exec().concurrency()));
  benchmark::RunSpecifiedBenchmarks();
}
