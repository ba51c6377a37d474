#pragma once
// The density that an outflow prescribes: a level for the whole outflow, by which sound leaves, and a variation along
// it, by which vortices leave. open_boundary.hpp describes the outflow, open_boundary.cpp applies it.
#include "kernels/flow/open_boundary.hpp"
#include "kernels/launch/launch.hpp"
#include "kernels/nodes/fluid_neighbour.hpp"

namespace vug {

/// Outward speed at the node of a straight link; 0 for a diagonal one.
template <class T>
struct OutwardSpeed {
  FlowCondition links;
  VectorField<T> u;
  KOKKOS_FUNCTION double operator()(int link) const {
    const int i = links.fluid[link], q = links.direction[link];
    return q < D2Q5::Q ? D2Q9::c(q, 0) * double(u(i, 0)) + D2Q9::c(q, 1) * double(u(i, 1)) : 0;
  }
};

/// OutwardSpeed for all links of each outflow.
template <class T>
struct OutwardSpeeds {
  using Entry = FlowCondition;
  VectorField<T> u;
  static int count(const FlowCondition& c) { return c.known(); }
  template <class Run>
  KOKKOS_FUNCTION void operator()(const FlowCondition& c, const Run& run) const {
    run(OutwardSpeed<T>{c, u});
  }
};

/// Sets rho' = 3 c_s (U - U_0), then U_0 += share (U - U_0), where U is the mean outward speed; clears its sums.
struct SetOutflowLevel {
  FlowCondition links;
  double share;
  KOKKOS_FUNCTION void operator()(int) const {
    double sum = 0;
    for (int block = 0; block < block_count(links.count); ++block) {
      sum += links.total[block];
      links.total[block] = 0;
    }
    const double change = sum / links.faces - links.level[0];
    links.level[1] = 3 * Kokkos::sqrt(c_s2) * change;
    links.level[0] += share * change;
  }
};

/// SetOutflowLevel for each outflow.
struct SetOutflowLevels {
  using Entry = FlowCondition;
  double share;
  static int count(const FlowCondition& c) { return c.known() > 0 ? 1 : 0; }
  template <class Run>
  KOKKOS_FUNCTION void operator()(const FlowCondition& c, const Run& run) const {
    run(SetOutflowLevel{c, share});
  }
};

/// The fluid node that direction q comes from at node i; -1: none.
struct Upstream {
  const int* source;
  int capacity;
  explicit Upstream(const FluidNodes& nodes) : source(nodes.source.data()), capacity(nodes.capacity) {}
  KOKKOS_FORCEINLINE_FUNCTION int operator()(int q, int i) const { return upstream_node(source, capacity, q, i); }
};

/// Direction along a face, towards higher coordinates.
KOKKOS_FORCEINLINE_FUNCTION constexpr int upwards(int face) {
  return D2Q9::c(face, 0) != 0 ? 2 : 1;
}

/// Finds for each straight link (face) of an outflow the faces beside it, for each diagonal link a face of its node,
/// and counts the faces. Where joined sides close the row, the last face has no next one.
struct FindPieces {
  BoundaryLinks links;
  Upstream upstream;
  IndexList next, previous, face;

  KOKKOS_FUNCTION void operator()(int link, int& faces) const {
    const int q = links.direction(link), i = links.fluid(link);
    next(link) = previous(link) = face(link) = -1;
    if (q < D2Q5::Q) {
      const int above = beside(link, upwards(q)), below = beside(link, D2Q9::opposite(upwards(q)));
      if (above > link) next(link) = above;
      if (below < link) previous(link) = below;
      face(link) = link;
      ++faces;
      return;
    }
    const int along_x = D2Q9::c(q, 0) > 0 ? 1 : 3, along_y = D2Q9::c(q, 1) > 0 ? 2 : 4;
    const int of_x = links.find(link, i, along_x);
    face(link) = of_x >= 0 ? of_x : links.find(link, i, along_y);
  }

 private:
  KOKKOS_FORCEINLINE_FUNCTION int beside(int link, int towards) const {
    const int neighbour = upstream(D2Q9::opposite(towards), links.fluid(link));
    return neighbour < 0 ? -1 : links.find(link, neighbour, links.direction(link));
  }
};

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
