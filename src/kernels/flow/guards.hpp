#pragma once
// Watching the fields for divergence, at monitor steps. All wait for the device.
#include "kernels/flow/flow.hpp"

namespace vug {

struct FlowExtremes {
  double speed = 0;    ///< largest |u|, lattice units; NaN is passed over
  double density = 0;  ///< largest |rho'|
  int bad = -1;        ///< lowest fluid index whose state is not finite or beyond a bound; -1: none
};

/// The first of the first `count` entries of a field that is not finite or not within (lowest, highest); -1: none.
template <class T>
int first_outside(const Exec& exec, const ScalarField<T>& field, int count, double lowest, double highest);

/// Extremes of the density and velocity of the last sweep, of our share of the nodes; a broken population shows in the
/// density of the node where it arrives. The same for any number of threads.
template <class T>
FlowExtremes flow_extremes(const Exec& exec, const FluidNodes& nodes, const FlowFields<T>& fields, double speed_bound,
                           double density_bound);

/// Largest |u - previous| over the fluid nodes divided by the largest |u| (0 where nothing moves); previous (fluid,
/// axis) is u afterwards.
template <class T>
double velocity_change(const Exec& exec, const FluidNodes& nodes, const VectorField<T>& u,
                       const VectorField<T>& previous);

}  // namespace vug
