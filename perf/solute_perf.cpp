// Speed of the solute kernels in rock of the paper's kind (pathways three nodes wide along the edges of triangles, 15 %
// fluid) and in an open box: million node updates a second and bytes per node.
#include "kernels/advective_form.hpp"
#include "kernels/launch.hpp"
#include "kernels/reactive_wall_kernel.hpp"
#include "kernels/solute.hpp"
#include "kernels/surface_normal.hpp"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace {

using namespace vug;

/// Strips three nodes wide along a share of the edges of a jittered triangulation of pitch 40.
std::vector<char> rock(int nx, int ny, double share_of_edges) {
  constexpr int pitch = 40;
  std::mt19937 random(1);
  std::uniform_real_distribution<double> jitter(-0.3, 0.3), chance(0, 1);
  const int mx = nx / pitch + 2, my = ny / pitch + 2;
  std::vector<std::array<double, 2>> point(mx * my);
  for (int j = 0; j < my; ++j)
    for (int i = 0; i < mx; ++i)
      point[j * mx + i] = {(i - 0.5 + jitter(random) + (j % 2) * 0.5) * pitch, (j - 0.5 + jitter(random)) * pitch};
  std::vector<char> solid(static_cast<std::size_t>(nx) * ny, 1);
  const auto open_edge = [&](int a, int b) {
    if (chance(random) > share_of_edges) return;
    const auto [ax, ay] = point[a];
    const double dx = point[b][0] - ax, dy = point[b][1] - ay, length2 = dx * dx + dy * dy;
    for (int y = std::max(0, int(std::min(ay, ay + dy)) - 3); y < std::min(ny, int(std::max(ay, ay + dy)) + 4); ++y)
      for (int x = std::max(0, int(std::min(ax, ax + dx)) - 3); x < std::min(nx, int(std::max(ax, ax + dx)) + 4); ++x) {
        const double s = std::clamp(((x - ax) * dx + (y - ay) * dy) / length2, 0.0, 1.0);
        if (std::hypot(x - ax - s * dx, y - ay - s * dy) <= 1.5) solid[static_cast<std::size_t>(y) * nx + x] = 0;
      }
  };
  for (int j = 0; j + 1 < my; ++j)
    for (int i = 0; i + 1 < mx; ++i) {
      open_edge(j * mx + i, j * mx + i + 1);
      open_edge(j * mx + i, (j + 1) * mx + i);
      open_edge(j * mx + i + 1, (j + 1) * mx + i);
    }
  return solid;
}

enum Geometry : int { open_box = 0, paper_rock = 1 };

template <class T, class Set>
struct Case {
  Exec exec;
  Lattice lattice{2000, 1400};
  Kokkos::View<NodeType*> type{"type", static_cast<std::size_t>(lattice.size())};
  ScalarField<double> V{"V", static_cast<std::size_t>(lattice.size())};
  FluidNodes nodes;
  SoluteFields<T> acid, product;
  VectorField<T> u;
  ScalarField<T> e;
  SoluteParameters parameters = solute_parameters(0.02);

  explicit Case(int geometry) {
    const std::vector<char> solid = geometry == paper_rock ? rock(lattice.nx, lattice.ny, 0.58)
                                                           : std::vector<char>(lattice.nx * std::size_t(lattice.ny), 0);
    const auto type_host = Kokkos::create_mirror_view(type);
    const auto V_host = Kokkos::create_mirror_view(V);
    for (int y = 0; y < lattice.ny; ++y)
      for (int x = 0; x < lattice.nx; ++x) {
        const bool is_solid = solid[static_cast<std::size_t>(y) * lattice.nx + x];
        type_host(lattice.node(x, y)) = is_solid ? NodeType::solid : NodeType::fluid;
        V_host(lattice.node(x, y)) = is_solid;
      }
    Kokkos::deep_copy(type, type_host);
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

struct UniformTemperature {
  ScalarField<double> T;
  KOKKOS_FUNCTION double operator()(int solid, int fluid) const { return 0.5 * (T(solid) + T(fluid)); }
};

/// Per fluid node, so that it compares with the sweeps: the wall's kernel runs on the surface nodes only.
template <class T, class Set>
void react(benchmark::State& state) {
  Case<T, Set> c(paper_rock);
  const bool arrhenius_law = state.range(0) == 1;
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
  for (auto _ : state) {
    if (arrhenius_law)
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
    ->ArgName("arrhenius")
    ->Arg(0)
    ->Arg(1)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK_TEMPLATE(react, float, D2Q5)
    ->ArgName("arrhenius")
    ->Arg(0)
    ->Arg(1)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK_TEMPLATE(react, double, D2Q9)
    ->ArgName("arrhenius")
    ->Arg(0)
    ->Arg(1)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

}  // namespace

int main(int argc, char** argv) {
  Kokkos::ScopeGuard kokkos(argc, argv);
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
