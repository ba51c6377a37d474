#pragma once
// The pressure along a piece of an outflow, by which vortices leave.
#include "kernels/flow/outflow.hpp"

namespace vug {

/// Share of the pressure along an outflow that is applied: U^2 / (U^2 + k), with the mean outward speed U and the mean
/// square k of the deviations of the velocities from it. Motion faster than the mean flow is not carried out by it.
KOKKOS_INLINE_FUNCTION double carried_share(double U, double fluctuation) {
  return U > 0 ? U * U / (U * U + fluctuation) : 0;
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

/// Pressure along a straight piece of an outflow: with the velocity u outwards, v along it and U the mean of u,
///   dp/ds = -(v dv/ds + (u - U) dv/dn),   mean over the piece 0,
/// times carried_share. This is the momentum equation along the piece for a flow whose v is carried out at U,
/// dv/dt + U dv/dn = 0 (a convective outflow after Orlanski 1976, expressed as a pressure). The pressure is zero where
/// all fluid leaves at right angles. dv/dn is taken between the node and the one behind it, and is 0 if that is rock.
/// On a joined side the ends meet: what remains of the integral around it is distributed evenly.
template <class T>
struct PressureAlong {
  AlongPiece<T> at;

  /// Sets `along` of all faces of the piece.
  KOKKOS_FUNCTION void operator()(int piece) const {
    const FlowCondition& links = at.links;
    const int begin = links.piece[piece], end = links.piece[piece + 1], faces = end - begin;
    const int first = links.order[begin], last = links.order[end - 1], q = links.direction[first];
    double speed = 0, square = 0;
    for (int k = begin; k < end; ++k) {
      const auto here = at.velocity(q, links.fluid[links.order[k]]);
      speed += here.out;
      square += here.out * here.out + here.along * here.along;
    }
    const double mean = speed / faces, U = Kokkos::max(mean, 0.0);

    double integral = 0, slope = 0, sum = 0, first_slope = 0;
    for (int k = begin; k < end; ++k) {
      const int face = links.order[k], i = links.fluid[face];
      const auto here = at.velocity(q, i);
      const double next = at.slope(q, i, here, U);
      if (k == begin)
        first_slope = next;
      else
        integral -= 0.5 * (slope + next);
      slope = next;
      links.along[face] = integral - 0.5 * here.along * here.along;
      sum += links.along[face];
    }
    const double step = at.joined(q, first, last) ? (integral - 0.5 * (slope + first_slope)) / faces : 0;
    const double share = 3 * carried_share(U, square / faces - mean * mean);
    double level = sum / faces - 0.5 * (faces - 1) * step;
    for (int k = begin; k < end; ++k, level += step) {
      const int face = links.order[k];
      links.along[face] = share * (links.along[face] - level);
    }
  }
};

/// PressureAlong by a team, for a GPU, where one thread would take a microsecond for each face. A thread sums over each
/// run of consecutive faces, then the runs are summed: the bits do not depend on the size of the team, and are those of
/// PressureAlong for pieces of at most `most_runs` faces whose ends do not meet.
template <class T>
struct PressureAlongByTeam {
  static constexpr int most_runs = 256;
  AlongPiece<T> at;

  template <class Team>
  KOKKOS_FUNCTION void operator()(const Team& team, int piece) const {
    const FlowCondition& links = at.links;
    const int begin = links.piece[piece], faces = links.piece[piece + 1] - begin;
    const int* order = links.order + begin;
    const int first = order[0], last = order[faces - 1], q = links.direction[first];
    const int length = (faces + most_runs - 1) / most_runs, runs = (faces + length - 1) / length;
    const auto end_of = [=](int run) { return (run + 1) * length < faces ? (run + 1) * length : faces; };
    double *one = links.room + begin, *other = one + links.count, *slope = other + links.count;
    const auto every_run = Kokkos::TeamThreadRange(team, runs);
    const auto every_face = Kokkos::TeamThreadRange(team, faces);

    Kokkos::parallel_for(every_run, [&](int run) {
      double speed = 0, square = 0;
      for (int k = run * length; k < end_of(run); ++k) {
        const auto here = at.velocity(q, links.fluid[order[k]]);
        speed += here.out;
        square += here.out * here.out + here.along * here.along;
      }
      one[run] = speed;
      other[run] = square;
    });
    team.team_barrier();
    const double mean = sum_of(one, runs) / faces, square = sum_of(other, runs), U = Kokkos::max(mean, 0.0);
    Kokkos::parallel_for(every_face, [&](int k) {
      const int i = links.fluid[order[k]];
      slope[k] = at.slope(q, i, at.velocity(q, i), U);
    });
    team.team_barrier();
    Kokkos::parallel_for(every_run, [&](int run) {
      double rise = 0;
      for (int k = run * length; k < end_of(run); ++k) rise -= k > 0 ? 0.5 * (slope[k - 1] + slope[k]) : 0;
      one[run] = rise;
    });
    team.team_barrier();
    Kokkos::parallel_for(every_run, [&](int run) {
      double integral = sum_of(one, run), sum = 0;
      for (int k = run * length; k < end_of(run); ++k) {
        if (k > 0) integral -= 0.5 * (slope[k - 1] + slope[k]);
        const double along = at.velocity(q, links.fluid[order[k]]).along;
        links.along[order[k]] = integral - 0.5 * along * along;
        sum += links.along[order[k]];
      }
      other[run] = sum;
    });
    team.team_barrier();
    const bool joined = at.joined(q, first, last);
    const double step = joined ? (sum_of(one, runs) - 0.5 * (slope[faces - 1] + slope[0])) / faces : 0;
    const double share = 3 * carried_share(U, square / faces - mean * mean);
    const double level = sum_of(other, runs) / faces - 0.5 * (faces - 1) * step;
    Kokkos::parallel_for(every_face,
                         [&](int k) { links.along[order[k]] = share * (links.along[order[k]] - (level + k * step)); });
  }

 private:
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
    if constexpr (runs_on_host)
      run(PressureAlong<T>{{c, u, upstream}});
    else
      run(PressureAlongByTeam<T>{{c, u, upstream}});
  }
};

}  // namespace vug
