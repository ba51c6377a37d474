#pragma once
// The bonds that hold the triangles together: one per shared edge, with two integration points.
#include "dem/particles.hpp"

#include <cstdint>

namespace vug {

/// State of a bond. The value never decreases; from `failed_in_tension` on the bond no longer holds.
enum class BondState : std::uint8_t {
  intact = 0,
  damaged_in_tension = 1,
  damaged_in_shear = 2,
  failed_in_tension = 3,
  failed_in_shear = 4,
  dissolved = 5,         ///< failed because d_c reached its limit; d_m stays as it was
  cracked_at_start = 6,  ///< a pre-existing fracture
};

KOKKOS_FORCEINLINE_FUNCTION constexpr bool has_failed(BondState state) {
  return state >= BondState::failed_in_tension;
}

/// How the two triangles of a bond interact apart from the bond itself.
inline constexpr std::uint8_t faces_apart = 0,  ///< parted by half an edge: through their outlines
    faces_joined = 1,                           ///< through the faces of the crack
    faces_dissolved = 2;                        ///< through what is left of the faces, and through the outlines behind

inline constexpr int bond_has_failed = 0, cracks_have_changed = 1;

/// Half the distance of the two Gauss points of an edge over half its length; each point stands for half of the edge.
inline constexpr double gauss_point = 0.57735026918962576;

/// Parameters of each bond where the rock is of several materials; empty where it is of one (bond_elasticity.hpp).
struct BondElasticity {
  ScalarField<double> normal_modulus;      ///< (bond) Pa
  ScalarField<double> tangential_modulus;  ///< (bond) Pa
  ScalarField<double> internal_friction;   ///< (bond)
  ScalarField<double> damping;             ///< (bond) s/m

  KOKKOS_FORCEINLINE_FUNCTION bool given() const { return normal_modulus.extent(0) > 0; }
};

/// All bonds, SI, 1 m thick. Bond k joins the edge p -> q of particle a, which lies on its left, to particle b. In a
/// run the coupling gives d_c to Mechanics::dissolve.
struct Bonds {
  int count = 0;

  Kokkos::View<int* [2], Kokkos::LayoutLeft> pair;    ///< (bond, end) particles a and b
  Kokkos::View<int* [2], Kokkos::LayoutLeft> vertex;  ///< (bond, end) vertex numbers of p and q
  ScalarField<double> length;                         ///< l of the edge, m
  ScalarField<double> spacing;                        ///< h = (x_b - x_a) . n of the two centroids, m
  VectorField<double> normal;                         ///< (bond, axis) n at the start, from a to b; t = (-n_y, n_x)
  /// (bond, point, end, axis) lever arm of an integration point in the body frame of each end, m.
  Kokkos::View<double* [2][2][2], Kokkos::LayoutLeft> arm;

  BondElasticity elasticity;
  ScalarField<double> normal_strength;  ///< drawn, at d_c = 0, Pa
  ScalarField<double> cohesion;         ///< drawn, Pa
  ScalarField<double> energy_I;         ///< drawn, N/m
  ScalarField<double> energy_II;        ///< drawn, N/m

  Kokkos::View<double* [2], Kokkos::LayoutLeft> point_damage;  ///< (bond, point) d_m of each integration point
  ScalarField<double> d_m;                                     ///< mean of the two; exactly 1 when both are broken
  ScalarField<double> d_c;                                     ///< chemical damage
  /// Within a step: 1 if a point is beyond its strength and not yet broken. An int because a vector of bytes would hold
  /// so many that a host would compute short runs of bonds one by one.
  IndexList overstressed;
  Kokkos::View<BondState*> state;
  Kokkos::View<std::uint8_t*> joint;  ///< faces_joined, faces_dissolved or faces_apart
  /// [bond_has_failed]: 1 for good, from the start where rock has cracks or faces itself; contacts are then active.
  /// [cracks_have_changed]: 1 until the search for contacts has noticed.
  IndexList events;
  Kokkos::View<double* [2], Kokkos::LayoutLeft> slip;    ///< (bond, point) slider of the crack's friction, m
  Kokkos::View<double* [2], Kokkos::LayoutLeft> stress;  ///< (bond, normal/tangential) mean of the two points, Pa

  /// (bond, component) force on a, torque on a, torque on b; the force on b is the opposite. One additional entry,
  /// after those of the bonds, stays zero.
  Kokkos::View<double* [4], Kokkos::LayoutLeft> load;

  IndexList row;    ///< (particle + 1) the entries of particle i are [row(i), row(i + 1))
  IndexList entry;  ///< 2 * bond + end, ascending in each row
  /// (particle, edge) the same entries, padded with 2 * count, which is the entry of the zero load.
  Kokkos::View<int* [3], Kokkos::LayoutLeft> slot;
};

/// Makes a bond on every edge that two triangles share, numbered by their lower particle. Throws InputError when three
/// triangles share an edge or two lie on the same side of it, or when an initial crack is not such an edge.
Bonds make_bonds(const Assembly& assembly, const Particles& particles, const MechanicsParameters& parameters);

}  // namespace vug
