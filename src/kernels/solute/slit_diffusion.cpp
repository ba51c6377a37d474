#include "kernels/solute/slit_diffusion.hpp"

#include "kernels/launch/launch.hpp"
#include "kernels/nodes/fluid_nodes.hpp"
#include "kernels/solute/solute_sweep.hpp"

namespace vug {

template <class T, class Set, class Flow>
struct ResistInSlits {
  SlitNodes slits;
  Kokkos::View<const int*> source;
  int capacity;
  Share share;
  double D;
  Flow flow;
  Kokkos::View<const T*> C;
  ScalarField<T> h;
  Rounding<T> rounding;
  int turned;

  KOKKOS_FUNCTION void operator()(int k) const {
    const int i = slits.fluid(k);
    const double own = slits.openness_of(i);
    if (own >= 1) return;
    for (int q = 1; q < Set::Q; ++q) {
      const int n = fluid_neighbour(source, capacity, q, i);
      if (n < 0) continue;
      const double other = slits.openness_of(n);
      if (other < 1 && n <= i) continue;  // a link between two slits is handled from its lower end
      if (is_own(share, i) || is_own(share, n)) resist(q, i, n, 2 * D / (1 / own + 1 / other));
    }
  }

  /// The link along q from node i to node n.
  KOKKOS_FORCEINLINE_FUNCTION void resist(int q, int i, int n, double conductance) const {
    const int here = q * capacity + i, there = Set::opposite(q) * capacity + n;
    const int out = turned ? there : here, in = turned ? here : there;
    double way = 0;
    if constexpr (Flow::moves)
      way = 0.5 * (along(q, double(flow.u(i, 0)), double(flow.u(i, 1))) +
                   along(q, double(flow.u(n, 0)), double(flow.u(n, 1))));
    const double flows = 6 * Set::w(q) * way * 0.5 * (double(C(i)) + double(C(n)));
    const double r = reflected_share(Set::w(q), D, Kokkos::fmax(conductance, 0.5 * Kokkos::fabs(way)));
    const T before = h(out);
    h(out) = T(double(before) - r * (double(before) - double(h(in)) - flows));
    h(in) = rounding.sum(h(in), before - h(out), i);
  }
};

template <class Set, class T>
void resist_in_slits(const Exec& exec, const FluidNodes& nodes, const SlitNodes& slits, const SoluteCarrier<T>& carrier,
                     const SoluteParameters& parameters, const SoluteFields<T>& s) {
  visit_flow(carrier, [&](const auto& flow) {
    for_each_node(exec, "vug::solute::resist_in_slits", slits.count,
                  ResistInSlits<T, Set, std::decay_t<decltype(flow)>>{slits, nodes.source, nodes.capacity,
                                                                      nodes.share(), parameters.diffusivity(), flow,
                                                                      s.C, s.h, s.rounding.at_links, s.turned});
  });
}

VUG_COMPILE_FOR_SETS(resist_in_slits)

}  // namespace vug
