// The heat kernels: conduction over all nodes, what the flow carries over the fluid ones; velocity sets, precisions.
#include "kernels/heat/heat.hpp"
#include "kernels/scalar/advective_form.hpp"
#include "measure.hpp"
#include "rock_geometry.hpp"

namespace vug::perf {
namespace {

int directions_of(ScalarVelocitySet set) {
  return visit_velocity_set(set, [](auto s) { return decltype(s)::Q; });
}

/// Heat fields over a geometry, at a temperature that no population makes subnormal.
template <class T>
struct HeatSetting {
  Exec exec;
  Lattice lattice = timed_lattice();
  int count = lattice.nx * lattice.ny;
  Kokkos::View<NodeType*> type;
  HeatFields<T> fields;
  HeatSetting(const Geometry& geometry, ScalarVelocitySet set)
      : type(node_types(geometry, lattice)),
        fields(make_heat_fields<T>(exec, lattice, {0.056, 0.14, 0.625, set}, type, {false, false}, 1.0)) {}
};

/// Q populations read and written, the mask read.
template <class T>
void conduct_all(benchmark::State& state, const Geometry* geometry, ScalarVelocitySet set) {
  HeatSetting<T> s(*geometry, set);
  const double bytes = 2 * directions_of(set) * sizeof(T) + 1;
  const auto step = [&] { conduct(s.exec, s.fields); };
  if (set == ScalarVelocitySet::d2q5)
    measure<T, D2Q5::Q>(state, s.count, bytes, step);
  else
    measure<T, D2Q9::Q>(state, s.count, bytes, step);
}

/// A whole step where fluid flows: what `conduct_all` moves, and the velocity, defect, its lag, row and links of the
/// fluid.
template <class T>
void step_of_rows(benchmark::State& state, const Geometry* geometry, ScalarVelocitySet set) {
  HeatSetting<T> s(*geometry, set);
  const FluidNodes nodes = make_fluid_nodes(s.exec, s.lattice, s.type);
  const FluidRows rows = fluid_rows(s.exec, nodes);
  const VectorField<T> u("u", nodes.capacity);
  const ScalarField<T> defect("defect", nodes.capacity), lagged("lagged", nodes.capacity);
  const ScalarField<double> created("created", s.lattice.ny);
  Kokkos::deep_copy(u, T(1e-4));
  const double fluid = static_cast<double>(nodes.count) / s.count;
  const double bytes =
      2 * directions_of(set) * sizeof(T) + 1 + fluid * (5 * sizeof(T) + 2 * sizeof(int) + 3 * sizeof(std::uint16_t));
  const auto step = [&] { conduct_and_advect(s.exec, nodes, rows, u, defect, lagged, s.fields, created); };
  if (set == ScalarVelocitySet::d2q5)
    measure<T, D2Q5::Q>(state, s.count, bytes, step);
  else
    measure<T, D2Q9::Q>(state, s.count, bytes, step);
}

[[maybe_unused]] const bool registered = [] {
  for (const Geometry& geometry : geometries)
    for (const ScalarVelocitySet set : {ScalarVelocitySet::d2q5, ScalarVelocitySet::d2q9}) {
      const std::string name = set == ScalarVelocitySet::d2q5 ? "D2Q5" : "D2Q9";
      add("heat/conduct_" + name + "/double/" + geometry.name, conduct_all<double>, &geometry, set);
      add("heat/conduct_" + name + "/float/" + geometry.name, conduct_all<float>, &geometry, set);
      add("heat/step_" + name + "/double/" + geometry.name, step_of_rows<double>, &geometry, set);
      add("heat/step_" + name + "/float/" + geometry.name, step_of_rows<float>, &geometry, set);
    }
  return true;
}();

}  // namespace
}  // namespace vug::perf
