#include "kernels/solute.hpp"

#include "kernels/launch.hpp"
#include "kernels/require.hpp"
#include "kernels/scalar_equilibrium.hpp"
#include "kernels/unroll.hpp"

#include <string>

namespace vug {

SoluteParameters solute_parameters(double D) {
  if (!(D > 0)) throw InputError("solute: diffusivity " + std::to_string(D) + " in lattice units, expected above 0");
  return {0.5 + 3 * D, 0.5 + 0.25 / (3 * D)};
}

SoluteParameters solute_parameters(double D, double tau_h) {
  if (!(D > 0)) throw InputError("solute: diffusivity " + std::to_string(D) + " in lattice units, expected above 0");
  if (!(tau_h > 0.5)) throw InputError("solute: relaxation time " + std::to_string(tau_h) + ", expected above 0.5");
  return {0.5 + 3 * D, tau_h};
}

/// Advection policies: what the sweep reads of the flow.
struct NoAdvection {
  static constexpr bool moves = false;
  static constexpr bool advective_form = false;
};

template <class T>
struct Advection {
  static constexpr bool moves = true;
  static constexpr bool advective_form = false;
  Kokkos::View<const T* [2], Kokkos::LayoutLeft> u;
};

template <class T>
struct AdvectiveForm {
  static constexpr bool moves = true;
  static constexpr bool advective_form = true;
  Kokkos::View<const T* [2], Kokkos::LayoutLeft> u;
  Kokkos::View<const T*> e;
};

/// Pull, collide, store. With C = sum h, J = sum c h and heq = w C (1 + 3 c.u [+ 9/2 (c.u)^2 - 3/2 u^2]):
///   h* = h - (h - heq)/tau_h + (1/tau_h - 1/tau_1) 3 w c.(J - C u),
/// which is Eqs. 14, 15 and 18 solved for the gradient, 3 (J - C u)/(tau_B - tau_h). Conserves sum h; with the
/// advective form it returns what it adds to it, -C e with C (1 + e) = sum of the pulled populations. Bytes per node,
/// size of T = s: 2 Q s + 4 (Q - 1) + s (by eights 2.5 (Q - 1) instead), + 2 s with advection, + s with the advective
/// form.
template <class T, class Set, class Flow>
struct SoluteSweep {
  Kokkos::View<const int*> source;
  Kokkos::View<const T*> h;
  ScalarField<T> h_next, C;
  int capacity;
  T rate_h, rate_difference;
  Flow flow;

  KOKKOS_FORCEINLINE_FUNCTION double operator()(int i) const {
    T g[Set::Q];
    g[0] = h(i);
    VUG_UNROLL
    for (int q = 1; q < Set::Q; ++q) g[q] = h(source(q * capacity + i));
    return finish(i, g);
  }

  /// Concentration, collision and store of the populations that have arrived.
  KOKKOS_FORCEINLINE_FUNCTION double finish(int i, T (&g)[Set::Q]) const {
    T c = g[0], flux_x = 0, flux_y = 0;
    VUG_UNROLL
    for (int q = 1; q < Set::Q; ++q) {
      c += g[q];
      flux_x += T(Set::c(q, 0)) * g[q];
      flux_y += T(Set::c(q, 1)) * g[q];
    }
    T added = 0;
    if constexpr (Flow::advective_form) {
      added = -c * flow.e(i) / (T(1) + flow.e(i));
      g[0] += added;
      c += added;
    }
    C(i) = c;
    collide(i, g, c, flux_x, flux_y);
    VUG_UNROLL
    for (int q = 0; q < Set::Q; ++q) h_next(q * capacity + i) = g[q];
    return double(added);
  }

