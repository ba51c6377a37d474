// The flow sweep: geometries, precisions, collisions.
#include "hand_written_flow.hpp"
#include "kernels/flow.hpp"
#include "measure.hpp"
#include "rock_geometry.hpp"

namespace vug::perf {
namespace {

/// What a sweep moves per node: 18 populations, stored moments, indices (8, in place in every second step only);
/// write-allocation not counted.
template <class T>
constexpr double sweep_bytes(int moments, Streaming streaming) {
  return (18 + moments) * sizeof(T) + (streaming == Streaming::in_place ? 4 : 8) * sizeof(int);
}

struct Case {
  const Geometry* geometry;
  int nx, ny;
};

/// Nodes and their fields in gentle motion, so that no population is subnormal.
template <class T>
struct Setting {
  Exec exec;
  FluidNodes nodes;
  FlowFields<T> fields;
  FlowStep<T> step;
  explicit Setting(const Case& c, Streaming streaming = Streaming::in_place) {
    const Lattice lattice(c.nx, c.ny);
    nodes = make_fluid_nodes(exec, lattice, node_types(*c.geometry, lattice));
    fields = make_flow_fields<T>(exec, nodes, streaming);
    Kokkos::deep_copy(exec, fields.density, T(1e-3));
    Kokkos::deep_copy(exec, fields.u, T(1e-4));
    set_equilibrium(exec, nodes, fields);
    step.rates = relaxation_rates(Collision::trt, 0.764);
  }
};

template <class T>
void sweep(benchmark::State& state, const Case& c, Streaming streaming, Collision collision, bool limited) {
  Setting<T> s(c, streaming);
  s.step.collision = collision;
  s.step.rates = relaxation_rates(collision, 0.764);
  if (limited) {
    s.step.speed_limit = T(0.2);
    s.step.limited = ScalarField<double>("limited", block_count(s.nodes.count));
  }
  measure<T, D2Q9::Q>(state, s.nodes.count, sweep_bytes<T>(3, streaming),
                      [&] { collide_and_stream(s.exec, s.nodes, s.fields, s.step); });
}

template <class T>
void hand_written_two_lattices(benchmark::State& state, const Case& c) {
  Setting<T> s(c, Streaming::two_lattices);
  const TwoRelaxationTimes<T> relax(s.step.rates);
  measure<T, D2Q9::Q>(state, s.nodes.count, sweep_bytes<T>(0, Streaming::two_lattices), [&] {
    for_each_node(s.exec, "vug::perf::two_lattices", s.nodes.count,
                  HandWrittenTwoLattices<T>{s.fields.f.data(), s.fields.f_next.data(), s.nodes.source.data(),
                                            s.nodes.capacity, relax});
    std::swap(s.fields.f, s.fields.f_next);
  });
}

template <class T>
void hand_written_in_place(benchmark::State& state, const Case& c) {
  Setting<T> s(c);
  const TwoRelaxationTimes<T> relax(s.step.rates);
  T* f = s.fields.f.data();
  bool at_home = true;
  measure<T, D2Q9::Q>(state, s.nodes.count, sweep_bytes<T>(0, Streaming::in_place), [&] {
    if (at_home)
      for_each_node(s.exec, "vug::perf::in_place_from_home", s.nodes.count,
                    HandWrittenInPlace<T, true>{f, s.nodes.source.data(), s.nodes.capacity, relax});
    else
      for_each_node(s.exec, "vug::perf::in_place_from_turned", s.nodes.count,
                    HandWrittenInPlace<T, false>{f, s.nodes.source.data(), s.nodes.capacity, relax});
    at_home = !at_home;
  });
}

template <class Function, class... Arguments>
void add(const std::string& name, Function function, Arguments... arguments) {
  benchmark::RegisterBenchmark(name.c_str(), function, arguments...)
      ->UseManualTime()
      ->Iterations(7)
      ->Unit(benchmark::kMillisecond);
}

template <class T>
void add_precision(const std::string& precision) {
  constexpr Streaming in_place = Streaming::in_place, two_lattices = Streaming::two_lattices;
  for (const Geometry& geometry : geometries) {
    const Case c{&geometry, 2000, 1400};
    const std::string suffix = "/" + precision + "/" + geometry.name;
    add("flow/in_place" + suffix, sweep<T>, c, in_place, Collision::trt, false);
    add("flow/two_lattices" + suffix, sweep<T>, c, two_lattices, Collision::trt, false);
    add("flow/in_place_limited" + suffix, sweep<T>, c, in_place, Collision::trt, true);
    add("flow/in_place_lallemand_luo" + suffix, sweep<T>, c, in_place, Collision::lallemand_luo, false);
    add("flow/in_place_regularised" + suffix, sweep<T>, c, in_place, Collision::regularised, false);
    add("flow/hand_written_in_place" + suffix, hand_written_in_place<T>, c);
    add("flow/hand_written_two_lattices" + suffix, hand_written_two_lattices<T>, c);
  }
  for (const int n : {128, 512, 1024, 2048})
    add("flow/in_place_square_box/" + precision + "/" + std::to_string(n), sweep<T>, Case{&geometries[2], n, n},
        in_place, Collision::trt, false);
}

[[maybe_unused]] const bool registered = [] {
  add_precision<double>("double");
  add_precision<float>("float");
  return true;
}();

}  // namespace
}  // namespace vug::perf
