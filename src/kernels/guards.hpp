#pragma once
// Watching the flow for divergence, at monitor steps.
#include "kernels/flow.hpp"

namespace vug {

struct FlowExtremes {
  double speed = 0;    ///< largest |u| (without half the body force), lattice units; NaN is passed over
  double density = 0;  ///< largest |rho'|
  int bad = -1;        ///< lowest fluid index whose state is not finite or beyond a bound; -1: none
};

/// Extremes of the state after a sweep, from the populations themselves, so that no broken one goes unseen. The same
/// for any number of threads. Waits for the device.
template <class T>
FlowExtremes flow_extremes(const Exec& exec, const FluidNodes& nodes, const FlowFields<T>& fields, double speed_bound,
                           double density_bound);

}  // namespace vug
