// Speed of the solute kernels in rock of the paper's kind (pathways three nodes wide along the edges of triangles, 15 %
// fluid) and in an open box: million node updates a second and bytes per node.
#include "kernels/advective_form.hpp"
#include "kernels/launch.hpp"
#include "kernels/reactive_wall_kernel.hpp"
#include "kernels/solute.hpp"
#include "kernels/surface_normal.hpp"
#include "rock_geometry.hpp"

#include <benchmark/benchmark.h>

namespace {

using namespace vug;

enum Where : int { open_box = 0, paper_rock = 1 };

template <class T, class Set>
struct Case {
  Exec exec;
  Lattice lattice{2000, 1400};
  Kokkos::View<NodeType*> type;
  ScalarField<double> V{"V", static_cast<std::size_t>(lattice.size())};
  FluidNodes nodes;
  SoluteFields<T> acid, product;
  VectorField<T> u;
  ScalarField<T> e;
  SoluteParameters parameters = solute_parameters(0.02);

  explicit Case(int geometry) {
    type =
        geometry == paper_rock ? perf::node_types(perf::geometries[0], lattice) : perf::node_types({"box", 0}, lattice);
    const auto type_host = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, type);
    const auto V_host = Kokkos::create_mirror_view(V);
    for (int n = 0; n < lattice.size(); ++n) V_host(n) = type_host(n) == NodeType::solid;
    Kokkos::deep_copy(V, V_host);
    nodes = make_fluid_nodes(exec, lattice, type);
    acid = make_solute_fields<T, Set>(exec, nodes, 0.5);
    product = make_solute_fields<T, Set>(exec, nodes, 0.1);
    u = VectorField<T>("u", nodes.capacity);
    Kokkos::deep_copy(u, T(0.001));
    e = ScalarField<T>("e", nodes.capacity);
    advective_defect<Set>(exec, nodes, u, e);
  }
};

void report(benchmark::State& state, double nodes, double bytes) {
  state.counters["MLUPS"] = benchmark::Counter(nodes * 1e-6, benchmark::Counter::kIsIterationInvariantRate);
  state.counters["bytes_per_node"] = bytes;
  state.counters["GB/s"] = benchmark::Counter(nodes * bytes * 1e-9, benchmark::Counter::kIsIterationInvariantRate);
}

template <class T, class Set>
constexpr double sweep_bytes = 2.0 * Set::Q * sizeof(T) + 4.0 * (Set::Q - 1) + sizeof(T);

template <class T, class Set>
void diffuse(benchmark::State& state) {
  Case<T, Set> c(static_cast<int>(state.range(0)));
  for (auto _ : state) {
    advance_solute<Set>(c.exec, c.nodes, c.parameters, c.acid);
    c.exec.fence();
  }
  report(state, c.nodes.count, sweep_bytes<T, Set>);
}

template <class T, class Set>
void advect(benchmark::State& state) {
  Case<T, Set> c(static_cast<int>(state.range(0)));
  for (auto _ : state) {
    advance_solute<Set>(c.exec, c.nodes, c.parameters, c.u, c.acid);
    c.exec.fence();
  }
  report(state, c.nodes.count, sweep_bytes<T, Set> + 2 * sizeof(T));
}

template <class T, class Set>
void advect_in_advective_form(benchmark::State& state) {
  Case<T, Set> c(static_cast<int>(state.range(0)));
  const ScalarField<double> correction("correction", block_count(c.nodes.count));
  for (auto _ : state) {
    advance_solute<Set>(c.exec, c.nodes, c.parameters, c.u, c.e, c.acid, correction);
    c.exec.fence();
  }
  report(state, c.nodes.count, sweep_bytes<T, Set> + 3 * sizeof(T));
}

template <class T, class Set>
void find_defect(benchmark::State& state) {
  Case<T, Set> c(static_cast<int>(state.range(0)));
  for (auto _ : state) {
    advective_defect<Set>(c.exec, c.nodes, c.u, c.e);
    c.exec.fence();
  }
  report(state, c.nodes.count, 3.0 * sizeof(T) + 4.0 * (Set::Q - 1) + 6);
}

enum RateLaw : int { uniform = 0, by_arrhenius = 1, stored = 2 };