  /// The population at rest is what the others leave of C: rounded weights do not add up to one, and what they miss
  /// (5e-17 of C in double, 3e-8 in float) would be gained or lost at every node in every step.
  KOKKOS_FORCEINLINE_FUNCTION void collide(int i, T* g, T c, T flux_x, T flux_y) const {
    T ux = 0, uy = 0;
    if constexpr (Flow::moves) {
      ux = flow.u(i, 0);
      uy = flow.u(i, 1);
      flux_x -= c * ux;
      flux_y -= c * uy;
    }
    flux_x *= rate_difference;
    flux_y *= rate_difference;
    T rest = c;
    VUG_UNROLL
    for (int q = 1; q < Set::Q; ++q) {
      T wc = T(Set::w(q)) * c;
      if constexpr (Flow::moves) wc *= scalar_equilibrium<Set, T>(q, ux, uy);
      g[q] += rate_h * (wc - g[q]) + T(3 * Set::w(q)) * (T(Set::c(q, 0)) * flux_x + T(Set::c(q, 1)) * flux_y);
      rest -= g[q];
    }
    g[0] = rest;
  }
};

/// A block of nodes, eight at a time. What they add is summed as add_per_block does.
template <class T, class Set, class Flow>
struct EightSweeps {
  SoluteSweep<T, Set, Flow> sweep;
  Kokkos::View<const SourceWindow*> windows;
  ScalarField<double> correction;
  void operator()(int first, int last) const {
    const detail::LocalBody<SoluteSweep<T, Set, Flow>> copy(sweep);
    const SoluteSweep<T, Set, Flow>& local = copy.body;
    const EightNodes<T, Set> eight{windows.data(), local.source.data(), local.capacity};
    const T* const h = local.h.data();
    double sum[nodes_per_window] = {};
    int i = first;
    for (; i + nodes_per_window <= last; i += nodes_per_window) {
      alignas(64) T g[Set::Q][nodes_per_window];
      eight.pull(h, i, g);
      VUG_VECTORISE
      for (int l = 0; l < nodes_per_window; ++l) {
        T own[Set::Q];
        VUG_UNROLL
        for (int q = 0; q < Set::Q; ++q) own[q] = g[q][l];
        sum[l] += local.finish(i + l, own);
      }
    }
    for (int l = 0; i < last; ++i, ++l) sum[l] += local(i);
    if constexpr (Flow::advective_form)
      correction(first / nodes_per_block) +=
          ((sum[0] + sum[1]) + (sum[2] + sum[3])) + ((sum[4] + sum[5]) + (sum[6] + sum[7]));
  }
};

template <class Set, class T, class Flow>
SoluteSweep<T, Set, Flow> make_sweep(const FluidNodes& nodes, const SoluteParameters& p, const SoluteFields<T>& s,
                                     const Flow& flow) {
  return {nodes.source, s.h, s.h_next, s.C, nodes.capacity, T(1 / p.tau_h), T(1 / p.tau_h - 1 / p.tau_1), flow};
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

template <class T, class Set>
SoluteFields<T> make_solute_fields(const Exec& exec, const FluidNodes& nodes, double concentration) {
  const std::size_t slots = std::size_t(Set::Q) * nodes.capacity;
  SoluteFields<T> s{ScalarField<T>("vug::solute::h", slots), ScalarField<T>("vug::solute::h_next", slots),
                    ScalarField<T>("vug::solute::C", nodes.capacity)};
  for_each_node(exec, "vug::solute::uniform", nodes.count,
                UniformConcentrationAtRest<T, Set>{s.h, s.C, nodes.capacity, T(concentration)});
  return s;
}

/// One sweep; with the advective form `correction` gains what it adds.
template <class Set, class T, class Flow>
void advance(const Exec& exec, const char* label, const FluidNodes& nodes, const SoluteParameters& p,
             SoluteFields<T>& s, const Flow& flow, const ScalarField<double>& correction = {}) {
  const auto sweep = make_sweep<Set>(nodes, p, s, flow);
  if constexpr (has_source_windows)
    for_each_block(exec, label, nodes.count, EightSweeps<T, Set, Flow>{sweep, nodes.windows, correction},
                   Flow::advective_form ? nodes_per_block : block_of_list(nodes.count));
  else if constexpr (Flow::advective_form)
    add_per_block(exec, label, nodes.count, sweep, correction);
  else
    for_each_node(exec, label, nodes.count, sweep);
  std::swap(s.h, s.h_next);
}

template <class Set, class T>
void advance_solute(const Exec& exec, const FluidNodes& nodes, const SoluteParameters& p, SoluteFields<T>& s) {
  advance<Set>(exec, "vug::solute::diffuse", nodes, p, s, NoAdvection{});
}

template <class Set, class T>
void advance_solute(const Exec& exec, const FluidNodes& nodes, const SoluteParameters& p, const VectorField<T>& u,
                    SoluteFields<T>& s) {
  advance<Set>(exec, "vug::solute::advect", nodes, p, s, Advection<T>{u});
}

template <class Set, class T>
void advance_solute(const Exec& exec, const FluidNodes& nodes, const SoluteParameters& p, const VectorField<T>& u,
                    const ScalarField<T>& e, SoluteFields<T>& s, const ScalarField<double>& correction) {
  advance<Set>(exec, "vug::solute::advect_in_advective_form", nodes, p, s, AdvectiveForm<T>{u, e}, correction);
}

#define VUG_INSTANTIATE(T, Set)                                                                                        \
  template SoluteFields<T> make_solute_fields<T, Set>(const Exec&, const FluidNodes&, double);                         \
  template void advance_solute<Set, T>(const Exec&, const FluidNodes&, const SoluteParameters&, SoluteFields<T>&);     \
  template void advance_solute<Set, T>(const Exec&, const FluidNodes&, const SoluteParameters&, const VectorField<T>&, \
                                       SoluteFields<T>&);                                                              \
  template void advance_solute<Set, T>(const Exec&, const FluidNodes&, const SoluteParameters&, const VectorField<T>&, \
                                       const ScalarField<T>&, SoluteFields<T>&, const ScalarField<double>&);
VUG_INSTANTIATE(float, D2Q5)
VUG_INSTANTIATE(double, D2Q5)
VUG_INSTANTIATE(float, D2Q9)
VUG_INSTANTIATE(double, D2Q9)
#undef VUG_INSTANTIATE

}  // namespace vug
