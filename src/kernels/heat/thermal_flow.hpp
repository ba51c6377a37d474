#pragma once
// The effect of the fluid's temperature on its flow.
#include "kernels/heat/heat.hpp"
#include "kernels/launch/launch.hpp"

namespace vug {

/// theta(i) = temperature of fluid node i, from node `first` of the list on.
template <class T>
void gather_temperatures(const Exec& exec, const FluidNodes& nodes, const HeatFields<T>& fields, int first,
                         const ScalarField<T>& theta);

/// Mixes `share` of `before` into the present temperatures theta, and sets `before` to these as they were. For
/// buoyancy: collisions and streaming both keep the momentum along y that changes its sign from row to row and from
/// step to step, so that nothing damps it (nor that along x from column to column). The temperature that it carries
/// along a gradient changes its sign in the same way and, one step later, drives it on where the layers are stable, by
/// N^2 dx^2 / (8 kappa) per second, with N the frequency of their waves. The mean of two steps, share = 1/2, does not
/// contain it.
template <class T>
void mix_with_before(const Exec& exec, const FluidNodes& nodes, double share, const ScalarField<T>& before,
                     const ScalarField<T>& theta);

/// Viscosity as a function of the temperature: linear between the points of a table and constant outside it, or,
/// without points, nu exp(E_a / R (1 / T - 1 / T_0)).
struct ViscosityLaw {
  double viscosity = 0;          ///< nu at T_0, lattice units
  double activation = 0;         ///< E_a / R, K
  double reference = 1;          ///< T_0, K
  double zero = 0;               ///< K at theta = 0
  VectorField<double> points{};  ///< (point, {K, viscosity}) in ascending order

  KOKKOS_FUNCTION double operator()(double theta) const {
    const double temperature = zero + theta;
    const int count = static_cast<int>(points.extent(0));
    if (count == 0) return viscosity * Kokkos::exp(activation * (1 / temperature - 1 / reference));
    if (!(temperature > points(0, 0))) return points(0, 1);
    int next = 1;
    while (next < count && temperature > points(next, 0)) ++next;
    if (next == count) return points(count - 1, 1);
    const double share = (temperature - points(next - 1, 0)) / (points(next, 0) - points(next - 1, 0));
    return points(next - 1, 1) + share * (points(next, 1) - points(next - 1, 1));
  }
};

/// spread(i) = tau - 1/2 = 3 nu at the temperature theta(i), for the nodes of a list.
template <class T>
void set_spread(const Exec& exec, const Share& list, const ScalarField<T>& theta, const ViscosityLaw& law,
                const ScalarField<T>& spread);

}  // namespace vug
