#pragma once
// The density that an outflow prescribes: a level all over it, through which sound leaves, and along it what
// carries vortices out. open_boundary.hpp has what an outflow is, open_boundary.cpp applies it.
#include "kernels/flow/open_boundary.hpp"
#include "kernels/launch/launch.hpp"
#include "kernels/nodes/fluid_neighbour.hpp"

namespace vug {

/// Outward speed through a face.
template <class T>
struct OutwardSpeed {
  FlowCondition links;
  VectorField<T> u;
  KOKKOS_FUNCTION double operator()(int link) const {
    const int i = links.fluid[link], q = links.direction[link];
    return q < D2Q5::Q ? D2Q9::c(q, 0) * double(u(i, 0)) + D2Q9::c(q, 1) * double(u(i, 1)) : 0;
  }
};

/// Of all links of each outflow.
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

/// rho' = 3 c_s (U - U_0), then U_0 += share (U - U_0), with the mean speed U whose sums it clears.
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

/// Of each outflow.
struct SetOutflowLevels {
  using Entry = FlowCondition;
  double share;
  static int count(const FlowCondition& c) { return c.known() > 0 ? 1 : 0; }
  template <class Run>
  KOKKOS_FUNCTION void operator()(const FlowCondition& c, const Run& run) const {
    run(SetOutflowLevel{c, share});
  }
};

/// Fluid nodes that directions come from, -1 for none.
struct Upstream {
  const int* source;
  int capacity;
  explicit Upstream(const FluidNodes& nodes) : source(nodes.source.data()), capacity(nodes.capacity) {}
  KOKKOS_FORCEINLINE_FUNCTION int operator()(int q, int i) const { return upstream_node(source, capacity, q, i); }
};

/// Along a face, towards higher coordinates.
KOKKOS_FORCEINLINE_FUNCTION constexpr int upwards(int face) {
  return D2Q9::c(face, 0) != 0 ? 2 : 1;
}

/// How the links of an outflow lie; counts the straight ones. Around a joined side the last face has no next.
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

/// Share of the pressure along an outflow that a vortex gets which the mean outward speed U carries: U^2 / (U^2 + k), k
/// the mean square of what the velocities differ from U. What is faster than the flow is not carried out by it.
KOKKOS_INLINE_FUNCTION double carried_share(double U, double fluctuation) {
  return U > 0 ? U * U / (U * U + fluctuation) : 0;
}

/// Pressure along a straight piece of an outflow: with the velocity u outwards, v along it and U the mean of u,
///   dp/ds = -(v dv/ds + (u - U) dv/dn),   mean over the piece 0,
/// the momentum along the piece of a flow whose v is carried out at U, dv/dt + U dv/dn = 0 (a convective outflow after
/// Orlanski 1976, put into the pressure); carried_share of it. Zero for a flow straight out. dv/dn between the node and
/// the one behind it, 0 beside rock. On a joined side the ends meet: what the integral around it leaves is spread
/// evenly.
template <class T>
struct PressureAlong {
  FlowCondition links;
  VectorField<T> u;
  Upstream upstream;

  /// Sets along(face) of the piece that begins at this link; nothing at any other.
  KOKKOS_FUNCTION void operator()(int first) const {
    if (links.face[first] != first || links.previous[first] >= 0) return;
    const int q = links.direction[first];
    int faces = 0, last = first;
    double speed = 0, square = 0;
    for (int face = first; face >= 0; face = links.next[face]) {
      const Velocity here = velocity(q, links.fluid[face]);
      speed += here.out;
      square += here.out * here.out + here.along * here.along;
      last = face;
      ++faces;
    }
    const double mean = speed / faces, U = Kokkos::max(mean, 0.0);

    double integral = 0, slope = 0, sum = 0, first_slope = 0;
    for (int face = first; face >= 0; face = links.next[face]) {
      const int i = links.fluid[face], behind = upstream(q, i);
      const Velocity here = velocity(q, i);
      const double next = behind < 0 ? 0 : (here.out - U) * (here.along - velocity(q, behind).along);
      if (face == first)
        first_slope = next;
      else
        integral -= 0.5 * (slope + next);
      slope = next;
      links.along[face] = integral - 0.5 * here.along * here.along;
      sum += links.along[face];
    }
    const bool joined = faces > 1 && upstream(upwards(q), links.fluid[first]) == links.fluid[last];
    const double step = joined ? (integral - 0.5 * (slope + first_slope)) / faces : 0;
    const double share = 3 * carried_share(U, square / faces - mean * mean);
    double level = sum / faces - 0.5 * (faces - 1) * step;
    for (int face = first; face >= 0; face = links.next[face], level += step)
      links.along[face] = share * (links.along[face] - level);
  }

 private:
  struct Velocity {
    double out, along;
  };
  KOKKOS_FORCEINLINE_FUNCTION Velocity velocity(int q, int i) const {
    const int axis = D2Q9::c(q, 0) != 0 ? 0 : 1;
    return {D2Q9::c(q, axis) * double(u(i, axis)), double(u(i, 1 - axis))};
  }
};

/// Of each outflow.
template <class T>
struct PressuresAlong {
  using Entry = FlowCondition;
  VectorField<T> u;
  Upstream upstream;
  static int count(const FlowCondition& c) { return c.known(); }
  template <class Run>
  KOKKOS_FUNCTION void operator()(const FlowCondition& c, const Run& run) const {
    run(PressureAlong<T>{c, u, upstream});
  }
};

}  // namespace vug
