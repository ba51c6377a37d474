// The flow sweep: geometries, precisions, collisions.
#include "hand_written_flow.hpp"
#include "kernels/flow/flow.hpp"
#include "kernels/flow/two_relaxation_times.hpp"
#include "measure.hpp"
#include "rock_geometry.hpp"
#include "support/set_equilibrium.hpp"

namespace vug::perf {
namespace {

/// What a sweep moves per node: 18 populations, the stored velocity, indices by windows in every second step.
template <class T>
constexpr double sweep_bytes = 20 * sizeof(T) + index_bytes(8) / 2;

struct Case {
  const Geometry* geometry;
  Lattice lattice;
};

/// Nodes and their fields in gentle motion, so that no population is subnormal.
template <class T>
struct Setting {
  Exec exec;
  FluidNodes nodes;
  FlowFields<T> fields;
  FlowStep<T> step;
  explicit Setting(const Case& c) {
    nodes = make_fluid_nodes(exec, c.lattice, node_types(*c.geometry, c.lattice));
    fields = make_flow_fields<T>(exec, nodes);
    const ScalarField<T> density("density", nodes.capacity);
    Kokkos::deep_copy(exec, density, T(1e-3));
    Kokkos::deep_copy(exec, fields.u, T(1e-4));
    test::set_equilibrium(exec, nodes, density, fields);
    step.rates = relaxation_rates(Collision::trt, 0.764);
  }
};

template <class T>
void sweep(benchmark::State& state, const Case& c, Collision collision, bool limited) {
  Setting<T> s(c);
  s.step.collision = collision;
  s.step.rates = relaxation_rates(collision, 0.764);
  if (limited) {
    s.step.speed_limit = T(0.2);
    s.step.limited = ScalarField<double>("limited", block_count(s.nodes.count));
  }
  measure<T, D2Q9::Q>(state, s.nodes.count, sweep_bytes<T>,
                      [&] { collide_and_stream(s.exec, s.nodes, s.fields, s.step); });
}

/// In turn with the sweep written by hand over the same list (hand_written_flow.hpp).
template <class T>
void in_place(benchmark::State& state, const Case& c) {
  Setting<T> s(c);
  FlowFields<T> other = make_flow_fields<T>(s.exec, s.nodes);
  Kokkos::deep_copy(other.f, s.fields.f);
  const TwoRelaxationTimes<T> relax(s.step.rates);
  T* f = other.f.data();
  bool at_home = true;
  const auto hand_written = [&] {
    if (at_home)
      for_each_node(s.exec, "vug::perf::in_place_from_home", s.nodes.count,
                    HandWrittenInPlace<T, true>{f, s.nodes.source.data(), s.nodes.capacity, relax});
    else
      for_each_node(s.exec, "vug::perf::in_place_from_turned", s.nodes.count,
                    HandWrittenInPlace<T, false>{f, s.nodes.source.data(), s.nodes.capacity, relax});
    at_home = !at_home;
  };
  measure<T, D2Q9::Q>(
      state, s.nodes.count, sweep_bytes<T>, [&] { collide_and_stream(s.exec, s.nodes, s.fields, s.step); },
      hand_written);
}

template <class T>
void add_precision(const std::string& precision) {
  for (const Geometry& geometry : geometries) {
    const Case c{&geometry, timed_lattice()};
    const std::string suffix = "/" + precision + "/" + geometry.name;
    add("flow/in_place" + suffix, in_place<T>, c);
    add("flow/in_place_limited" + suffix, sweep<T>, c, Collision::trt, true);
    add("flow/in_place_lallemand_luo" + suffix, sweep<T>, c, Collision::lallemand_luo, false);
    add("flow/in_place_regularised" + suffix, sweep<T>, c, Collision::regularised, false);
  }
}

[[maybe_unused]] const bool registered = [] {
  add_precision<double>("double");
  add_precision<float>("float");
  return true;
}();

}  // namespace
}  // namespace vug::perf
