#pragma once
// Contact law of two bodies that are not bonded: normal spring and dashpot that never pull, friction spring with a
// slider.
#include "base/base.hpp"

namespace vug {

/// Springs, dashpots and slider of one contact point.
struct ContactPoint {
  double k_n;  ///< normal stiffness
  double k_t;  ///< tangential stiffness
  double c_n;  ///< normal dashpot
  double c_t;  ///< tangential dashpot
  double mu;   ///< friction coefficient
};

/// Reaction at a contact point and the position of its slider afterwards.
struct ContactReaction {
  double normal;      ///< compression, >= 0
  double tangential;  ///< along the tangent, opposing stretch
  double slip;        ///< new position of the slider
};

/// Reaction to an overlap (closing positive), its rate and the tangential offset of the two bodies:
///   f_n = max(0, k_n overlap + c_n rate),  f_t = -k_t (offset - slip) - c_t offset_rate,  |f_t| <= mu f_n.
/// A contact that slides drags the slider behind it. In an open contact the slider follows the offset.
KOKKOS_FORCEINLINE_FUNCTION ContactReaction contact_reaction(const ContactPoint& p, double overlap, double overlap_rate,
                                                             double offset, double offset_rate, double slip) {
  const bool closed = overlap > 0;
  const double normal = closed ? Kokkos::max(0.0, p.k_n * overlap + p.c_n * overlap_rate) : 0.0;
  const double limit = p.mu * normal;
  const double spring = -p.k_t * (offset - slip);
  const double trial = spring - p.c_t * offset_rate;
  const double tangential = Kokkos::max(-limit, Kokkos::min(limit, trial));
  const bool slides = Kokkos::abs(spring) > limit;
  const double dragged = offset + (spring > 0 ? limit : -limit) / p.k_t;
  return {normal, tangential, !closed ? offset : slides ? dragged : slip};
}

}  // namespace vug
