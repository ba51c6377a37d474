#include "kernels/solute/solute.hpp"

#include "base/pages.hpp"
#include "base/require.hpp"
#include "kernels/scalar/turning.hpp"
#include "kernels/solute/solute_sweep.hpp"

#include <string>

namespace vug {

SoluteParameters solute_parameters(double D, std::optional<double> tau_h) {
  if (!(D > 0)) throw InputError("solute: diffusivity " + std::to_string(D) + " in lattice units, expected above 0");
  const double other = tau_h.value_or(0.5 + 0.25 / (3 * D));
  if (!(other > 0.5)) throw InputError("solute: relaxation time " + std::to_string(other) + ", expected above 0.5");
  return {0.5 + 3 * D, other, 1};
}

SoluteParameters turning_parameters(const SoluteParameters& p, double stretch) {
  const Turning turn = turning(p.tau_1, stretch);
  return {1 / turn.rate, 1 / (2 - turn.rate), turn.carried};
}

template <class T, class Set>
struct UniformConcentrationAtRest {
  ScalarField<T> h, C;
  int capacity;
  T concentration;
  KOKKOS_FUNCTION void operator()(int i) const {
    C(i) = concentration;
    for (int q = 0; q < Set::Q; ++q) h(q * capacity + i) = T(Set::w(q)) * concentration;
  }
};

template <class Set, class T>
SoluteFields<T> make_solute_fields(const Exec& exec, const FluidNodes& nodes, double concentration) {
  const bool in_parts = !nodes.share().whole();
  SoluteFields<T> s{zeros<ScalarField<T>>(exec, "vug::solute::h", std::size_t(Set::Q) * nodes.capacity, in_parts), 0,
                    zeros<ScalarField<T>>(exec, "vug::solute::C", nodes.capacity, in_parts)};
  for_each_node(exec, "vug::solute::uniform", nodes.share(),
                UniformConcentrationAtRest<T, Set>{s.h, s.C, nodes.capacity, T(concentration)});
  return s;
}

template <class Set, class T>
void advance_solute(const Exec& exec, const FluidNodes& nodes, const SoluteCarrier<T>& carrier,
                    const SteppingSolute<T>& s) {
  visit_flow(carrier, [&](const auto& flow) {
    visit_slots<Set>(nodes, s.fields.turned, [&](const auto& slots) {
      using Flow = std::decay_t<decltype(flow)>;
      const auto sweep = solute_sweep<Set>(slots, s.parameters, s.fields, flow);
      if constexpr (runs_on_host)
        for_each_block(exec, "vug::solute::advance", nodes.share(), sweep_of_block(nodes, sweep, s.correction),
                       sweep_block_size<Flow>(nodes.count));
      else if constexpr (Flow::advective_form)
        add_per_block(exec, "vug::solute::advance", nodes.share(), sweep, s.correction);
      else
        for_each_node(exec, "vug::solute::advance", nodes.share(), sweep);
    });
  });
  s.fields.turned = 1 - s.fields.turned;
}

template <class Set, class T>
void add_solute(const Exec& exec, const FluidNodes& nodes, const SoluteFields<T>& s, const ScalarField<double>& total) {
  add_per_block(exec, "vug::solute_totals::sum", nodes.share(), SumOfSlots<T, Set>{s.h, nodes.capacity}, total);
}

template <class T>
struct ChangeOfNode {
  Kokkos::View<const T*> C;
  int count;
  ScalarField<T> before;
  KOKKOS_FUNCTION double operator()(int i) const {
    // a steady concentration goes to and fro between neighbouring floats
    constexpr double rounding = std::is_same_v<T, float> ? 0x1p-21 : 0;
    const double change = Kokkos::abs(double(C(i)) - double(before(i)));
    if (change <= rounding * Kokkos::abs(double(C(i)))) return 0;
    before(i) = C(i);
    return i < count ? change : 0;
  }
};

template <class T>
void add_change(const Exec& exec, const FluidNodes& nodes, const Kokkos::View<const T*>& C, int count,
                const ScalarField<T>& before, const ScalarField<double>& total) {
  add_per_block(exec, "vug::solute_totals::change", nodes.share(), ChangeOfNode<T>{C, count, before}, total);
}

VUG_COMPILE_FOR_SETS(make_solute_fields)
VUG_COMPILE_FOR_SETS(advance_solute)
VUG_COMPILE_FOR_SETS(add_solute)
VUG_COMPILE_FOR_NUMBERS(add_change)

}  // namespace vug
