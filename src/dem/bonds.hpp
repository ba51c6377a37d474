#pragma once
// The bonds that hold the triangles together: one per shared edge, with two integration points.
#include "dem/particles.hpp"

#include <cstdint>

namespace vug {

/// What has become of a bond. The value never decreases; from `failed_in_tension` on nothing holds it together.
enum class BondState : std::uint8_t {
  intact = 0,
  damaged_in_tension = 1,
  damaged_in_shear = 2,
  failed_in_tension = 3,
  failed_in_shear = 4,
  dissolved = 5,         ///< failed because d_c reached its limit; d_m is what it was
  cracked_at_start = 6,  ///< a pre-existing fracture
};

KOKKOS_FORCEINLINE_FUNCTION constexpr bool has_failed(BondState state) {
  return state >= BondState::failed_in_tension;
}

/// How the two triangles of a bond feel each other, beside what holds them together.
inline constexpr std::uint8_t faces_apart = 0,  ///< parted by half an edge: by their outlines
    faces_joined = 1,                           ///< by the faces of the crack
    faces_dissolved = 2;                        ///< by what is left of the faces, and by the outlines behind them

inline constexpr int bond_has_failed = 0, cracks_have_changed = 1;

/// Half the distance of the two Gauss points of an edge over half its length; each stands for half of the edge.
inline constexpr double gauss_point = 0.57735026918962576;

/// What bonds are made of where the rock is of several materials; empty where it is of one (bond_elasticity.hpp).
struct BondElasticity {
  ScalarField<double> normal_modulus;      ///< (bond) Pa
  ScalarField<double> tangential_modulus;  ///< (bond) Pa
  ScalarField<double> internal_friction;   ///< (bond)
  ScalarField<double> damping;             ///< (bond) s/m

  KOKKOS_FORCEINLINE_FUNCTION bool given() const { return normal_modulus.extent(0) > 0; }
};

/// All bonds, SI, 1 m thick. Bond k joins the edge p -> q of particle a, which lies on its left, to particle b.
/// The coupling writes d_c, the mechanics everything else.
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
  ScalarField<double> d_m;                                     ///< mean of the two; 1 exactly when it has broken
  ScalarField<double> d_c;                                     ///< chemical damage
  /// Within a step: 1 if a point is beyond its strength and may yet break. An int: of bytes a host would take so many
  /// at once that eight bonds would go one by one.
  IndexList overstressed;
  Kokkos::View<BondState*> state;
  Kokkos::View<std::uint8_t*> joint;  ///< faces_joined, faces_dissolved or faces_apart
  /// [bond_has_failed] for good, from the start where rock faces itself: contacts are awake; [cracks_have_changed]
  /// until they have noticed.
  IndexList events;
  Kokkos::View<double* [2], Kokkos::LayoutLeft> slip;    ///< (bond, point) slider of the crack's friction, m
  Kokkos::View<double* [2], Kokkos::LayoutLeft> stress;  ///< (bond, normal/tangential) mean of the two points, Pa

  /// (bond, component) force on a, torque on a, torque on b; the force on b is the opposite. One entry more than there
  /// are bonds stays zero.
  Kokkos::View<double* [4], Kokkos::LayoutLeft> load;

  IndexList row;    ///< (particle + 1) the entries of particle i are [row(i), row(i + 1))
  IndexList entry;  ///< 2 * bond + end, ascending in each row
  /// (particle, edge) the same entries, filled up with 2 * count: the zero load.
  Kokkos::View<int* [3], Kokkos::LayoutLeft> slot;
};

/// Bonds on every edge that two triangles share, numbered by their lower particle. Throws InputError when three
/// triangles share an edge or two lie on the same side of it, or an initial crack is no such edge.
Bonds make_bonds(const Assembly& assembly, const Particles& particles, const MechanicsParameters& parameters);

}  // namespace vug
