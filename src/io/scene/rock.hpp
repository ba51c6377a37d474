#pragma once
// The bonded rock: its triangles, its minerals, its mechanics and what its cracks open to the fluid.
#include "dem/parameters.hpp"
#include "io/scene/geometry.hpp"
#include "io/scene/reaction.hpp"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace vug {

/// A straight line along which the rock is cracked from the start; one of a row of lines is a notch each.
struct Notch {
  std::array<double, 2> from, to;  ///< m
  double aperture = 3;             ///< cells
  std::optional<double> width{};   ///< m, with RockSection::pathway_width, which it is if it is not given
  int entry = 0;                   ///< number in the case file
};
/// A rectangular cavity cut into a side of the rock, where fluid is injected.
struct InjectionHole {
  std::array<double, 2> from, to;  ///< opposite corners, m
};
struct RockSection {
  std::optional<std::string> mesh;  ///< Gmsh .msh file; otherwise the generator
  double element_size = 0;          ///< m, mean edge
  double grading = 1;               ///< largest over smallest element size (1 = uniform), finest at the injection hole
  std::uint64_t seed = 1;
  double porosity = 0;          ///< share of the rock that pathways take from the start
  double pathway_aperture = 3;  ///< cells
  /// m. If given, all widths are metres and pathways conduct by the cubic law however many cells that is; no aperture
  /// in cells counts.
  std::optional<double> pathway_width{};
  std::vector<Notch> notches;
  std::vector<Form> borders;  ///< outlines that generated triangles follow: those of the materials
  std::optional<InjectionHole> hole;
  std::vector<Form> holes;  ///< cut out of generated triangles, at a side or inside
};

/// Some of the rock's triangles.
struct RockRegion {
  std::optional<Form> form;  ///< those whose centroid it holds
  std::string group;         ///< without a form: those of this named surface of the mesh
  std::string mineral;       ///< with neither: those whose centroid lies in this mineral
};
/// A mineral of the rock: where it is and what it is; what is left out is as of the rock ([reaction], [heat]).
struct MineralSection {
  std::string name;
  std::vector<RockRegion> regions;   ///< nodes that they hold, or nodes of triangles of their groups
  std::vector<std::int64_t> labels;  ///< pixels of a label map
  bool inert = false;                ///< no reactant attacks it
  std::vector<RateLaw> rates;        ///< of the reactant, then of the further ones; empty without [reaction]
  double molar_volume = 0;           ///< m3/mol
  double diffusivity = 0;            ///< m2/s, of heat; this and the next two 0 without [heat]
  double density = 0;                ///< kg/m3
  double heat_capacity = 0;          ///< J/(kg K)
};

/// What moves at the start of the run.
struct InitialVelocity {
  RockRegion region;
  std::array<double, 2> velocity;  ///< m/s
};

struct MechanicsSection {
  /// Or "calibrated": cohesion re-fitted to the measured strength; or "weibull-scale".
  std::string profile = "paper-literal";
  MechanicsParameters parameters;
  std::vector<RockRegion> regions;      ///< of parameters.materials, one each; later ones paint over earlier ones
  std::array<double, 2> gravity{0, 0};  ///< m/s2
  std::vector<InitialVelocity> initial_velocities;
  std::optional<int> substeps;     ///< per lattice step; absent: from the critical step
  double critical_fraction = 0.3;  ///< of the critical time step that a sub-step may take
  bool force_unstable = false;     ///< accept a sub-step above the critical one
  bool static_preload = true;      ///< the outer stress by a direct solver, by a ramp where that does not lead there
  double preload_time = 150e-6;    ///< s over which the outer stress is ramped before the run
  double preload_damping = 0.7;    ///< Cundall's alpha until the rock is at rest
  bool from_unloaded = false;      ///< displacements count from the rock before the preload
  bool scaling_chosen = false;     ///< parameters.mass_scaling is what a tolerance allows (rock_inertia.hpp)
  bool lets_fragments_go = false;  ///< a triangle that has left its place carries and pushes nothing any more
};

/// What the aperture of a damaged bond's pathway follows: d_m and c_d (paper), or how far its faces have parted.
enum class ApertureLaw { damage, opening };
struct DamageSection {
  ApertureLaw aperture = ApertureLaw::damage;
  double pathway_factor = 0.2;            ///< c_d: aperture of a broken bond over the distance of its centroids
  double minimum_aperture = 3;            ///< cells
  std::optional<double> minimum_width{};  ///< m, with RockSection::pathway_width, which it is if it is not given
  double residual_aperture = 0;           ///< m, of a crack that is closed; with ApertureLaw::opening
};

}  // namespace vug
