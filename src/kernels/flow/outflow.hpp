#pragma once
// The density that an outflow prescribes: a level all over it, through which sound leaves, and along a side what
// carries vortices out. open_boundary.hpp has what an outflow is, open_boundary.cpp applies it.
#include "kernels/flow/open_boundary.hpp"
#include "kernels/launch/launch.hpp"

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
  static int count(const FlowCondition& c) { return c.faces > 0 ? c.count : 0; }
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
  static int count(const FlowCondition& c) { return c.faces > 0 ? 1 : 0; }
  template <class Run>
  KOKKOS_FUNCTION void operator()(const FlowCondition& c, const Run& run) const {
    run(SetOutflowLevel{c, share});
  }
};

/// Share of the pressure along an outflow that a vortex gets which the mean outward speed U carries: U^2 / (U^2 + k), k
/// the mean square of what the velocities differ from U. What is faster than the flow is not carried out by it.
KOKKOS_INLINE_FUNCTION double carried_share(double U, double fluctuation) {
  return U > 0 ? U * U / (U * U + fluctuation) : 0;
}

/// Pressure along a piece of a side without gaps: with the velocity u outwards, v along it and U the mean of u,
///   dp/ds = -(v dv/ds + (u - U) dv/dn),   mean over the piece 0,
/// the momentum along the side of a flow whose v is carried out at U, dv/dt + U dv/dn = 0 (a convective outflow after
/// Orlanski 1976, put into the pressure); carried_share of it. Zero for a flow straight out. dv/dn between the node and
/// the one behind it, 0 beside rock. On a joined side the ends meet: what the integral around it leaves is spread
/// evenly.
template <class T>
struct PressureAlong {
  FlowCondition links;
  VectorField<T> u;
  const int* source;
  int nodes, capacity;

  /// Sets along(link) of the piece that begins at this link, in order of the links; nothing at any other.
  KOKKOS_FUNCTION void operator()(int first) const {
    if (first > 0 && goes_on(first)) return;
    int end = first, faces = 0;
    double speed = 0, square = 0;
    do {
      if (is_face(end)) {
        const Velocity here = velocity(links.direction[end], links.fluid[end]);
        speed += here.out;
        square += here.out * here.out + here.along * here.along;
        ++faces;
      }
      ++end;
    } while (end < links.count && goes_on(end));
    const double mean = speed / faces, U = Kokkos::max(mean, 0.0);
    const double share = 3 * carried_share(U, square / faces - mean * mean);

    double integral = 0, slope = 0, sum = 0, first_slope = 0;
    for (int link = first; link < end; ++link) {
      if (!is_face(link)) continue;
      const int q = links.direction[link], i = links.fluid[link], behind = upstream(q, i);
      const Velocity here = velocity(q, i);
      const double next = behind < 0 ? 0 : (here.out - U) * (here.along - velocity(q, behind).along);
      if (link == first)
        first_slope = next;
      else
        integral -= 0.5 * (slope + next);
      slope = next;
      links.along[link] = integral - 0.5 * here.along * here.along;
      sum += links.along[link];
    }
    const bool joined = upstream(upwards(first), links.fluid[first]) == links.fluid[end - 1];
    const double step = joined ? (integral - 0.5 * (slope + first_slope)) / faces : 0;
    double there = 0, level = sum / faces - 0.5 * (faces - 1) * step;
    for (int link = first; link < end; ++link) {
      if (is_face(link)) {
        there = share * (links.along[link] - level);
        level += step;
      }
      links.along[link] = there;  // the diagonal links of a node come after its face
    }
  }

 private:
  struct Velocity {
    double out, along;
  };
  KOKKOS_FORCEINLINE_FUNCTION Velocity velocity(int q, int i) const {
    const int axis = D2Q9::c(q, 0) != 0 ? 0 : 1;
    return {D2Q9::c(q, axis) * double(u(i, axis)), double(u(i, 1 - axis))};
  }
  KOKKOS_FORCEINLINE_FUNCTION bool is_face(int link) const { return links.direction[link] < D2Q5::Q; }
  /// Along the side of a face, towards higher coordinates.
  KOKKOS_FORCEINLINE_FUNCTION int upwards(int face) const { return D2Q9::c(links.direction[face], 0) != 0 ? 2 : 1; }
  /// Whether a link belongs to the node of the link before it, or to its neighbour.
  KOKKOS_FORCEINLINE_FUNCTION bool goes_on(int link) const {
    const int before = links.fluid[link - 1], i = links.fluid[link];
    return i == before || upstream(upwards(link), i) == before;
  }
  /// Fluid node that direction q comes from, -1 for none.
  KOKKOS_FORCEINLINE_FUNCTION int upstream(int q, int i) const {
    const int from = source[q * capacity + i] - q * capacity;
    return from >= 0 && from < nodes ? from : -1;
  }
};

/// Of each outflow through a side.
template <class T>
struct PressuresAlong {
  using Entry = FlowCondition;
  VectorField<T> u;
  const int* source;
  int nodes, capacity;
  static int count(const FlowCondition& c) { return c.faces > 0 && c.along ? c.count : 0; }
  template <class Run>
  KOKKOS_FUNCTION void operator()(const FlowCondition& c, const Run& run) const {
    run(PressureAlong<T>{c, u, source, nodes, capacity});
  }
};

}  // namespace vug
