// The boundary conditions of the flow at sides and openings: their links and their values over time.
#include "coupling/flow_module.hpp"
#include "coupling/stretch_ends.hpp"
#include "coupling/velocity_profile.hpp"
#include "kernels/flow/open_boundary.hpp"
#include "kernels/nodes/fluid_nodes.hpp"

#include <algorithm>
#include <map>
#include <string>

namespace vug {

namespace {

/// Priority of a boundary for the link out of a corner, 0 first: a given velocity, so that all of its fluid enters;
/// then a wall, which may slide; then a pressure or an outflow.
int corner_rank(const FlowBoundary& flow) {
  return flow.kind == FlowBoundaryKind::velocity ? 0 : is_open(flow) ? 2 : 1;
}

/// Whether a stretch reaches the corner of its side with another.
bool reaches(const Stretch& stretch, Side other, const Lattice& lattice) {
  if (stretch.opening || is_upright(stretch.side) == is_upright(other)) return false;
  const bool lower = other == Side::left || other == Side::bottom;
  return lower ? stretch.first == 0 : stretch.last == side_length(lattice, stretch.side) - 1;
}

/// The order in which sides take the links out of the corners of one stretch. Before its own side come those whose
/// stretch at the corner (of the side or of an injection) has priority; of equals, the left or right side has it.
SideOrder corner_order(const Stretch& stretch, const std::vector<StretchLinks>& boundaries, const Lattice& lattice) {
  const int rank = corner_rank(stretch.conditions.flow);
  const auto comes_first = [&](Side other) {
    for (const StretchLinks& boundary : boundaries) {
      const Stretch& theirs = boundary.stretch;
      if (theirs.side != other || !reaches(stretch, other, lattice) || !reaches(theirs, stretch.side, lattice))
        continue;
      const int their_rank = corner_rank(theirs.conditions.flow);
      return their_rank < rank || (their_rank == rank && is_upright(other));
    }
    return false;
  };
  SideOrder order = all_sides;
  const auto own = std::stable_partition(order.begin(), order.end(), comes_first);
  std::stable_partition(own, order.end(), [&](Side side) { return side == stretch.side; });
  return order;
}

/// A given velocity or rate as it is imposed: v - (v - 2 v(t - dt) + v(t - 2 dt))/4, with v = 0 before the run. What
/// sets in at once then contains nothing that alternates from step to step: between a given velocity and rock one cell
/// away it would hardly decay. What enters in the end is the same, and what is constant or rises evenly stays as it is.
template <class Given>
double without_alternation(const Given& given, double time, double step) {
  const auto before = [&](int steps) { return time < steps * step ? 0 : given(time - steps * step); };
  const double now = given(time);
  return now - (now - 2 * before(1) + before(2)) / 4;
}

}  // namespace

template <class T>
void FlowModule<T>::find_boundaries(const Exec& exec) {
  const FluidNodes& fluid = geometry_.fluid;
  for (StretchLinks& boundary : boundaries_) {
    const FlowBoundary& flow = boundary.stretch.conditions.flow;
    boundary.find(exec, fluid, D2Q9::Q);
    if (is_open(flow)) mark_open(exec, fluid, boundary.links);  // with the order of sides that the solutes use
    if (!boundary.stretch.opening)
      boundary.find(exec, fluid, D2Q9::Q, corner_order(boundary.stretch, boundaries_, geometry_.lattice));
  }
  find_ends(exec, fluid, geometry_.spacing, boundaries_);
  std::map<std::string, double> inflow;  // (key of the case) a flow rate enters by all parts of its side
  for (StretchLinks& boundary : boundaries_) {
    const FlowBoundary& flow = boundary.stretch.conditions.flow;
    const bool outflow = flow.kind == FlowBoundaryKind::outflow;
    if (boundary.stretch.opening && flow.kind == FlowBoundaryKind::velocity)
      boundary.area = link_areas(exec, fluid, *boundary.stretch.opening, D2Q9::Q);
    boundary.share = shares_at_links(exec, fluid, boundary, geometry_.spacing);
    if (flow.has_rate()) inflow[boundary.stretch.key] += inflow_per_speed(boundary);
    if (outflow || flow.kind == FlowBoundaryKind::pressure)
      boundary.mirror = find_mirror_links(exec, fluid, boundary.links);
    if (outflow) fit_to_links(exec, fluid, boundary.links, boundary.outflow);
  }
  for (StretchLinks& boundary : boundaries_)
    if (boundary.stretch.conditions.flow.has_rate()) boundary.inflow = inflow[boundary.stretch.key];
  find_links_past_ends(fluid, geometry_.spacing, boundaries_);
  Kokkos::resize(exec, step_.limited, block_count(fluid.capacity));
}

template <class T>
double FlowModule<T>::given_speed(const StretchLinks& boundary, double time) const {
  const FlowBoundary& flow = boundary.stretch.conditions.flow;
  const auto speed = [&](double t) { return flow.risen(t) * flow.speed.at(t) / units_.velocity(); };
  if (!flow.has_rate()) return without_alternation(speed, time, units_.time_step);
  const auto rate = [&](double t) { return flow.risen(t) * flow.rate(section_.density, t) / units_.diffusivity(); };
  return boundary.inflow != 0 ? without_alternation(rate, time, units_.time_step) / boundary.inflow : 0;
}

template <class T>
std::array<double, 2> FlowModule<T>::given_velocity(const StretchLinks& boundary, double time) const {
  const FlowBoundary& flow = boundary.stretch.conditions.flow;
  const int outward = static_cast<int>(boundary.stretch.side);
  if (flow.has_rate()) {
    const double speed = given_speed(boundary, time);
    return {-D2Q9::c(outward, 0) * speed, -D2Q9::c(outward, 1) * speed};
  }
  const auto component = [&](int axis) {
    const auto given = [&](double t) { return flow.risen(t) * flow.velocity[axis].at(t) / units_.velocity(); };
    return without_alternation(given, time, units_.time_step);
  };
  return {component(0), component(1)};
}

template <class T>
FlowCondition FlowModule<T>::sliding(const StretchLinks& boundary, double time, const ScalarField<double>& gain) const {
  const std::array<double, 2> own = given_velocity(boundary, time);
  SlidingEnds ends;
  for (int e = 0; e < 2; ++e) {
    const StretchEnd& end = boundary.ends[e];
    if (end.link < 0 || end.beyond == StretchEnd::Beyond::nothing) continue;
    const auto other = end.other < 0 ? std::array{0.0, 0.0} : given_velocity(boundaries_[end.other], time);
    const auto velocity = velocity_at_end(boundary, end, own, other);
    ends.link[e] = end.link;
    for (int axis = 0; axis < 2; ++axis) ends.velocity[e][axis] = velocity[axis];
  }
  const int along = is_upright(boundary.stretch.side) ? 1 : 0;
  return sliding_condition(boundary.links, boundary.image, along, own, boundary.share, ends, gain);
}

template <class T>
FlowCondition FlowModule<T>::joined(FlowCondition made, const StretchLinks& boundary, double time) const {
  made.past = boundary.past.data();
  for (int e = 0; e < 2; ++e) {
    const StretchEnd& end = boundary.ends[e];
    if (end.link < 0) continue;
    const int across = is_upright(boundary.stretch.side) ? 0 : 1;
    made.ends.link[e] = end.link;
    made.ends.velocity[e][across] = end.other_share * given_velocity(boundaries_[end.other], time)[across];
  }
  return made;
}

template <class T>
FlowCondition FlowModule<T>::condition(const StretchLinks& boundary, double time,
                                       const ScalarField<double>& gain) const {
  const FlowBoundary& flow = boundary.stretch.conditions.flow;
  if (boundary.slides) return sliding(boundary, time, gain);
  switch (flow.kind) {
    case FlowBoundaryKind::pressure: {
      const double start = section_.initial_pressure;
      const double pressure = start + flow.risen(time) * (flow.pressure.at(time) - start);
      return joined(pressure_condition(boundary.links, boundary.mirror, units_.lattice_pressure(pressure), gain),
                    boundary, time);
    }
    case FlowBoundaryKind::velocity:
      if (boundary.stretch.opening)
        return normal_speed_condition(boundary.links, boundary.area, given_speed(boundary, time), gain);
      return velocity_condition(boundary.links, given_velocity(boundary, time), boundary.share, gain);
    case FlowBoundaryKind::outflow:
      return joined(outflow_condition(boundary.links, boundary.mirror, boundary.outflow, gain), boundary, time);
    case FlowBoundaryKind::wall:
      if (flow.peak_speed() == 0) return {};
      return velocity_condition(boundary.links, given_velocity(boundary, time), {}, gain);
    case FlowBoundaryKind::periodic:
      break;
  }
  return {};
}

#define VUG_INSTANTIATE(T)                                   \
  template void FlowModule<T>::find_boundaries(const Exec&); \
  template FlowCondition FlowModule<T>::condition(const StretchLinks&, double, const ScalarField<double>&) const;
VUG_FOR_NUMBERS(VUG_INSTANTIATE)
#undef VUG_INSTANTIATE

}  // namespace vug