struct UniformTemperature {
  ScalarField<double> T;
  KOKKOS_FUNCTION double operator()(int solid, int fluid) const { return 0.5 * (T(solid) + T(fluid)); }
};

/// Per fluid node, so that it compares with the sweeps: the wall's kernel runs on the surface nodes only.
template <class T, class Set>
void react(benchmark::State& state) {
  Case<T, Set> c(paper_rock);
  const auto rate_law = static_cast<RateLaw>(state.range(0));
  Surface surface;
  find_surface(c.exec, c.nodes, c.type, surface);
  VectorField<double> normal;
  find_normals(c.exec, c.nodes, surface, c.V, normal);
  ReactiveWall wall;
  wall.molar_volume = 1e-6;
  wall.inverse_equilibrium = 1e-3;
  const ReactionLedger ledger{c.V,
                              ScalarField<double>("dissolved", c.lattice.size()),
                              ScalarField<double>("consumed", block_count(c.lattice.size())),
                              {}};
  ScalarField<double> temperature("T", c.lattice.size());
  Kokkos::deep_copy(temperature, 350.0);
  const ArrheniusRate<UniformTemperature> hot{1e-9, 7553, 273.15, {temperature}};
  const ScalarField<double> k("k", c.lattice.size());
  store_rates(c.exec, c.nodes, surface, hot, k);
  for (auto _ : state) {
    if (rate_law == stored)
      react_at_wall<Set>(c.exec, c.nodes, surface, wall, StoredRate{k}, normal, c.acid, &c.product, ledger);
    else if (rate_law == by_arrhenius)
      react_at_wall<Set>(c.exec, c.nodes, surface, wall, hot, normal, c.acid, &c.product, ledger);
    else
      react_at_wall<Set>(c.exec, c.nodes, surface, wall, UniformRate{1e-9}, normal, c.acid, &c.product, ledger);
    c.exec.fence();
  }
  state.counters["surface_nodes_per_fluid_node"] = double(surface.count) / c.nodes.count;
  state.counters["fluid_MLUPS"] =
      benchmark::Counter(c.nodes.count * 1e-6, benchmark::Counter::kIsIterationInvariantRate);
}

#define VUG_SWEEP(body)                  \
  BENCHMARK_TEMPLATE(body, double, D2Q5) \
      ->ArgName("rock")                  \
      ->Arg(open_box)                    \
      ->Arg(paper_rock)                  \
      ->Unit(benchmark::kMillisecond)    \
      ->UseRealTime();                   \
  BENCHMARK_TEMPLATE(body, float, D2Q5)  \
      ->ArgName("rock")                  \
      ->Arg(open_box)                    \
      ->Arg(paper_rock)                  \
      ->Unit(benchmark::kMillisecond)    \
      ->UseRealTime();                   \
  BENCHMARK_TEMPLATE(body, double, D2Q9) \
      ->ArgName("rock")                  \
      ->Arg(open_box)                    \
      ->Arg(paper_rock)                  \
      ->Unit(benchmark::kMillisecond)    \
      ->UseRealTime();                   \
  BENCHMARK_TEMPLATE(body, float, D2Q9)  \
      ->ArgName("rock")                  \
      ->Arg(open_box)                    \
      ->Arg(paper_rock)                  \
      ->Unit(benchmark::kMillisecond)    \
      ->UseRealTime()
VUG_SWEEP(diffuse);
VUG_SWEEP(advect);
VUG_SWEEP(advect_in_advective_form);
VUG_SWEEP(find_defect);
BENCHMARK_TEMPLATE(react, double, D2Q5)
    ->ArgName("rate")
    ->Arg(uniform)
    ->Arg(by_arrhenius)
    ->Arg(stored)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK_TEMPLATE(react, float, D2Q5)
    ->ArgName("rate")
    ->Arg(uniform)
    ->Arg(by_arrhenius)
    ->Arg(stored)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK_TEMPLATE(react, double, D2Q9)
    ->ArgName("rate")
    ->Arg(uniform)
    ->Arg(by_arrhenius)
    ->Arg(stored)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

}  // namespace

int main(int argc, char** argv) {
  Kokkos::ScopeGuard kokkos(argc, argv);
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
