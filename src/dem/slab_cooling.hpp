#pragma once
// Temperature of a slab that is cooled from one side, and its stress before anything cracks.
#include <limits>
#include <vector>

namespace vug {

/// A slab of thickness `height` (or half of a slab of twice that) whose face is cooled from time zero on by a medium
/// colder by `drop`; no heat passes the other side. Depth is measured from the face, temperatures are changes, SI. Time
/// is given as the diffusion length 2 sqrt(kappa t).
class SlabCooling {
 public:
  /// `biot` is the heat transfer coefficient times the height over the conductivity; infinite: the face takes the
  /// temperature of the medium at once.
  SlabCooling(double drop, double height, double biot = std::numeric_limits<double>::infinity());

  /// Temperature change. Infinite Biot number: -drop sum over n of (-1)^n [erfc((2 n H + z) / length) + erfc((2 (n + 1)
  /// H - z) / length)] (Carslaw and Jaeger 1959, 3.3). Otherwise -drop (1 - sum over n of 4 sin a_n / (2 a_n + sin 2
  /// a_n) cos(a_n (1 - z/H)) exp(-a_n^2 length^2 / (2 H)^2)), a_n tan a_n = biot (the same, 3.11).
  double change(double depth, double length) const;

  /// Mean temperature change over the height, by the midpoint rule.
  double mean_change(double length) const;

  /// Lateral stress far from the flanks, tension positive: -E alpha (change - mean change over the height), plane
  /// stress, no bending.
  double stress(double modulus, double expansion, double depth, double length) const;

 private:
  double of_a_cold_face(double depth, double length) const;
  double through_a_film(double depth, double length) const;

  double drop_, height_;
  std::vector<double> roots_;  // a_n, none for an infinite Biot number
};

}  // namespace vug
