#pragma once
// A boundary condition on one stretch at a time, where a run dresses all of its stretches together.
#include "kernels/flow/open_boundary.hpp"
#include "kernels/solute/solute_boundary.hpp"

#include <utility>
#include <vector>

namespace vug {

template <class T>
void dress_one(const Exec& exec, const FluidNodes& nodes, const FlowCondition& condition, const FlowFields<T>& fields) {
  dress<T>(exec, nodes, {&condition, 1}, fields);
}

template <class T>
void dress_pressure(const Exec& exec, const FluidNodes& nodes, const BoundaryLinks& links, const IndexList& mirror,
                    double pressure, const FlowFields<T>& fields, const ScalarField<double>& gain) {
  dress_one(exec, nodes, pressure_condition(links, mirror, pressure, gain), fields);
}

template <class T>
void dress_velocity(const Exec& exec, const FluidNodes& nodes, const BoundaryLinks& links,
                    std::array<double, 2> velocity, const FlowFields<T>& fields, const ScalarField<double>& gain,
                    const ScalarField<double>& share = {}) {
  dress_one(exec, nodes, velocity_condition(links, velocity, share, gain), fields);
}

template <class T>
void dress_outflow(const Exec& exec, const FluidNodes& nodes, const BoundaryLinks& links, const IndexList& mirror,
                   const OutflowState& state, const FlowFields<T>& fields, const ScalarField<double>& gain) {
  dress_one(exec, nodes, outflow_condition(links, mirror, state, gain), fields);
}

template <class Set, class T>
void dress_concentration(const Exec& exec, const FluidNodes& nodes, const BoundaryLinks& links, double C_b,
                         const SoluteFields<T>& s, const ScalarField<double>& gain) {
  const SoluteCondition<T> condition = concentration_condition(links, C_b, s, gain);
  dress<Set, T>(exec, nodes, {&condition, 1});
}

/// As above with a concentration of its own on every link.
template <class Set, class T>
void dress_concentration(const Exec& exec, const FluidNodes& nodes, const BoundaryLinks& links,
                         const std::vector<double>& C_b, const SoluteFields<T>& s, const ScalarField<double>& gain) {
  std::vector<SoluteCondition<T>> conditions;
  for (int l = 0; l < links.count; ++l) {
    const std::pair one(l, l + 1);
    const BoundaryLinks link{1, Kokkos::subview(links.fluid, one), Kokkos::subview(links.direction, one), -1, {}};
    conditions.push_back(concentration_condition<T>(link, C_b[l], s, Kokkos::subview(gain, one)));
  }
  dress<Set, T>(exec, nodes, conditions);
}

template <class Set, class T>
void dress_outflow(const Exec& exec, const FluidNodes& nodes, const BoundaryLinks& links,
                   const SoluteParameters& parameters, const SoluteFields<T>& s, const ScalarField<double>& gain) {
  const SoluteCondition<T> condition = outflow_condition(links, parameters, s, gain);
  dress<Set, T>(exec, nodes, {&condition, 1});
}

}  // namespace vug
