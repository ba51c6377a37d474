#include "coupling/stretch_ends.hpp"

#include "coupling/velocity_profile.hpp"
#include "kernels/nodes/fluid_nodes.hpp"

#include <array>
#include <optional>
#include <utility>

namespace vug {

namespace {

using Beyond = StretchEnd::Beyond;
constexpr int lower = 0, upper = 1;

bool gives_velocity(const Stretch& stretch) {
  return !stretch.opening && stretch.conditions.flow.kind == FlowBoundaryKind::velocity;
}
bool gives_velocity_or_wall(const Stretch& stretch) {
  return gives_velocity(stretch) || (!stretch.opening && stretch.conditions.flow.kind == FlowBoundaryKind::wall);
}
/// Whether the flow through a stretch of a side follows from a pressure.
bool yields(const Stretch& stretch) {
  const FlowBoundaryKind kind = stretch.conditions.flow.kind;
  return !stretch.opening && (kind == FlowBoundaryKind::pressure || kind == FlowBoundaryKind::outflow);
}
bool is_outflow(const Stretch& stretch) {
  return !stretch.opening && stretch.conditions.flow.kind == FlowBoundaryKind::outflow;
}
/// Whether its own velocity has a component along the side.
bool moves_along(const Stretch& stretch) {
  const FlowBoundary& flow = stretch.conditions.flow;
  return gives_velocity_or_wall(stretch) && !flow.has_rate() && flow.velocity[is_upright(stretch.side)].peak() != 0;
}

/// The host's view of all stretches of the sides, to find which of them meet.
class Meetings {
 public:
  Meetings(const FluidNodes& fluid, double spacing, const std::vector<StretchLinks>& boundaries)
      : fluid_(fluid), spacing_(spacing), boundaries_(boundaries) {}

  /// Number of the stretch beyond an end, on the same side or at the corner; -1: there is none.
  int beyond(int number, int end) const {
    const Stretch& own = stretch(number);
    const bool at_corner = reaches_corner(own, end), joined = fluid_.periodic[is_upright(own.side)];
    for (int k = 0; k < static_cast<int>(boundaries_.size()); ++k) {
      const Stretch& other = stretch(k);
      if (other.opening) continue;
      if (at_corner && !joined) {
        if (other.side == adjacent(own.side, end) && reaches_corner(other, end_at(own.side))) return k;
      } else if (other.side == own.side) {
        if (at_corner ? reaches_corner(other, 1 - end)
                      : (end == lower ? other.last + 1 == own.first : own.last + 1 == other.first))
          return k;
      }
    }
    return -1;
  }
  bool is_corner(int number, int end) const {
    return reaches_corner(stretch(number), end) && !fluid_.periodic[is_upright(stretch(number).side)];
  }
  /// End of the stretch beyond that meets this one.
  int end_of_other(int number, int end) const {
    return is_corner(number, end) ? end_at(stretch(number).side) : 1 - end;
  }

  /// The link that leads past an end, in the list of the stretch; -1: it is not there.
  int link(int number, int end) {
    const BoundaryLinks& links = boundaries_[number].links;
    const Stretch& own = stretch(number);
    if (!node_) node_ = on_host(fluid_.node);
    const auto at = on_host(links.fluid);
    const auto direction = on_host(links.direction);
    const int axis = is_upright(own.side), past = end == lower ? -1 : 1;
    for (int l = 0; l < links.count; ++l) {
      const int n = (*node_)(at(l)), k = axis == 0 ? fluid_.lattice.x(n) : fluid_.lattice.y(n);
      if (D2Q9::c(direction(l), axis) == past && k == (end == lower ? own.first : own.last)) return l;
    }
    return -1;
  }

  int fluid_at(int number, int link) const {
    return on_host(Kokkos::subview(boundaries_[number].links.fluid, std::pair(link, link + 1)))(0);
  }
  int direction_at(int number, int link) const {
    return on_host(Kokkos::subview(boundaries_[number].links.direction, std::pair(link, link + 1)))(0);
  }

  double share(int number, int end) const {
    const Stretch& own = stretch(number);
    const int at = (end == lower ? own.first : own.last + 1) - own.whole_first;
    return share_of_velocity(own.conditions.flow, at * spacing_, own.whole_length() * spacing_);
  }

 private:
  const Stretch& stretch(int number) const { return boundaries_[number].stretch; }
  bool reaches_corner(const Stretch& stretch, int end) const {
    const int cells = is_upright(stretch.side) ? fluid_.lattice.ny : fluid_.lattice.nx;
    return end == lower ? stretch.first == 0 : stretch.last == cells - 1;
  }
  /// The end of the adjacent sides at which a side lies.
  static int end_at(Side side) { return side == Side::left || side == Side::bottom ? lower : upper; }
  static Side adjacent(Side side, int end) {
    if (is_upright(side)) return end == lower ? Side::bottom : Side::top;
    return end == lower ? Side::left : Side::right;
  }

