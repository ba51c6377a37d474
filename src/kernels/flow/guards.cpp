#include "kernels/flow/guards.hpp"

#include "kernels/launch/launch.hpp"

namespace vug {

/// Largest speed and density and lowest bad index; max and min do not depend on the order of reduction.
template <class T>
struct FindExtremes {
  Density<T> rho;
  VectorField<T> u;
  double speed_bound, density_bound;
  OwnItems own;
  KOKKOS_FUNCTION void operator()(int place, double& speed2, double& density, int& bad) const {
    const int i = own(place);
    if (i < 0) return;
    const double ux = double(u(i, 0)), uy = double(u(i, 1)), u2 = ux * ux + uy * uy, size = Kokkos::abs(double(rho(i)));
    const bool good = u2 <= speed_bound * speed_bound && size <= density_bound;  // false for NaN
    if (!good && i < bad) bad = i;
    if (u2 > speed2) speed2 = u2;
    if (size > density) density = size;
  }
};

template <class T>
FlowExtremes flow_extremes(const Exec& exec, const FluidNodes& nodes, const FlowFields<T>& fields, double speed_bound,
                           double density_bound) {
  FlowExtremes found;
  if (nodes.count == 0) return found;
  double speed2 = 0;
  int bad = std::numeric_limits<int>::max();
  const OwnItems own{nodes.share()};
  Kokkos::parallel_reduce("vug::guards::flow_extremes", Kokkos::RangePolicy<Exec>(exec, 0, own.places()),
                          FindExtremes<T>{Density<T>(nodes, fields), fields.u, speed_bound, density_bound, own},
                          Kokkos::Max<double>(speed2), Kokkos::Max<double>(found.density), Kokkos::Min<int>(bad));
  found.speed = speed2 > 0 ? Kokkos::sqrt(speed2) : 0;
  if (!(found.density > 0)) found.density = 0;  // the reduction's identity, where all is NaN
  found.bad = bad == std::numeric_limits<int>::max() ? -1 : bad;
  return found;
}

template <class T>
struct RangeOfField {
  Kokkos::View<const T*> field;
  double lowest, highest;
  OwnItems own;
  KOKKOS_FUNCTION void operator()(int place, double& least, double& most, int& first) const {
    const int i = own(place);
    if (i < 0) return;
    const double value = double(field(i));
    if (!(value > lowest && value < highest) && i < first) first = i;  // true for NaN
    if (!Kokkos::isfinite(value)) return;
    if (value < least) least = value;
    if (value > most) most = value;
  }
};

template <class T>
FieldRange field_range(const Exec& exec, const ScalarField<T>& field, const Share& list, double lowest,
                       double highest) {
  FieldRange range;
  const OwnItems own{list};
  int first = list.n;
  Kokkos::parallel_reduce("vug::guards::field_range", Kokkos::RangePolicy<Exec>(exec, 0, own.places()),
                          RangeOfField<T>{field, lowest, highest, own}, Kokkos::Min<double>(range.min),
                          Kokkos::Max<double>(range.max), Kokkos::Min<int>(first));
  if (first < list.n) range.first_outside = first;
  return range;
}

template <class T>
struct CompareVelocity {
  VectorField<T> u, previous;
  double largest, slow, noise;  // speeds
  KOKKOS_FUNCTION void operator()(int i, double& most) const {
    const double ux = double(u(i, 0)), uy = double(u(i, 1));
    const double dx = ux - double(previous(i, 0)), dy = uy - double(previous(i, 1));
    previous(i, 0) = u(i, 0);
    previous(i, 1) = u(i, 1);
    const double speed = Kokkos::sqrt(ux * ux + uy * uy);
    const double change = (Kokkos::sqrt(dx * dx + dy * dy) - noise) / (speed < slow ? largest : speed);
    if (change > most) most = change;
  }
};

template <class T>
double velocity_change(const Exec& exec, const FluidNodes& nodes, const VectorField<T>& u,
                       const VectorField<T>& previous, const VelocityScale& scale) {
  const double U = scale.largest;
  double change = 0;
  Kokkos::parallel_reduce("vug::guards::velocity_change", Kokkos::RangePolicy<Exec>(exec, 0, nodes.count),
                          CompareVelocity<T>{u, previous, U, scale.slow * U, scale.noise * U},
                          Kokkos::Max<double>(change));
  return U > 0 ? Kokkos::max(change, 0.0) : 0;
}

VUG_COMPILE_FOR_NUMBERS(velocity_change)
VUG_COMPILE_FOR_NUMBERS(field_range)
VUG_COMPILE_FOR_NUMBERS(flow_extremes)

}  // namespace vug
