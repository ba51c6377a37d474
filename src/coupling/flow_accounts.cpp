// What the flow reports: its balance, its columns of the history, its fields.
#include "coupling/flow_module.hpp"
#include "coupling/read_fields.hpp"
#include "kernels/flow/guards.hpp"
#include "kernels/launch/launch.hpp"

#include <cmath>
#include <limits>

namespace vug {

namespace {

/// Mean of a component of the velocity over all nodes of the lattice, lattice units; 0 in rock.
template <class T>
double mean_velocity(const Geometry& geometry, const VectorField<T>& u, int axis) {
  const ScalarField<double> partial("vug::flow::partial", block_count(geometry.fluid.count));
  add_velocity(Exec{}, geometry.fluid, u, axis, partial);
  geometry.split.make_whole(geometry.split.of_blocks(), partial);
  return sum_in_order(partial) / (static_cast<double>(geometry.lattice.nx) * geometry.lattice.ny);
}

}  // namespace

template <class T>
void FlowModule<T>::ledger(Ledger& ledger) const {
  const double kg = units_.fluid_density * units_.volume();
  Balance& balance = ledger.of("fluid_mass", "kg/m");
  balance.initial = kg * initial_mass_;
  balance.stored = kg * mass();
  gather_sums();
  double entered = 0;
  for (const StretchLinks& boundary : boundaries_)
    if (!boundary.stretch.opening) entered += boundary.total();
  balance.gains.push_back({"boundaries", kg * entered});
  for (const StretchLinks& boundary : boundaries_)
    if (boundary.stretch.opening) balance.gains.push_back({boundary.stretch.name, kg * boundary.total()});
  balance.gains.push_back({"births", kg * born_mass_});
  // in a closed box, rounding is the only contribution
  constexpr double roundings = 16 * std::numeric_limits<T>::epsilon();
  balance.negligible = roundings * kg * geometry_.fluid.count;
}

template <class T>
void FlowModule<T>::history(std::vector<HistoryValue>& row) const {
  geometry_.split.make_whole(geometry_.split.of_blocks(), step_.limited);
  row.push_back({"largest_mach_1", extremes(Exec{}).speed * std::sqrt(3.0)});
  row.push_back({"fluid_nodes_1", static_cast<double>(geometry_.fluid.count)});
  row.push_back({"speed_limiter_uses_1", sum_in_order(step_.limited)});
  row.push_back({"mean_velocity_x_m/s", units_.velocity() * mean_velocity(geometry_, fields_.u, 0)});
  row.push_back({"mean_velocity_y_m/s", units_.velocity() * mean_velocity(geometry_, fields_.u, 1)});
  if (steady_.on()) row.push_back({"flow_held_steps_1", static_cast<double>(steady_.held_steps())});
}

template <class T>
void FlowModule<T>::fields(FieldList& list) const {
  for (const auto& [name, reference] : {std::pair{"pressure", units_.reference_pressure}, {"gauge_pressure", 0.0}})
    list.lattice.push_back({name, "Pa", 1, [this, reference = reference] {
                              const std::array density{densities(Exec{}, geometry_.fluid, fields_)};
                              return read_fluid(geometry_, density, {units_.pressure() / 3, reference, reference});
                            }});
  list.lattice.push_back({"velocity", "m/s", 2, [this] {
                            return read_fluid(geometry_, components(fields_.u), {units_.velocity(), 0, 0});
                          }});
}

#define VUG_INSTANTIATE(T)                                                \
  template void FlowModule<T>::ledger(Ledger&) const;                     \
  template void FlowModule<T>::history(std::vector<HistoryValue>&) const; \
  template void FlowModule<T>::fields(FieldList&) const;
VUG_FOR_NUMBERS(VUG_INSTANTIATE)
#undef VUG_INSTANTIATE

}  // namespace vug
