#include "kernels/flow/open_boundary.hpp"

#include "kernels/flow/outflow_pressure.hpp"
#include "kernels/launch/launch_lists.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace vug {

/// Rule of a pressure: given density, no velocity along the surface.
template <class T>
struct PressureRule {
  static constexpr bool slides = false;
  T value;  ///< 3 p
  KOKKOS_FORCEINLINE_FUNCTION T density(int) const { return value; }
};

/// Rule of an outflow: density of this step, with its variation along the surface; the nodes' velocity along it.
template <class T>
struct OutflowRule {
  static constexpr bool slides = true;
  FlowCondition links;
  KOKKOS_FORCEINLINE_FUNCTION T density(int link) const {
    const int face = links.face[link];
    return T(face < 0 ? links.level[1] : links.level[1] + links.along[face]);
  }
};

/// Dresses both links of each pair of mirror images by a rule, in the call for the first of them, and books the change
/// of mass of either. Touches a population, a velocity and 25 bytes of lists and ledger per link.
template <class T, class Rule>
struct DressMirrored {
  FlowCondition links;
  ScalarField<T> f;
  VectorField<T> u;
  int capacity;
  Rule rule;

  KOKKOS_FUNCTION void operator()(int item) const {
    const int link = links.link(item), image = links.mirror[link];
    if (image < 0) return dress_past_end(link);
    if (image < link) return;  // dressed in the call for its image
    const T here = returned(link, image), there = returned(image, link), slip = slide(link, image);
    bring_in(link, there - slip);
    if (image != link) bring_in(image, here + slip);
  }

 private:
  /// The population that leaves along `image`, returned along `link`: -A + w [rho' + 9/2 (c.u)^2 - 3/2 u^2] of both
  /// directions; the velocity along the surface is reversed with the image unless fluid may slide.
  KOKKOS_FORCEINLINE_FUNCTION T returned(int image, int link) const {
    const int i = links.fluid[image], q = links.direction[image];
    return returned(i, q, f(q * capacity + i), rule.density(image), links.direction[link]);
  }
  KOKKOS_FORCEINLINE_FUNCTION T returned(int i, int q, T leaving, T rho, int along) const {
    return even(q, i, rho) + even(Rule::slides ? along : q, i, rho) - leaving;
  }
  KOKKOS_FORCEINLINE_FUNCTION T even(int q, int i, T rho) const {
    const T ux = u(i, 0), uy = u(i, 1);
    return T(0.5) * (equilibrium(q, rho, ux, uy) + equilibrium(D2Q9::opposite(q), rho, ux, uy));
  }
  /// 6 w t.u, where u is the mean velocity of both nodes and t the part of the link's direction along the surface.
  KOKKOS_FORCEINLINE_FUNCTION T slide(int link, int image) const {
    return slide(link, links.fluid[image], links.direction[image]);
  }
  KOKKOS_FORCEINLINE_FUNCTION T slide(int link, int j, int p) const {
    if constexpr (!Rule::slides) return T(0);
    const int i = links.fluid[link], q = links.direction[link];
    const T along =
        T(D2Q9::c(q, 0) - D2Q9::c(p, 0)) * (u(i, 0) + u(j, 0)) + T(D2Q9::c(q, 1) - D2Q9::c(p, 1)) * (u(i, 1) + u(j, 1));
    return T(1.5 * D2Q9::w(q)) * along;
  }
  /// A link without an image in this stretch: one past an end, or a wall.
  KOKKOS_FUNCTION void dress_past_end(int link) const {
    for (int end = 0; end < 2; ++end) {
      if (links.ends.link[end] == link) {
        const int q = links.direction[link];
        const double* const given = links.ends.velocity[end];
        const T across = T(D2Q9::c(q, 0) * given[0] + D2Q9::c(q, 1) * given[1]);
        return bring_in(link, f(q * capacity + links.fluid[link]) - T(6 * D2Q9::w(q)) * across);
      }
      if (links.past == nullptr || links.past[end].link != link) continue;
      const LinkPastEnd& image = links.past[end];
      const T returns =
          returned(image.fluid, image.direction, T(image.leaving), rule.density(link), links.direction[link]);
      return bring_in(link, returns - slide(link, image.fluid, image.direction));
    }
  }
  KOKKOS_FORCEINLINE_FUNCTION void bring_in(int link, T incoming) const {
    const int slot = links.direction[link] * capacity + links.fluid[link];
    links.gain[link] += double(incoming) - double(f(slot));
    f(slot) = incoming;
  }
};

/// Takes the populations that leave along images of other stretches, before these are dressed.
template <class T>
struct TakePastEnds {
  using Entry = FlowCondition;
  ScalarField<T> f;
  int capacity;
  static int count(const FlowCondition& c) { return c.past ? 2 : 0; }
  template <class Run>
  KOKKOS_FUNCTION void operator()(const FlowCondition& c, const Run& run) const {
    run([c, populations = f, stride = capacity](int end) {
      LinkPastEnd& image = c.past[end];
      if (image.link >= 0) image.leaving = double(populations(image.direction * stride + image.fluid));
    });
  }
};

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

/// Lists the pieces of an outflow, from the faces beside each face.
void list_pieces(const IndexList& next_face, const IndexList& previous_face, OutflowState& state) {
  const auto next = on_host(next_face), previous = on_host(previous_face), face = on_host(state.face);
  std::vector<int> order, piece{0};
  state.longest = 0;
  for (int link = 0; link < static_cast<int>(face.extent(0)); ++link) {
    if (face(link) != link || previous(link) >= 0) continue;
    for (int f = link; f >= 0; f = next(f)) order.push_back(f);
    piece.push_back(static_cast<int>(order.size()));
    state.longest = std::max(state.longest, piece.back() - piece[piece.size() - 2]);
  }
  state.pieces = static_cast<int>(piece.size()) - 1;
  state.order = to_device<IndexList>("vug::open_boundary::order", order);
  state.piece = to_device<IndexList>("vug::open_boundary::piece", piece);
}

/// Size of the teams on a GPU: whole warps for the longest piece.
int threads_of_pieces(std::span<const FlowCondition> conditions) {
  int longest = 0;
  for (const FlowCondition& c : conditions) longest = std::max(longest, c.longest);
  return std::clamp((longest + 31) / 32 * 32, 32, threads_per_sum);
}

}  // namespace

void fit_to_links(const Exec& exec, const FluidNodes& nodes, const BoundaryLinks& links, OutflowState& state) {
  state.speed = ScalarField<double>("vug::open_boundary::speed", block_count(links.count));
  Kokkos::resize(exec, state.level, 2);
  state.along = ScalarField<double>("vug::open_boundary::along", links.count);
  state.room = ScalarField<double>("vug::open_boundary::room", 3 * links.count);
  IndexList next, previous;
  for (IndexList* list : {&next, &previous, &state.face}) *list = IndexList("vug::open_boundary::pieces", links.count);
  int faces = 0;
  Kokkos::parallel_reduce("vug::open_boundary::faces", Kokkos::RangePolicy<Exec>(exec, 0, links.count),
                          FindPieces{links, Upstream(nodes), next, previous, state.face}, faces);
  state.faces = faces;
  list_pieces(next, previous, state);
}

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
