#include "dem/timed_loads.hpp"

#include "base/require.hpp"
#include "kernels/launch/launch.hpp"

#include <algorithm>
#include <map>

namespace vug {

namespace {

/// Current tractions or velocities (part, axis).
struct PartValues {
  double of[most_timed_parts][2];
};

PartValues values_at(const std::vector<SidePart>& parts, std::array<OverTime, 2> SidePart::*number, double time) {
  PartValues values{};
  for (std::size_t p = 0; p < parts.size(); ++p)
    for (std::size_t axis = 0; axis < 2; ++axis) values.of[p][axis] = value_at((parts[p].*number)[axis], time);
  return values;
}

struct FollowLoads {
  PartValues traction, velocity;
  IndexList particle, row, part;
  ScalarField<double> length;
  VectorField<double> arm;
  IndexList axes;
  VectorField<double> other_force, other_moment;
  BoundaryLoads loads;
  Particles p;

  KOKKOS_FUNCTION void operator()(int j) const {
    const int i = particle(j);
    Vec2 force{other_force(j, 0), other_force(j, 1)};
    double turning = other_moment(j, 0), along = other_moment(j, 1);
    for (int e = row(j); e < row(j + 1); ++e) {
      const int n = part(e);
      const Vec2 f{length(e) * traction.of[n][0], length(e) * traction.of[n][1]}, r{arm(e, 0), arm(e, 1)};
      force = force + f;
      turning += cross(r, f);
      along += dot(r, f);
      for (int axis = 0; axis < 2; ++axis)
        if (axes(e) & 1 << axis) p.drive(i, axis) = velocity.of[n][axis];
    }
    loads.force(i, 0) = force.x;
    loads.force(i, 1) = force.y;
    loads.moment(i, 0) = turning;
    loads.moment(i, 1) = along;
  }
};

/// (part) Number of each part that changes or moves in `timed`, to which these parts are added; -1 for the others.
std::vector<int> number_parts(const std::vector<SidePart>& parts, std::vector<SidePart>& timed) {
  std::vector<int> number(parts.size(), -1);
  for (std::size_t p = 0; p < parts.size(); ++p) {
    if (!parts[p].changes && !parts[p].moves()) continue;
    number[p] = static_cast<int>(timed.size());
    timed.push_back(parts[p]);
  }
  return number;
}

/// The pieces of parts that change or move, grouped by particle.
struct TimedPieces {
  std::vector<int> particle, row{0}, part, axes;
  std::vector<LoadedPiece> all;

  /// `held`: axes_held, of which platens move only their own.
  TimedPieces(const std::vector<LoadedPiece>& boundary, const std::vector<SidePart>& parts,
              const std::vector<int>& number, const std::vector<AxesOfSides>& held) {
    std::map<int, std::vector<LoadedPiece>> pieces;  // by particle
    for (const LoadedPiece& piece : boundary)
      if (piece.part >= 0 && number[piece.part] >= 0) pieces[piece.particle].push_back(piece);
    for (const auto& [i, of_particle] : pieces) {
      particle.push_back(i);
      for (const LoadedPiece& piece : of_particle) {
        const SidePart& own = parts[piece.part];
        part.push_back(number[piece.part]);
        const bool moved = piece.decides && own.moves() && own.support != Support::free;
        axes.push_back(moved ? held[i][piece.side] : 0);
        all.push_back(piece);
      }
      row.push_back(static_cast<int>(part.size()));
    }
  }
};

/// Fills in length and arm of every piece, and the other loads on their particles: all loads at the start without these
/// pieces.
void fill(const TimedPieces& pieces, const BoundaryLoads& at_start, TimedLoads& timed) {
  const HostWriter length(timed.length);
  const HostWriter arm(timed.arm), force(timed.force), moment(timed.moment);
  const auto first_force = on_host(at_start.force);
  const auto first_moment = on_host(at_start.moment);
  for (std::size_t j = 0; j < pieces.particle.size(); ++j)
    for (std::size_t c = 0; c < 2; ++c) {
      force(j, c) = first_force(pieces.particle[j], c);
      moment(j, c) = first_moment(pieces.particle[j], c);
    }
  for (std::size_t j = 0; j < pieces.particle.size(); ++j)
    for (int e = pieces.row[j]; e < pieces.row[j + 1]; ++e) {
      const LoadedPiece& piece = pieces.all[e];
      const SidePart& own = timed.parts[pieces.part[e]];
      const Vec2 f{piece.length * value_at(own.traction[0], 0), piece.length * value_at(own.traction[1], 0)};
      length(e) = piece.length;
      arm(e, 0) = piece.arm.x;
      arm(e, 1) = piece.arm.y;
      force(j, 0) -= f.x;
      force(j, 1) -= f.y;
      moment(j, 0) -= cross(piece.arm, f);
      moment(j, 1) -= dot(piece.arm, f);
    }
}

}  // namespace

bool TimedLoads::moves() const {
  return std::any_of(parts.begin(), parts.end(), [](const SidePart& one) { return one.moves(); });
}

std::optional<TimedLoads> make_timed_loads(const Assembly& assembly, const std::vector<BoundaryEdge>& boundary,
                                           const Loads& loads, const Particles& particles,
                                           const BoundaryLoads& at_start) {
  TimedLoads timed;
  const std::vector<int> number = number_parts(loads.parts, timed.parts);
  if (timed.parts.empty()) return std::nullopt;
  if (timed.parts.size() > most_timed_parts)
    throw InputError("boundary: at most " + std::to_string(most_timed_parts) +
                     " sides and parts of sides may change in time or move");
  const std::vector<LoadedPiece> all = pieces_of_boundary(assembly, boundary, loads, particles);
  const TimedPieces pieces(all, loads.parts, number, axes_held(all, loads, particles.count));
  timed.particle = to_device<IndexList>("vug::dem::timed_particle", pieces.particle);
  timed.row = to_device<IndexList>("vug::dem::timed_row", pieces.row);
  timed.part = to_device<IndexList>("vug::dem::timed_part", pieces.part);
  timed.axes = to_device<IndexList>("vug::dem::timed_axes", pieces.axes);
  timed.length = ScalarField<double>("vug::dem::timed_length", pieces.all.size());
  timed.arm = VectorField<double>("vug::dem::timed_arm", pieces.all.size());
  timed.force = VectorField<double>("vug::dem::timed_force", pieces.particle.size());
  timed.moment = VectorField<double>("vug::dem::timed_moment", pieces.particle.size());
  fill(pieces, at_start, timed);
  return timed;
}

void follow_loads(const Exec& exec, const TimedLoads& timed, double time, double dt, const BoundaryLoads& loads,
                  const Particles& particles) {
  for_each_node(
      exec, "vug::dem::follow_loads", static_cast<int>(timed.particle.extent(0)),
      FollowLoads{values_at(timed.parts, &SidePart::traction, time),
                  values_at(timed.parts, &SidePart::velocity, time + 0.5 * dt), timed.particle, timed.row, timed.part,
                  timed.length, timed.arm, timed.axes, timed.force, timed.moment, loads, particles});
}

}  // namespace vug
