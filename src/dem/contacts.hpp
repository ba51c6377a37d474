#pragma once
// Pairs of triangles that may touch although no bond joins them, with the state of their friction.
#include "dem/bonds.hpp"

namespace vug {

/// Corners of a pair that may touch the outline of the other triangle: three of the lower particle, three of the
/// higher.
inline constexpr int pair_features = 6;

/// Candidate pairs (low, high), in two generations so that a rebuild can look up the friction in the old list. Pairs
/// [first(i, g), first(i + 1, g)) have particle i as their lower one and are ordered by the number of the higher one.
struct Contacts {
  int capacity = 0;  ///< pairs
  double skin = 0;   ///< pairs closer than this are candidates, m; rebuilt when a particle has moved by a quarter of it

  /// [contacts_stale]: the list must be rebuilt; [contacts_generation]: the list in use, 0 or 1; [contacts_lost]:
  /// number of pairs for which there was no room. Nothing is searched while Bonds::events says that contacts are
  /// inactive.
  IndexList status;
  Kokkos::View<int* [2], Kokkos::LayoutLeft> first;                      ///< (particle + 1, generation)
  Kokkos::View<int* [2], Kokkos::LayoutLeft> other;                      ///< (pair, generation) the higher particle
  Kokkos::View<double* [2][pair_features], Kokkos::LayoutLeft> stretch;  ///< friction springs, m
  /// Overlaps that do not push, m: those that compression has made of triangles with a common vertex while bonds, or
  /// the faces of a crack, held them apart. Zero again once the two have parted. before_first_look: that of the first
  /// evaluation.
  Kokkos::View<double* [2][pair_features], Kokkos::LayoutLeft> idle_overlap;
  /// (pair, component) force on the lower particle, torque on it, torque on the higher one.
  Kokkos::View<double* [4], Kokkos::LayoutLeft> load;
  IndexList row;    ///< (particle + 1)
  IndexList entry;  ///< 2 * pair + (1 for the higher end), ascending in each row

  Kokkos::View<double* [3], Kokkos::LayoutLeft> push;  ///< (particle, component) force and torque of all its contacts
  ScalarField<double> energy;                          ///< (lower particle) stored in its pairs' springs, J per m

  VectorField<double> u_built;      ///< displacements when the list was built, m
  ScalarField<double> angle_built;  ///< rotations then
};

inline constexpr double before_first_look = -1;  ///< a Contacts::idle_overlap that is not known yet

inline constexpr int contacts_stale = 0, contacts_generation = 1, contacts_lost = 2;

/// Makes an empty list for these particles; with `awake` (rock that faces itself) contacts are active from the start.
Contacts make_contacts(const Particles& particles, const Bonds& bonds, bool awake);

}  // namespace vug
