#pragma once
// The populations at links out of the fluid, evaluated for reports between steps: what leaves, what comes in by the
// boundary condition, and the momentum of both.
#include "kernels/nodes/fluid_nodes.hpp"

namespace vug {

/// (link) The populations that leave through the links; `f` (q * capacity + fluid) are those of flow or solutes, at
/// home there.
template <class T>
ScalarField<T> outgoing_populations(const Exec& exec, const FluidNodes& nodes, const BoundaryLinks& links,
                                    const ScalarField<T>& f);

/// Puts them back, when a condition has overwritten them.
template <class T>
void restore_outgoing(const Exec& exec, const FluidNodes& nodes, const BoundaryLinks& links,
                      const ScalarField<T>& outgoing, const ScalarField<T>& f);

/// Force and torque per step, lattice units.
struct LinkForce {
  double x = 0, y = 0;
  double torque = 0;  ///< counter-clockwise
};

/// Force of the fluid on what lies beyond the links, by momentum exchange: the sum of c (out + in) over them, `in`
/// being what their condition has written to `f` in place of `outgoing`. The torque is its moment about `centre`, in
/// cells from the lattice's corner; an opening counts as one piece, whichever joined side its links cross. Relative to
/// the reference pressure (momentum_exchange.hpp). Waits for the device; the same bits for any number of threads.
template <class T>
LinkForce force_on_links(const Exec& exec, const FluidNodes& nodes, const BoundaryLinks& links,
                         const ScalarField<T>& outgoing, const ScalarField<T>& f, std::array<double, 2> centre);

/// Sums of a scalar over the straight links of a surface, which may be in several parts, and its mean.
struct LinkMean {
  double flow = 0, carried = 0;  ///< sums of |u.n| and of C |u.n|
  double faces = 0, sum = 0;     ///< straight links, sum of C over them

  void operator+=(const LinkMean& part) {
    flow += part.flow;
    carried += part.carried;
    faces += part.faces;
    sum += part.sum;
  }
  /// Mean weighted with the flow through each link; unweighted where nothing flows, 0 without links.
  double value() const { return flow > 0 ? carried / flow : faces > 0 ? sum / faces : 0; }
};

/// Sums of C (fluid), carried by u (fluid, axis), which may be empty. Waits for the device.
template <class T>
LinkMean mean_at_links(const Exec& exec, const BoundaryLinks& links, const ScalarField<T>& C, const VectorField<T>& u);

}  // namespace vug