  const FluidNodes& fluid_;
  double spacing_;
  const std::vector<StretchLinks>& boundaries_;
  std::optional<decltype(on_host(IndexList()))> node_;
};

}  // namespace

void find_ends(const Exec& exec, const FluidNodes& fluid, double spacing, std::vector<StretchLinks>& boundaries) {
  Meetings meetings(fluid, spacing, boundaries);
  for (int b = 0; b < static_cast<int>(boundaries.size()); ++b) {
    StretchLinks& boundary = boundaries[b];
    const Stretch& stretch = boundary.stretch;
    boundary.ends = {};
    boundary.slides = moves_along(stretch);
    if (!gives_velocity_or_wall(stretch)) continue;
    for (const int e : {lower, upper}) {
      const int other = meetings.beyond(b, e);
      if (other < 0) continue;
      const Stretch& theirs = boundaries[other].stretch;
      const bool corner = meetings.is_corner(b, e), both_give = gives_velocity(stretch) && gives_velocity(theirs);
      if (!boundary.slides && !(corner ? both_give : moves_along(theirs))) continue;
      StretchEnd& end = boundary.ends[e];
      const int their_end = meetings.end_of_other(b, e), their_link = meetings.link(other, their_end);
      end.link = meetings.link(b, e);
      end.share = meetings.share(b, e);
      end.other_share = meetings.share(other, their_end);
      if (gives_velocity_or_wall(theirs))
        end.beyond = corner ? Beyond::corner : their_link >= 0 ? Beyond::same_side : Beyond::nothing;
      else
        end.beyond = corner ? Beyond::open_corner : Beyond::nothing;
      if (end.beyond == Beyond::corner || end.beyond == Beyond::same_side) end.other = other;
      if (end.beyond != Beyond::nothing && end.link < 0 && their_link < 0) end.beyond = Beyond::nothing;  // rock
      if (end.link >= 0 && end.beyond != Beyond::nothing) boundary.slides = true;
    }
    if (boundary.slides) boundary.image = find_mirror_links(exec, fluid, boundary.links);
  }
}

void find_links_past_ends(const FluidNodes& fluid, double spacing, std::vector<StretchLinks>& boundaries) {
  Meetings meetings(fluid, spacing, boundaries);
  for (int b = 0; b < static_cast<int>(boundaries.size()); ++b) {
    StretchLinks& boundary = boundaries[b];
    boundary.past = {};
    if (!yields(boundary.stretch)) continue;
    std::array<LinkPastEnd, 2> past;
    for (const int e : {lower, upper}) {
      const int other = meetings.beyond(b, e);
      if (other < 0 || other == b) continue;
      const Stretch& theirs = boundaries[other].stretch;
      if (meetings.is_corner(b, e)) {
        if (is_outflow(boundary.stretch) && is_outflow(theirs)) past[e].link = meetings.link(b, e);
        continue;
      }
      if (!yields(theirs) && !gives_velocity(theirs)) continue;
      const int their_end = meetings.end_of_other(b, e);
      const int own_link = meetings.link(b, e), their_link = meetings.link(other, their_end);
      if (own_link < 0 || their_link < 0) continue;  // rock
      if (gives_velocity(theirs))
        boundary.ends[e] = {StretchEnd::Beyond::same_side, own_link, other, 1, meetings.share(other, their_end)};
      else
        past[e] = {own_link, meetings.fluid_at(other, their_link), meetings.direction_at(other, their_link)};
    }
    if (past[lower].link < 0 && past[upper].link < 0) continue;
    boundary.past = to_device<Kokkos::View<LinkPastEnd*>>("vug::boundary::past_ends", {past[lower], past[upper]});
  }
}

std::array<double, 2> velocity_at_end(const StretchLinks& boundary, const StretchEnd& end, std::array<double, 2> own,
                                      std::array<double, 2> other) {
  std::array<double, 2> u{end.share * own[0], end.share * own[1]};
  const int along = is_upright(boundary.stretch.side);
  const double theirs = end.other_share * other[along];
  // at a corner, that of the other stretch is normal to its side, and what enters through both enters by this link
  if (end.beyond == StretchEnd::Beyond::corner) u[along] = theirs;
  if (end.beyond == StretchEnd::Beyond::same_side) u[along] = (u[along] + theirs) / 2;
  return u;
}

double entered_for(Side other, const StretchEnd& end, std::array<double, 2> velocity) {
  const int outward = static_cast<int>(other), diagonal = D2Q5::Q;
  const double inward = -(D2Q9::c(outward, 0) * velocity[0] + D2Q9::c(outward, 1) * velocity[1]);
  return 6 * D2Q9::w(diagonal) * end.other_share * inward;
}

double passed_along(const StretchLinks& boundary, int e, std::array<double, 2> velocity) {
  const int along = is_upright(boundary.stretch.side), diagonal = D2Q5::Q;
  return 6 * D2Q9::w(diagonal) * (e == lower ? velocity[along] : -velocity[along]);
}

}  // namespace vug
