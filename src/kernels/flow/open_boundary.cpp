#include "kernels/flow/open_boundary.hpp"

#include "kernels/flow/mirrored_links.hpp"
#include "kernels/flow/outflow_pressure.hpp"
#include "kernels/launch/launch_lists.hpp"

#include <algorithm>
#include <cmath>

namespace vug {

/// f_in = A + 6 w c_in . u_w, with a share of the velocity on each link; without `share` all of it.
template <class T>
struct VelocityRule {
  T ux, uy;
  const double* share = nullptr;
  KOKKOS_FORCEINLINE_FUNCTION T operator()(int link, int, int q, T outgoing) const {
    const T here = share ? T(share[link]) : T(1);
    return outgoing - T(6 * D2Q9::w(q)) * (T(D2Q9::c(q, 0)) * (here * ux) + T(D2Q9::c(q, 1)) * (here * uy));
  }
};

/// VelocityRule without the component along the side where a link has no mirror image, and with velocities of their own
/// on the links past the ends.
template <class T>
struct SlidingRule {
  FlowCondition c;
  KOKKOS_FORCEINLINE_FUNCTION T operator()(int link, int i, int q, T outgoing) const {
    const double share = c.part ? c.part[link] : 1.0;
    double u[2] = {share * c.value[0], share * c.value[1]};
    if (c.mirror[link] < 0) u[c.axis] = 0;
    for (int end = 0; end < 2; ++end)
      if (link == c.ends.link[end])
        for (int axis = 0; axis < 2; ++axis) u[axis] = c.ends.velocity[end][axis];
    return VelocityRule<T>{T(u[0]), T(u[1])}(link, i, q, outgoing);
  }
};

/// f_in = A + area speed.
template <class T>
struct NormalSpeedRule {
  const double* area;
  double speed;
  KOKKOS_FORCEINLINE_FUNCTION T operator()(int link, int, int, T outgoing) const {
    return outgoing + T(area[link] * speed);
  }
};

using Kind = FlowCondition::Kind;

/// Dresses each stretch by its rule.
template <class T>
struct DressFlow {
  using Entry = FlowCondition;
  ScalarField<T> f;
  VectorField<T> u;
  int capacity;

  /// The links of an outflow that has no face, if any, remain walls.
  static int count(const FlowCondition& c) {
    const bool closed = c.kind == Kind::outflow && c.faces == 0;
    return c.kind == Kind::none || closed ? 0 : c.own_count;
  }

  template <class Run>
  KOKKOS_FUNCTION void operator()(const FlowCondition& c, const Run& run) const {
    if (c.kind == Kind::pressure)
      run(DressMirrored<T, PressureRule<T>>{c, f, u, capacity, {T(3 * c.value[0])}});
    else if (c.kind == Kind::outflow)
      run(DressMirrored<T, OutflowRule<T>>{c, f, u, capacity, {c}});
    else if (c.kind == Kind::velocity)
      run(DressLinks<T, VelocityRule<T>>{c, f.data(), capacity, {T(c.value[0]), T(c.value[1]), c.part}});
    else if (c.kind == Kind::sliding)
      run(DressLinks<T, SlidingRule<T>>{c, f.data(), capacity, {c}});
    else
      run(DressLinks<T, NormalSpeedRule<T>>{c, f.data(), capacity, {c.part, c.value[0]}});
  }
};

FlowCondition pressure_condition(const BoundaryLinks& links, const IndexList& mirror, double pressure,
                                 const ScalarField<double>& gain) {
  FlowCondition made{{links, gain}, Kind::pressure};
  made.mirror = mirror.data();
  made.value[0] = pressure;
  return made;
}

FlowCondition velocity_condition(const BoundaryLinks& links, std::array<double, 2> velocity,
                                 const ScalarField<double>& share, const ScalarField<double>& gain) {
  FlowCondition made{{links, gain}, Kind::velocity};
  made.part = share.extent(0) > 0 ? share.data() : nullptr;
  for (int axis = 0; axis < 2; ++axis) made.value[axis] = velocity[axis];
  return made;
}

FlowCondition sliding_condition(const BoundaryLinks& links, const IndexList& mirror, int along,
                                std::array<double, 2> velocity, const ScalarField<double>& share,
                                const SlidingEnds& ends, const ScalarField<double>& gain) {
  FlowCondition made = velocity_condition(links, velocity, share, gain);
  made.kind = Kind::sliding;
  made.mirror = mirror.data();
  made.axis = along;
  made.ends = ends;
  return made;
}

FlowCondition normal_speed_condition(const BoundaryLinks& links, const ScalarField<double>& area, double speed,
                                     const ScalarField<double>& gain) {
  FlowCondition made{{links, gain}, Kind::normal_speed};
  made.part = area.data();
  made.value[0] = speed;
  return made;
}

FlowCondition outflow_condition(const BoundaryLinks& links, const IndexList& mirror, const OutflowState& state,
                                const ScalarField<double>& gain) {
  FlowCondition made{{links, gain}, Kind::outflow};
  made.mirror = mirror.data();
  made.faces = state.faces;
  made.total = state.speed.data();
  made.level = state.level.data();
  made.along = state.along.data();
  made.pieces = state.pieces;
  made.longest = state.longest;
  made.order = state.order.data();
  made.piece = state.piece.data();
  made.face = state.face.data();
  made.room = state.room.data();
  return made;
}

namespace {

/// Size of the teams on a GPU: whole warps for the longest piece.
int threads_of_pieces(std::span<const FlowCondition> conditions) {
  int longest = 0;
  for (const FlowCondition& c : conditions) longest = std::max(longest, c.longest);
  return std::clamp((longest + 31) / 32 * 32, 32, threads_per_sum);
}

}  // namespace

template <class T>
void dress(const Exec& exec, const FluidNodes& nodes, std::span<const FlowCondition> conditions,
           const FlowFields<T>& fields) {
  const double crossing = std::max(nodes.lattice.nx, nodes.lattice.ny) / std::sqrt(c_s2);
  add_per_block_of_lists(exec, "vug::open_boundary::outward_speed", conditions, OutwardSpeeds<T>{fields.u});
  for_each_of_lists(exec, "vug::open_boundary::outflow_level", conditions, SetOutflowLevels{1 / (4 * crossing)});
  const PressuresAlong<T> pressures{fields.u, Upstream(nodes)};
  if constexpr (runs_on_host)
    for_each_of_lists(exec, "vug::open_boundary::pressure_along", conditions, pressures);
  else
    for_each_team_of_lists(exec, "vug::open_boundary::pressure_along", conditions, threads_of_pieces(conditions),
                           pressures);
  for_each_of_lists(exec, "vug::open_boundary::past_ends", conditions, TakePastEnds<T>{fields.f, nodes.capacity});
  for_each_of_lists(exec, "vug::open_boundary::dress", conditions, DressFlow<T>{fields.f, fields.u, nodes.capacity});
}

VUG_COMPILE_FOR_NUMBERS(dress)

}  // namespace vug
