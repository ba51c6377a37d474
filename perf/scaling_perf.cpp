// From the cache to far beyond it: flow, heat and a solute in square boxes, in float and double, by one thread and by
// all, the four in turn, so that their ratios are of the same seconds.
#include "kernels/flow/flow.hpp"
#include "kernels/heat/heat.hpp"
#include "kernels/solute/solute.hpp"
#include "measure.hpp"
#include "rock_geometry.hpp"
#include "support/advance.hpp"
#include "support/set_equilibrium.hpp"

#include <functional>
#include <memory>

namespace vug::perf {
namespace {

/// One thread of the host; the whole device on a GPU.
Exec one_thread() {
#if defined(KOKKOS_ENABLE_OPENMP) && !defined(KOKKOS_ENABLE_CUDA) && !defined(KOKKOS_ENABLE_HIP)
  return Kokkos::OpenMP(1);
#else
  return Exec{};
#endif
}

using Step = std::function<void(const Exec&)>;

FluidNodes open_box(int n) {
  const Lattice lattice(n, n);
  return make_fluid_nodes(Exec{}, lattice, node_types({"box", 0}, lattice));
}

template <class T>
Step flow_step(const FluidNodes& nodes) {
  auto fields = std::make_shared<FlowFields<T>>(make_flow_fields<T>(Exec{}, nodes));
  const ScalarField<T> density("density", nodes.capacity);
  Kokkos::deep_copy(density, T(1e-3));
  Kokkos::deep_copy(fields->u, T(1e-4));
  test::set_equilibrium(Exec{}, nodes, density, *fields);
  FlowStep<T> step;
  step.rates = relaxation_rates(Collision::trt, 0.764);
  return [=](const Exec& exec) { collide_and_stream(exec, nodes, *fields, step); };
}

template <class T>
Step heat_step(const FluidNodes& nodes) {
  const Lattice& lattice = nodes.lattice;
  auto fields = std::make_shared<HeatFields<T>>(
      make_heat_fields<T>(Exec{}, lattice, {0.056, 0.14, 0.625, ScalarVelocitySet::d2q5},
                          node_types({"box", 0}, lattice), {false, false}, 1.0));
  return [=](const Exec& exec) { conduct(exec, *fields); };
}

template <class T>
Step solute_step(const FluidNodes& nodes) {
  auto fields = std::make_shared<SoluteFields<T>>(make_solute_fields<D2Q5, T>(Exec{}, nodes, 0.5));
  const VectorField<T> u("u", nodes.capacity);
  Kokkos::deep_copy(u, T(1e-3));
  const SoluteParameters parameters = solute_parameters(0.02);
  return [=](const Exec& exec) { advance_solute<D2Q5>(exec, nodes, parameters, u, *fields); };
}

using Maker = Step (*)(const FluidNodes&);

void scaling(benchmark::State& state, Maker of_double, Maker of_float, int n) {
  const FluidNodes nodes = open_box(n);
  struct Curve {
    const char* name;
    Step step;
    Exec exec;
    std::vector<double> times;
  };
  const Exec one = one_thread(), all;
  const Step in_double = of_double(nodes), in_float = of_float(nodes);
  std::vector<Curve> curves{{"double_1", in_double, one, {}},
                            {"float_1", in_float, one, {}},
                            {"double_all", in_double, all, {}},
                            {"float_all", in_float, all, {}}};
  const int batch = batch_of(nodes.count);
  for (const Curve& curve : curves) curve.step(all);  // first touch
  for (auto _ : state) {
    double whole = 0;
    for (Curve& curve : curves) {
      curve.times.push_back(seconds([&] {
        for (int k = 0; k < batch; ++k) curve.step(curve.exec);
      }));
      whole += curve.times.back();
    }
    state.SetIterationTime(whole);
  }
  state.counters["nodes"] = nodes.count;
  for (const Curve& curve : curves)
    state.counters[std::string("MLUPS_") + curve.name] = nodes.count * 1e-6 * batch / median(curve.times);
}

[[maybe_unused]] const bool registered = [] {
  for (const int n : {100, 200, 400, 800, 1600, 3200}) {
    const std::string size = "/" + std::to_string(n);
    add("scaling/flow" + size, scaling, &flow_step<double>, &flow_step<float>, n);
    add("scaling/heat" + size, scaling, &heat_step<double>, &heat_step<float>, n);
    add("scaling/solute" + size, scaling, &solute_step<double>, &solute_step<float>, n);
  }
  return true;
}();

}  // namespace
}  // namespace vug::perf
