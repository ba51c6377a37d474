// Large rocks: what it takes to build, draw, load and break one. Every stage is reported per triangle, which must not
// grow with the number of triangles.
#include "coupling/rock.hpp"
#include "dem/edges.hpp"
#include "dem/mechanics.hpp"
#include "host/memory.hpp"
#include "io/mesh_reader.hpp"
#include "io/rock_generator.hpp"
#include "measure.hpp"

#include <benchmark/benchmark.h>

#include <cmath>
#include <memory>
#include <string>

namespace {

using namespace vug;
using perf::seconds;

constexpr double width = 0.1, height = 0.07;  // m, the paper's rock

/// The paper's rock on its lattice, with about that many triangles.
Scene scene_of(double triangles) {
  Scene scene;
  scene.lattice = {width, height, 5e-5, 1e-7, 2000, 1400};
  scene.rock.emplace();
  scene.rock->element_size = std::sqrt(width * height / triangles * 4 / std::sqrt(3.0));
  scene.rock->porosity = 0.15;
  scene.damage.emplace();
  return scene;
}

/// The assembly as a Gmsh file of version 2.2, to a micrometre.
std::string gmsh_text(const Assembly& assembly) {
  std::string text = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n" + std::to_string(assembly.vertices.size()) + "\n";
  for (std::size_t i = 0; i < assembly.vertices.size(); ++i) {
    const auto& [x, y] = assembly.vertices[i];
    text += std::to_string(i + 1) + " " + std::to_string(x) + " " + std::to_string(y) + " 0\n";
  }
  text += "$EndNodes\n$Elements\n" + std::to_string(assembly.triangles.size()) + "\n";
  for (std::size_t k = 0; k < assembly.triangles.size(); ++k) {
    const auto& [a, b, c] = assembly.triangles[k];
    text += std::to_string(k + 1) + " 2 2 1 1 " + std::to_string(a + 1) + " " + std::to_string(b + 1) + " " +
            std::to_string(c + 1) + "\n";
  }
  return text + "$EndElements\n";
}

void large_rock(benchmark::State& state) {
  const Scene scene = scene_of(static_cast<double>(state.range(0)));
  constexpr int steps = 1000;
  for (auto _ : state) {
    Assembly assembly;
    const double generated = seconds([&] { assembly = generate_rock(width, height, *scene.rock); });
    const auto n = static_cast<double>(assembly.triangles.size());
    const std::string text = gmsh_text(assembly);
    const double read = seconds([&] { parse_mesh(text, "rock.msh"); });
    const double sides = seconds([&] { find_boundary(assembly); });
    RockRaster raster;
    const Lattice lattice(scene.lattice.nx, scene.lattice.ny);
    const double drawn = seconds([&] { raster = rasterise(assembly, lattice, scene.lattice.spacing); });
    const double mapped = seconds([&] { build_rock(scene, lattice); });
    Loads loads;
    loads.support = {Support::free, Support::roller, Support::roller, Support::roller};
    loads.velocity[static_cast<std::size_t>(RockSide::top)] = {0, -20};  // breaks what its wave reaches
    const double before = allocated_bytes();
    std::unique_ptr<Mechanics> rock;
    const double built = seconds([&] { rock = std::make_unique<Mechanics>(assembly, MechanicsParameters{}, loads); });
    const double bytes = allocated_bytes() - before;
    const double dt = 0.3 * rock->critical_step();
    const Exec exec;
    const double run = seconds([&] { rock->advance(exec, dt, steps); });
    state.SetIterationTime(run);
    state.counters["triangles"] = n;
    state.counters["bonds"] = rock->bonds().count;
    state.counters["failed"] = rock->bond_counts().failed();
    state.counters["generate_us"] = 1e6 * generated / n;
    state.counters["read_mesh_us"] = 1e6 * read / n;
    state.counters["find_boundary_us"] = 1e6 * sides / n;
    state.counters["draw_us"] = 1e6 * drawn / n;
    state.counters["rock_map_us"] = 1e6 * (mapped - generated) / n;
    state.counters["mechanics_us"] = 1e6 * built / n;
    state.counters["mechanics_bytes"] = bytes / n;
    state.counters["step_ns"] = 1e9 * run / steps / n;
  }
}

BENCHMARK(large_rock)->Arg(6250)->Arg(25000)->Arg(110000)->Iterations(1)->UseManualTime()->Unit(benchmark::kSecond);

}  // namespace

int main(int argc, char** argv) {
  Kokkos::ScopeGuard kokkos(argc, argv);
  watch_allocations();
  benchmark::Initialize(&argc, argv);
  benchmark::AddCustomContext("execution space", Exec::name());
  benchmark::AddCustomContext("concurrency", std::to_string(Exec().concurrency()));
  benchmark::RunSpecifiedBenchmarks();
}
