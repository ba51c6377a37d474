#include "kernels/scalar/advective_form.hpp"

#include "base/unroll.hpp"
#include "kernels/launch/launch.hpp"
#include "kernels/nodes/fluid_nodes.hpp"
#include "kernels/scalar/scalar_equilibrium.hpp"

namespace vug {

template <class Set, class T>
struct AdvectiveDefect {
  int capacity;
  Kokkos::View<const int*> source;
  Kokkos::View<const std::uint16_t*> solid_links, side_links, open_links;
  Displacement<T> u;
  ScalarField<T> e;
  T even_weight;

  /// Whether direction q depends on the velocity along an axis: on D2Q5 on that along its own axis only.
  KOKKOS_FORCEINLINE_FUNCTION static constexpr bool matters(int q, int axis) {
    return Set::Q != D2Q5::Q || Set::c(q, axis) != 0;
  }

  /// w_q (h_q^eq / (w_q C) - 1) computed from its odd and its even part. As a difference from one it would be rounded
  /// like numbers near one, finer below one than above, and its sum would never be zero.
  KOKKOS_FORCEINLINE_FUNCTION T deviation(int q, T ux, T uy) const {
    const T odd = T(3 * Set::w(q)) * along(q, ux, uy);
    if constexpr (Set::Q == D2Q5::Q)
      return odd;
    else
      return odd + even_weight * T(Set::w(q)) * scalar_even_part<T>(q, ux, uy);
  }

  KOKKOS_FORCEINLINE_FUNCTION void operator()(int i) const {
    T ux[Set::Q], uy[Set::Q];
    ux[0] = u(i, 0);
    uy[0] = u(i, 1);
    VUG_UNROLL
    for (int q = 1; q < Set::Q; ++q) {
      const int from = upstream_node(source, capacity, q, i), upstream = from >= 0 ? from : i;
      ux[q] = u(upstream, 0);
      uy[q] = u(upstream, 1);
    }
    finish(i, ux, uy);
  }

  /// Stores e(i), from the velocities of the upstream nodes.
  KOKKOS_FORCEINLINE_FUNCTION void finish(int i, const T (&ux)[Set::Q], const T (&uy)[Set::Q]) const {
    const int closed = static_cast<int>(closed_links(solid_links(i), side_links(i), open_links(i)));
    T sum = deviation(0, ux[0], uy[0]);
    VUG_UNROLL
    for (int q = 1; q < Set::Q; ++q) {
      const int opposite = Set::opposite(q);
      const T sign = (closed >> opposite) & 1 ? T(-1) : T(1);  // what bounces back comes with the velocity reversed
      sum += deviation(q, sign * ux[q], sign * uy[q]);
    }
    e(i) = sum;
  }
};

/// A block of nodes on a host: gathers scattered velocities, a pack at a time, for enough nodes that their law
/// vectorises.
template <class Set, class T>
struct DefectsOfBlock {
  using Defect = AdvectiveDefect<Set, T>;
  Defect defect;
  Kokkos::View<const SourceWindow*> windows;
  void operator()(int first, int last) const {
    const Defect local = defect;
    const SourcePacks<T, Set> packs{windows.data(), local.source.data(), local.capacity};
    constexpr int some = shortest_block;
    int i = first;
    for (; i + some <= last; i += some) {
      alignas(64) T u[2][Set::Q][some];
      packs.upstream({&local.u.u(0, 0), &local.u.u(0, 1)}, i, u, Defect::matters);
      VUG_VECTORISE
      for (int l = 0; l < some; ++l) {
        T own_x[Set::Q], own_y[Set::Q];
        VUG_UNROLL
        for (int q = 0; q < Set::Q; ++q) {
          own_x[q] = Defect::matters(q, 0) ? local.u.steps * u[0][q][l] : T(0);
          own_y[q] = Defect::matters(q, 1) ? local.u.steps * u[1][q][l] : T(0);
        }
        local.finish(i + l, own_x, own_y);
      }
    }
    for (; i < last; ++i) local(i);
  }
};

template <class Set, class T>
void advective_defect(const Exec& exec, const FluidNodes& nodes, const std::type_identity_t<Displacement<T>>& u,
                      const ScalarField<T>& e, T even_weight) {
  const char* label = "vug::advective_form::defect";
  const AdvectiveDefect<Set, T> body{
      nodes.capacity, nodes.source, nodes.solid_links, nodes.side_links, nodes.open_links, u, e, even_weight};
  if constexpr (runs_on_host)
    for_each_block(exec, label, nodes.share(), DefectsOfBlock<Set, T>{body, nodes.windows}, block_of_list(nodes.count));
  else
    for_each_node(exec, label, nodes.share(), body);
}

VUG_COMPILE_FOR_SETS(advective_defect)

}  // namespace vug
