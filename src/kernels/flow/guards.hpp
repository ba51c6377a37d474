#pragma once
// Watching the fields for divergence, at monitor steps. All wait for the device.
#include "kernels/flow/flow.hpp"

#include <limits>

namespace vug {

struct FlowExtremes {
  double speed = 0;    ///< largest |u|, lattice units; NaN is ignored
  double density = 0;  ///< largest |rho'|
  int bad = -1;        ///< lowest fluid index whose state is not finite or beyond a bound; -1: none
};

/// Range of the entries of a field that this process computes.
struct FieldRange {
  double min = 0, max = 0;  ///< over the finite entries; +infinity and -infinity if there is none
  int first_outside = -1;   ///< the first that is not finite or not within (lowest, highest); -1: none
};
template <class T>
FieldRange field_range(const Exec& exec, const ScalarField<T>& field, const Share& list,
                       double lowest = -std::numeric_limits<double>::infinity(),
                       double highest = std::numeric_limits<double>::infinity());

/// Extremes of the density and velocity of the last sweep, over the nodes of this process. A broken population shows in
/// the density of the node where it arrives. The same for any number of threads.
template <class T>
FlowExtremes flow_extremes(const Exec& exec, const FluidNodes& nodes, const FlowFields<T>& fields, double speed_bound,
                           double density_bound);

/// What a change of velocity is compared with, lattice units.
struct VelocityScale {
  double largest;    ///< U: |u| of all nodes is at most this
  double slow = 1;   ///< share of U down to which a pore is judged by its own speed
  double noise = 0;  ///< share of U that is rounding
};

/// Largest change of velocity of the fluid nodes, (|u - previous| - noise U) / s with s = |u| where that is at least
/// slow U, else U; 0 where nothing moves. previous (fluid, axis) is u afterwards.
template <class T>
double velocity_change(const Exec& exec, const FluidNodes& nodes, const VectorField<T>& u,
                       const VectorField<T>& previous, const VelocityScale& scale);

}  // namespace vug
