#pragma once
// How a given velocity or flow rate is spread over the links of a side.
#include "coupling/stretch_links.hpp"

namespace vug {

/// Share of its velocity that a side or injection of `length` (m) has `at` m from its lower or left end.
double share_of_velocity(const FlowBoundary& flow, double at, double length);
/// The mean over one cell of a stretch of so many, by Simpson's rule: as much as the links of its node.
double share_of_cell(const FlowBoundary& flow, int cell, int cells, double spacing);
/// The largest of these shares, and their mean.
double largest_share(const FlowBoundary& flow);
double mean_share(const FlowBoundary& flow, double length);

/// (link) The share where each link crosses the side, in the middle between its ends; empty where all are 1. Of a
/// parabola they add up, weighed as the links' volumes (1/6, 2/3, 1/6 of a face), to its mean: Simpson's rule. Waits
/// for the device.
ScalarField<double> shares_at_links(const Exec& exec, const FluidNodes& fluid, const StretchLinks& boundary,
                                    double spacing);

/// Volume, cells, that a stretch or an opening takes in per step and unit of (inward) speed. Waits for the device.
double inflow_per_speed(const StretchLinks& boundary);

}  // namespace vug
