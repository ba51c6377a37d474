#pragma once
// One step of a species by itself, for tests and timings: in a fluid at rest, carried, and carried in advective form.
#include "kernels/solute/solute.hpp"

#include <type_traits>

namespace vug {

template <class Set, class T>
void advance_solute(const Exec& exec, const FluidNodes& nodes, const SoluteParameters& p, SoluteFields<T>& s) {
  advance_solute<Set>(exec, nodes, SoluteCarrier<T>{}, SteppingSolute<T>{p, s, {}});
}

template <class Set, class T>
void advance_solute(const Exec& exec, const FluidNodes& nodes, const SoluteParameters& p,
                    const std::type_identity_t<Displacement<T>>& u, SoluteFields<T>& s) {
  advance_solute<Set>(exec, nodes, SoluteCarrier<T>{u, {}}, SteppingSolute<T>{p, s, {}});
}

template <class Set, class T>
void advance_solute(const Exec& exec, const FluidNodes& nodes, const SoluteParameters& p,
                    const std::type_identity_t<Displacement<T>>& u, const ScalarField<T>& e, SoluteFields<T>& s,
                    const ScalarField<double>& correction) {
  advance_solute<Set>(exec, nodes, SoluteCarrier<T>{u, e}, SteppingSolute<T>{p, s, correction});
}

}  // namespace vug
