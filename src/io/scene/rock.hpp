#pragma once
// The bonded rock: its triangles, its minerals, its mechanics and the pathways that its cracks open to the fluid.
#include "dem/parameters.hpp"
#include "io/scene/geometry.hpp"
#include "io/scene/reaction.hpp"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace vug {

/// A straight line along which the rock is cracked from the start. Each piece of a notch with several points is a
/// Notch.
struct Notch {
  std::array<double, 2> from, to;  ///< m
  double aperture = 3;             ///< cells
  std::optional<double> width{};   ///< m, only with RockSection::pathway_width, which is its default
  int entry = 0;                   ///< index in the case file
};
/// A rectangular cavity at a side of the rock, where fluid is injected, or inside the rock.
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
  /// m. If given, all widths are in metres and pathways conduct by the cubic law for any number of cells; apertures in
  /// cells are not used.
  std::optional<double> pathway_width{};
  std::vector<Notch> notches;
  std::vector<Form> borders;  ///< outlines that generated triangles follow: those of the materials
  std::optional<InjectionHole> hole;
  std::vector<Form> holes;  ///< cut out of generated triangles, at a side or inside
};

/// Some of the rock's triangles.
struct RockRegion {
  std::optional<Form> form;  ///< triangles whose centroid it holds
  std::string group;         ///< without a form: triangles of this named surface of the mesh
  std::string mineral;       ///< with neither: triangles whose centroid is in this mineral
};
/// A mineral of the rock: where it is and its properties. Those not given are those of the rock ([reaction], [heat]).
struct MineralSection {
  std::string name;
  std::vector<RockRegion> regions;   ///< nodes in forms, or nodes of the triangles of groups
  std::vector<std::int64_t> labels;  ///< of pixels in a label map
  bool inert = false;                ///< no reactant dissolves it
  std::vector<RateLaw> rates;        ///< of the reactant, then of the further ones; empty without [reaction]
  double molar_volume = 0;           ///< m3/mol
  double diffusivity = 0;            ///< m2/s, of heat; 0 without [heat], like the next two
  double density = 0;                ///< kg/m3
  double heat_capacity = 0;          ///< J/(kg K)
};

/// A region that moves at the start of the run.
struct InitialVelocity {
  RockRegion region;
  std::array<double, 2> velocity;  ///< m/s
};

struct MechanicsSection {
  /// Or "calibrated": cohesion re-fitted to the measured strength; or "weibull-scale".
  std::string profile = "paper-literal";
  MechanicsParameters parameters;
  std::vector<RockRegion> regions;  ///< one for each of parameters.materials; where they overlap, the later one counts
  std::array<double, 2> gravity{0, 0};  ///< m/s2
  std::vector<InitialVelocity> initial_velocities;
  std::optional<int> substeps;     ///< per lattice step; absent: from the critical step
  double critical_fraction = 0.3;  ///< of the critical time step that a sub-step may take
  bool force_unstable = false;     ///< accept a sub-step above the critical one
  bool static_preload = true;  ///< the outer stress is applied by a direct solver, or by a ramp where the solver fails
  double preload_time = 150e-6;    ///< s over which the outer stress is ramped before the run
  double preload_damping = 0.7;    ///< Cundall's alpha, used until the rock is at rest
  bool scaling_chosen = false;     ///< parameters.mass_scaling is what a tolerance allows (rock_inertia.hpp)
  bool lets_fragments_go = false;  ///< pieces that have left their place no longer carry or push anything
};

/// What determines the aperture of a damaged bond's pathway: d_m and c_d (paper), or how far its faces have parted.
enum class ApertureLaw { damage, opening };
/// How wide a pathway that the rock has from the start becomes by damage: the larger of its own width and that of a
/// broken bond, or their sum.
enum class PathwayWidening { largest, added };
struct DamageSection {
  ApertureLaw aperture = ApertureLaw::damage;
  PathwayWidening widening = PathwayWidening::largest;
  double pathway_factor = 0.2;            ///< c_d: aperture of a broken bond over the distance of its centroids
  double minimum_aperture = 3;            ///< cells
  std::optional<double> minimum_width{};  ///< m, only with RockSection::pathway_width, which is its default
  double residual_aperture = 0;           ///< m, of a crack that is closed; with ApertureLaw::opening
};

}  // namespace vug
