#include "kernels/solute/solute_boundary.hpp"

#include "kernels/launch/launch_lists.hpp"
#include "kernels/nodes/fluid_nodes.hpp"
#include "kernels/scalar/turning.hpp"

namespace vug {

/// h_in = -A + 2 w C_b, on D2Q9 with the even part of the equilibrium where fluid crosses.
template <class T, class Set>
struct ConcentrationRule {
  double C_b;
  Crossing<T> crossing;
  KOKKOS_FORCEINLINE_FUNCTION T operator()(int, int i, int q, T out) const {
    return T(2 * Set::w(q) * C_b) * crossing.template pair<Set>(i, q) - out;
  }
};

/// h_in = A + area flux.
template <class T>
struct FluxRule {
  const double* area;
  double flux;
  Rounding<T> rounding;
  KOKKOS_FORCEINLINE_FUNCTION T operator()(int link, int i, int, T out) const {
    return rounding.sum(out, T(area[link] * flux), i);
  }
};

/// h_in = h*_in of the same node - outflow_slope(tau_1) w_q (C - C_before). The slot of h*_in depends on whether
/// populations are turned (streaming.hpp).
template <class T, class Set>
struct SoluteOutflowRule {
  const T* h;
  const T* C;
  Kokkos::View<const int*> source;
  int capacity, turned;
  T slope;
  Rounding<T> rounding;
  KOKKOS_FORCEINLINE_FUNCTION T operator()(int, int i, int q, T) const {
    const int before = upstream_node(source, capacity, q, i);
    const T inward = h[turned ? source(q * capacity + i) : Set::opposite(q) * capacity + i];
    if (before < 0) return inward;  // a wall sends back what leaves
    return rounding.sum(inward, -(T(Set::w(q)) * slope * (C[i] - C[before])), i);
  }
};

/// Dresses the links of an outflow: all, or only those that lead down or left (way 1), or only the others (way -1).
/// Where opposite links of a node lead into one opening, each reads the slot that the other writes, so that they must
/// not run at the same time.
template <class Dress>
struct DressOneWay {
  Dress dress;
  int way;
  KOKKOS_FUNCTION void operator()(int item) const {
    const int q = dress.links.direction[dress.links.link(item)];
    if (way == 0 || (q > D2Q9::opposite(q)) == (way > 0)) dress(item);
  }
};

/// Dresses each stretch by its rule.
template <class T, class Set>
struct DressSolutes {
  using Entry = SoluteCondition<T>;
  Kokkos::View<const int*> source;
  int capacity;
  Crossing<T> crossing;
  int way = 0;  ///< of outflows

  static int count(const Entry& c) { return c.own_count; }
  template <class Run>
  KOKKOS_FUNCTION void operator()(const Entry& c, const Run& run) const {
    using Kind = typename Entry::Kind;
    using Outflow = DressLinks<T, SoluteOutflowRule<T, Set>>;
    if (c.kind == Kind::outflow)
      run(DressOneWay<Outflow>{{c, c.h, capacity, {c.h, c.C, source, capacity, c.turned, c.slope, c.rounding}}, way});
    else if (c.kind == Kind::concentration)
      run(DressLinks<T, ConcentrationRule<T, Set>>{c, c.h, capacity, {c.value, crossing}});
    else
      run(DressLinks<T, FluxRule<T>>{c, c.h, capacity, {c.part, c.value, c.rounding}});
  }
};

namespace {

template <class T>
SoluteCondition<T> condition(typename SoluteCondition<T>::Kind kind, const BoundaryLinks& links,
                             const SoluteFields<T>& s, const ScalarField<double>& gain, const double* part,
                             double value) {
  return {{links, gain}, kind, s.turned, s.h.data(), s.C.data(), part, value, 0, s.rounding.at_links};
}

}  // namespace

template <class T>
SoluteCondition<T> concentration_condition(const BoundaryLinks& links, double C_b, const SoluteFields<T>& s,
                                           const ScalarField<double>& gain) {
  return condition(SoluteCondition<T>::Kind::concentration, links, s, gain, nullptr, C_b);
}

template <class T>
SoluteCondition<T> flux_condition(const BoundaryLinks& links, const ScalarField<double>& area, double flux,
                                  const SoluteFields<T>& s, const ScalarField<double>& gain) {
  return condition(SoluteCondition<T>::Kind::flux, links, s, gain, area.data(), flux);
}

template <class T>
SoluteCondition<T> outflow_condition(const BoundaryLinks& links, const SoluteParameters& parameters,
                                     const SoluteFields<T>& s, const ScalarField<double>& gain) {
  SoluteCondition<T> made = condition(SoluteCondition<T>::Kind::outflow, links, s, gain, nullptr, 0);
  made.slope = static_cast<T>(outflow_slope(parameters.tau_1));
  return made;
}

template <class Set, class T>
void dress(const Exec& exec, const FluidNodes& nodes, std::span<const SoluteCondition<T>> conditions, bool narrow,
           const std::type_identity_t<Crossing<T>>& crossing) {
  const char* label = "vug::solute_boundary::dress";
  const auto run = [&](std::span<const SoluteCondition<T>> list, int way) {
    for_each_of_lists(exec, label, list, DressSolutes<T, Set>{nodes.source, nodes.capacity, crossing, way});
  };
  if (!narrow) return run(conditions, 0);
  for (const SoluteCondition<T>& condition : conditions)
    if (condition.kind == SoluteCondition<T>::Kind::outflow)
      for (const int way : {1, -1}) run({&condition, 1}, way);
    else
      run({&condition, 1}, 0);
}

struct IsNarrow {
  Kokkos::View<const int*> fluid;
  Kokkos::View<const std::uint8_t*> direction;
  Kokkos::View<const std::uint16_t*> side_links;
  KOKKOS_FUNCTION void operator()(int link, int& narrow) const {
    narrow += side_links(fluid(link)) >> D2Q9::opposite(direction(link)) & 1;
  }
};

bool is_narrow(const Exec& exec, const FluidNodes& nodes, const BoundaryLinks& links) {
  int narrow = 0;
  Kokkos::parallel_reduce("vug::solute_boundary::narrow", Kokkos::RangePolicy<Exec>(exec, 0, links.count),
                          IsNarrow{links.fluid, links.direction, nodes.side_links}, narrow);
  return narrow > 0;
}

VUG_COMPILE_FOR_NUMBERS(concentration_condition)
VUG_COMPILE_FOR_NUMBERS(flux_condition)
VUG_COMPILE_FOR_NUMBERS(outflow_condition)
VUG_COMPILE_FOR_SETS(dress)

}  // namespace vug
