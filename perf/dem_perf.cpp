// Bond-steps per second of the bonded triangles: intact rock under load, and rock whose bonds have all failed.
#include "dem/mechanics.hpp"

#include <benchmark/benchmark.h>

#include <cmath>

namespace {

using namespace vug;

/// A square of 2 n^2 right triangles with edges of 2 mm.
Assembly square(int n) {
  Assembly out;
  for (int y = 0; y <= n; ++y) {
    for (int x = 0; x <= n; ++x) out.vertices.push_back({2e-3 * x, 2e-3 * y});
  }
  for (int y = 0; y < n; ++y) {
    for (int x = 0; x < n; ++x) {
      const int v = y * (n + 1) + x;
      out.triangles.push_back({v, v + 1, v + n + 2});
      out.triangles.push_back({v, v + n + 2, v + n + 1});
    }
  }
  return out;
}

void advance(benchmark::State& state, double chemical_damage) {
  Loads loads;
  loads.support[static_cast<std::size_t>(RockSide::left)] = Support::roller;
  loads.support[static_cast<std::size_t>(RockSide::bottom)] = Support::roller;
  loads.traction[static_cast<std::size_t>(RockSide::right)] = {-5e6, 0};
  Mechanics rock(square(static_cast<int>(state.range(0))), {}, loads);
  Kokkos::deep_copy(rock.bonds().d_c, chemical_damage);
  const Exec exec;
  const double dt = 0.3 * rock.critical_step();
  constexpr int substeps = 35;
  rock.advance(exec, dt, substeps);
  exec.fence();
  for (auto _ : state) {
    rock.advance(exec, dt, substeps);
    exec.fence();
  }
  const double steps = static_cast<double>(state.iterations()) * substeps;
  state.counters["bond_steps/s"] = benchmark::Counter(steps * rock.bonds().count, benchmark::Counter::kIsRate);
  state.counters["particle_steps/s"] = benchmark::Counter(steps * rock.particles().count, benchmark::Counter::kIsRate);
  state.counters["bonds"] = rock.bonds().count;
}

void intact(benchmark::State& state) {
  advance(state, 0);
}
void crumbled(benchmark::State& state) {
  advance(state, 1);
}

BENCHMARK(intact)->Arg(5)->Arg(15)->Arg(50)->Arg(250)->Unit(benchmark::kMicrosecond)->UseRealTime();
BENCHMARK(crumbled)->Arg(15)->Arg(50)->Unit(benchmark::kMicrosecond)->UseRealTime();

}  // namespace

int main(int argc, char** argv) {
  Kokkos::ScopeGuard kokkos(argc, argv);
  benchmark::Initialize(&argc, argv);
  benchmark::AddCustomContext("execution space", Exec::name());
  benchmark::AddCustomContext("concurrency", std::to_string(Exec().concurrency()));
  benchmark::RunSpecifiedBenchmarks();
}
