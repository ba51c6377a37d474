#include "kernels/solute/slit_diffusion.hpp"

#include "kernels/launch/launch.hpp"
#include "kernels/launch/own_items.hpp"
#include "kernels/nodes/fluid_neighbour.hpp"

namespace vug {

template <class T, class Set>
struct ResistInSlits {
  SlitNodes slits;
  Kokkos::View<const int*> source;
  int capacity;
  Share share;
  double D;
  bool moves;
  Displacement<T> u;
  Kokkos::View<const T*> C;
  ScalarField<T> h;
  int turned;

  KOKKOS_FUNCTION void operator()(int k) const {
    const int i = slits.fluid(k);
    const double own = slits.openness_of(i);
    if (own >= 1) return;
    for (int q = 1; q < Set::Q; ++q) {
      const int n = fluid_neighbour(source, capacity, q, i);
      if (n < 0) continue;
      const double other = slits.openness_of(n);
      if (other < 1 && n <= i) continue;  // a link between two slits is met from its lower end
      if (is_own(share, i) || is_own(share, n)) resist(q, i, n, 2 * D / (1 / own + 1 / other));
    }
  }

  /// The link along q from node i to node n.
  KOKKOS_FORCEINLINE_FUNCTION void resist(int q, int i, int n, double conductance) const {
    const int here = q * capacity + i, there = Set::opposite(q) * capacity + n;
    const int out = turned ? there : here, in = turned ? here : there;
    const double way =
        moves ? 0.5 * (along(q, double(u(i, 0)), double(u(i, 1))) + along(q, double(u(n, 0)), double(u(n, 1)))) : 0;
    const double flows = 6 * Set::w(q) * way * 0.5 * (double(C(i)) + double(C(n)));
    const double r = reflected_share(Set::w(q), D, Kokkos::fmax(conductance, 0.5 * Kokkos::fabs(way)));
    const T before = h(out);
    h(out) = T(double(before) - r * (double(before) - double(h(in)) - flows));
    h(in) = T(double(h(in)) + (double(before) - double(h(out))));
  }
};

template <class Set, class T>
void resist_in_slits(const Exec& exec, const FluidNodes& nodes, const SlitNodes& slits,
                     const SoluteParameters& parameters, const std::type_identity_t<Displacement<T>>* u,
                     const SoluteFields<T>& s) {
  for_each_node(exec, "vug::solute::resist_in_slits", slits.count,
                ResistInSlits<T, Set>{slits, nodes.source, nodes.capacity, nodes.share(), parameters.diffusivity(),
                                      u != nullptr, u ? *u : Displacement<T>{VectorField<T>{}}, s.C, s.h, s.turned});
}

#define VUG_INSTANTIATE(Set, T)                                                                                 \
  template void resist_in_slits<Set>(const Exec&, const FluidNodes&, const SlitNodes&, const SoluteParameters&, \
                                     const Displacement<T>*, const SoluteFields<T>&);
VUG_INSTANTIATE(D2Q5, float)
VUG_INSTANTIATE(D2Q9, float)
VUG_INSTANTIATE(D2Q5, double)
VUG_INSTANTIATE(D2Q9, double)
#undef VUG_INSTANTIATE

}  // namespace vug
