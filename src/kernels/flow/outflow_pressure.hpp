#pragma once
// The pressure along a piece of an outflow, by which vortices leave.
#include "kernels/flow/outflow.hpp"

namespace vug {

/// Share of the pressure along an outflow that is applied: U^2 / (U^2 + k), with the mean outward speed U and the mean
/// square k of the deviations of the velocities from it. Motion faster than the mean flow is not carried out by it.
/// None is, where a beginning flow is so slow that its square would vanish.
KOKKOS_INLINE_FUNCTION double carried_share(double U, double fluctuation) {
  constexpr double slowest = 1e-140;
  return U > slowest ? U * U / (U * U + fluctuation) : 0;
}

/// Velocities along a straight piece of an outflow, u outwards and v along it.
template <class T>
struct AlongPiece {
  FlowCondition links;
  VectorField<T> u;
  Upstream upstream;

  struct Velocity {
    double out, along;
  };
  KOKKOS_FORCEINLINE_FUNCTION Velocity velocity(int q, int i) const {
    const int axis = D2Q9::c(q, 0) != 0 ? 0 : 1;
    return {D2Q9::c(q, axis) * double(u(i, axis)), double(u(i, 1 - axis))};
  }
  /// (u - U) dv/dn at fluid node i, whose velocity is `here`.
  KOKKOS_FORCEINLINE_FUNCTION double slope(int q, int i, const Velocity& here, double U) const {
    const int behind = upstream(q, i);
    return behind < 0 ? 0 : (here.out - U) * (here.along - velocity(q, behind).along);
  }
  /// Whether the ends of a piece meet.
  KOKKOS_FORCEINLINE_FUNCTION bool joined(int q, int first, int last) const {
    return first != last && upstream(upwards(q), links.fluid[first]) == links.fluid[last];
  }
};

/// One thread in place of a team.
struct OneThread {};

/// body(k) for every k < count, by all threads of a team, which wait for one another.
template <class Team, class Body>
KOKKOS_FORCEINLINE_FUNCTION void for_each_by(const Team& team, int count, const Body& body) {
  if constexpr (std::is_same_v<Team, OneThread>) {
    for (int k = 0; k < count; ++k) body(k);
  } else {
    Kokkos::parallel_for(Kokkos::TeamThreadRange(team, count), body);
    team.team_barrier();
  }
}

/// Pressure along a straight piece of an outflow: with the velocity u outwards, v along it and U the mean of u,
///   dp/ds = -(v dv/ds + (u - U) dv/dn),   mean over the piece 0,
/// times carried_share. This is the momentum equation along the piece for a flow whose v is carried out at U,
/// dv/dt + U dv/dn = 0 (a convective outflow after Orlanski 1976, expressed as a pressure). The pressure is zero where
/// all fluid leaves at right angles. dv/dn is taken between the node and the one behind it, and is 0 if that is rock.
/// On a joined side the ends meet: what remains of the integral around it is distributed evenly.
///
/// By one thread, or on a GPU, where that would take a microsecond for each face, by a team, of which each thread sums
/// over runs of consecutive faces. The bits do not depend on the size of the team, and are those of one thread for
/// pieces of at most `most_runs` faces.
template <class T>
struct PressureAlong {
  static constexpr int most_runs = 256;
  AlongPiece<T> at;

  /// Sets `along` of all faces of the piece.
  KOKKOS_FUNCTION void operator()(int piece) const { set(OneThread{}, 1, piece); }
  template <class Team>
  KOKKOS_FUNCTION void operator()(const Team& team, int piece) const {
    set(team, most_runs, piece);
  }

 private:
  template <class Team>
  KOKKOS_FORCEINLINE_FUNCTION void set(const Team& team, int most, int piece) const {
    const FlowCondition& links = at.links;
    const int begin = links.piece[piece], faces = links.piece[piece + 1] - begin;
    const int* order = links.order + begin;
    const int first = order[0], last = order[faces - 1], q = links.direction[first];
    const int length = (faces + most - 1) / most, runs = (faces + length - 1) / length;
    const auto end_of = [=](int run) { return (run + 1) * length < faces ? (run + 1) * length : faces; };
    double *one = links.room + begin, *other = one + links.count, *slope = other + links.count;

    for_each_by(team, runs, [&](int run) {
      double speed = 0, square = 0;
      for (int k = run * length; k < end_of(run); ++k) {
        const auto here = at.velocity(q, links.fluid[order[k]]);
        speed += here.out;
        square += here.out * here.out + here.along * here.along;
      }
      one[run] = speed;
      other[run] = square;
    });
    const double mean = sum_of(one, runs) / faces, square = sum_of(other, runs), U = Kokkos::max(mean, 0.0);
    for_each_by(team, faces, [&](int k) {
      const int i = links.fluid[order[k]];
      slope[k] = at.slope(q, i, at.velocity(q, i), U);
    });
    const auto rise = [&](int k) { return k > 0 ? -0.5 * (slope[k - 1] + slope[k]) : 0; };
    for_each_by(team, runs, [&](int run) {
      double sum = 0;
      for (int k = run * length; k < end_of(run); ++k) sum += rise(k);
      one[run] = sum;
    });
    for_each_by(team, runs, [&](int run) {
      double integral = sum_of(one, run), sum = 0;
      for (int k = run * length; k < end_of(run); ++k) {
        integral += rise(k);
        const double along = at.velocity(q, links.fluid[order[k]]).along;
        links.along[order[k]] = integral - 0.5 * along * along;
        sum += links.along[order[k]];
      }
      other[run] = sum;
    });
    const bool joined = at.joined(q, first, last);
    const double step = joined ? (sum_of(one, runs) - 0.5 * (slope[faces - 1] + slope[0])) / faces : 0;
    const double share = 3 * carried_share(U, square / faces - mean * mean);
    const double level = sum_of(other, runs) / faces - 0.5 * (faces - 1) * step;
    for_each_by(team, faces,
                [&](int k) { links.along[order[k]] = share * (links.along[order[k]] - (level + k * step)); });
  }

  KOKKOS_FORCEINLINE_FUNCTION static double sum_of(const double* values, int count) {
    double sum = 0;
    for (int i = 0; i < count; ++i) sum += values[i];
    return sum;
  }
};

/// PressureAlong for every piece of each outflow.
template <class T>
struct PressuresAlong {
  using Entry = FlowCondition;
  VectorField<T> u;
  Upstream upstream;
  static int count(const FlowCondition& c) { return c.known() > 0 ? c.pieces : 0; }
  template <class Run>
  KOKKOS_FUNCTION void operator()(const FlowCondition& c, const Run& run) const {
    run(PressureAlong<T>{{c, u, upstream}});
  }
};

}  // namespace vug
