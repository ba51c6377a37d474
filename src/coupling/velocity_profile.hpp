#pragma once
// Distribution of a given velocity or flow rate over the links of a side.
#include "coupling/stretch_links.hpp"

namespace vug {

/// Local velocity over the given one, for a side or injection of `length` (m), at a distance `at` (m) from its lower or
/// left end.
double share_of_velocity(const FlowBoundary& flow, double at, double length);
/// Mean share over one cell of a stretch of `cells` cells, by Simpson's rule: the same as of the links of its node.
double share_of_cell(const FlowBoundary& flow, int cell, int cells, double spacing);
/// The largest share, and the mean share over a stretch.
double largest_share(const FlowBoundary& flow);
double mean_share(const FlowBoundary& flow, const Stretch& stretch, double spacing);

/// (link) The share where each link crosses the side, half way between its ends; empty where all are 1. For a parabola,
/// their sum weighted with the links' volumes (1/6, 2/3, 1/6 of a face) is its mean (Simpson's rule). Waits for the
/// device.
ScalarField<double> shares_at_links(const Exec& exec, const FluidNodes& fluid, const StretchLinks& boundary,
                                    double spacing);

/// Volume, cells, that enters through a stretch or an opening per step and unit of (inward) speed. Waits for the
/// device.
double inflow_per_speed(const StretchLinks& boundary);

}  // namespace vug
