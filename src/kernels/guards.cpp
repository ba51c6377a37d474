#include "kernels/guards.hpp"

#include <limits>

namespace vug {

/// Largest speed and density and lowest bad index; max and min do not depend on the order of reduction.
template <class T>
struct FindExtremes {
  Kokkos::View<const T*> f;
  int capacity;
  double speed_bound, density_bound;
  KOKKOS_FUNCTION void operator()(int i, double& speed2, double& density, int& bad) const {
    double g[9];
    for (int q = 0; q < D2Q9::Q; ++q) g[q] = double(f(q * capacity + i));
    const Macroscopic<double> m = macroscopic(g);
    const double u2 = m.ux * m.ux + m.uy * m.uy, rho = Kokkos::abs(m.rho);
    const bool good = u2 <= speed_bound * speed_bound && rho <= density_bound;  // false for NaN
    if (!good && i < bad) bad = i;
    if (u2 > speed2) speed2 = u2;
    if (rho > density) density = rho;
  }
};

template <class T>
FlowExtremes flow_extremes(const Exec& exec, const FluidNodes& nodes, const FlowFields<T>& fields, double speed_bound,
                           double density_bound) {
  FlowExtremes found;
  if (nodes.count == 0) return found;
  double speed2 = 0;
  int bad = std::numeric_limits<int>::max();
  Kokkos::parallel_reduce("vug::guards::flow_extremes", Kokkos::RangePolicy<Exec>(exec, 0, nodes.count),
                          FindExtremes<T>{fields.f, nodes.capacity, speed_bound, density_bound},
                          Kokkos::Max<double>(speed2), Kokkos::Max<double>(found.density), Kokkos::Min<int>(bad));
  found.speed = speed2 > 0 ? Kokkos::sqrt(speed2) : 0;
  if (!(found.density > 0)) found.density = 0;  // the reduction's identity, where all is NaN
  found.bad = bad == std::numeric_limits<int>::max() ? -1 : bad;
  return found;
}

template FlowExtremes flow_extremes(const Exec&, const FluidNodes&, const FlowFields<float>&, double, double);
template FlowExtremes flow_extremes(const Exec&, const FluidNodes&, const FlowFields<double>&, double, double);

}  // namespace vug
