#pragma once
// The case, parsed: plain structs in SI, one per table of the case file. A table that is absent is physics that is not
// modelled. Units and ranges of every key are in docs/case-file.md.
#include "dem/parameters.hpp"
#include "dem/support.hpp"
#include "io/time_table.hpp"
#include "kernels/choices.hpp"

#include <array>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace vug {

struct LatticeSection {
  double length_x = 0, length_y = 0;  ///< size = [Lx, Ly], m
  double spacing = 0;                 ///< m
  double time_step = 0;               ///< s
  int nx = 0, ny = 0;                 ///< derived: nodes
};

struct TimeSection {
  std::optional<double> end;          ///< s
  std::optional<std::int64_t> steps;  ///< lattice steps; exactly one of the two is given
};

struct Rectangle {
  std::array<double, 2> from, to;
};
struct Disc {
  std::array<double, 2> centre;
  double radius;
};
struct Polygon {
  std::vector<std::array<double, 2>> points;
};
using Form = std::variant<Rectangle, Disc, Polygon>;
/// A shape drawn on the lattice in the order of the file; later shapes paint over earlier ones. Coordinates in m.
struct Shape {
  Form form;
  bool solid = true;
  std::string name;  ///< of an opening, with conditions on its surface instead of a material; empty: none
};

/// Type of the values of a picture without a header.
enum class SampleType { uint8, uint16, uint32, uint64, int8, int16, int32, int64, float32, float64 };
enum class CoarsenRule { majority, mean };
enum class ImageTurn { none, left, half, right };
enum class ImageMirror { none, left_right, top_bottom };

/// A picture of rock. Columns and rows count from 0 at its upper left corner.
struct ImageSection {
  std::string file;        ///< path as resolved against the folder of the case
  double threshold = 0.5;  ///< of the grey value, 0 is black and 1 white; darker is solid
  bool invert = false;
  std::array<double, 2> grey_range{0, 0};  ///< values that are black and white; equal: 0 and the largest of the type
  std::vector<std::int64_t> solid_labels, fluid_labels;  ///< a label map instead of a threshold when there are any
  int page = 0;                                          ///< of a stack
  std::optional<double> pixel_size;                      ///< m; otherwise that of the file, if it says one
  std::array<int, 2> crop_from{0, 0};                    ///< column, row
  std::array<int, 2> crop_size{0, 0};                    ///< columns, rows; 0: to the far edge
  ImageTurn rotate = ImageTurn::none;      ///< a quarter turn to the left is counter-clockwise; after cropping
  ImageMirror mirror = ImageMirror::none;  ///< after turning
  int coarsen = 1;                         ///< pixels along the edge of a cell
  CoarsenRule coarsen_rule = CoarsenRule::majority;
  std::array<int, 2> raw_size{0, 0};  ///< columns, rows of a file without a header
  SampleType raw_type = SampleType::uint8;
  bool raw_big_endian = false;
  int raw_pages = 1;
  std::map<std::int64_t, std::uint8_t> minerals;  ///< of labels: number of the mineral, from 1; of others 0

  bool labelled() const { return !solid_labels.empty() || !fluid_labels.empty(); }
};

enum class GeometryKind { open, image, shapes, rock };
struct GeometrySection {
  GeometryKind kind = GeometryKind::open;
  std::string background = "fluid";  ///< of "shapes": what is there before the first shape
  std::vector<Shape> shapes;         ///< of all kinds but "shapes": openings only
  ImageSection image;
};

/// A straight line along which the rock is cracked from the start; one of a row of lines is a notch each.
struct Notch {
  std::array<double, 2> from, to;  ///< m
  double aperture = 3;             ///< cells
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
  std::vector<Notch> notches;
  std::vector<Form> borders;  ///< outlines that generated triangles follow: those of the materials
  std::optional<InjectionHole> hole;
  std::vector<Form> holes;  ///< cut out of generated triangles, at a side or inside
};

struct FlowSection {
  double density = 1000;                   ///< kg/m3
  double viscosity = 0;                    ///< kinematic, m2/s
  double viscosity_activation_energy = 0;  ///< J/mol, of the Arrhenius law about the reference temperature
  /// (K, m2/s); then `viscosity` is that at the reference temperature.
  std::vector<std::array<double, 2>> viscosity_table;
  std::array<double, 2> gravity{0, 0};  ///< m/s2, on differences of density
  double thermal_expansion = 0;         ///< 1/K, of the volume
  double reference_temperature = 0;     ///< K, of density and viscosity; heat.initial_temperature unless given
  Collision collision = Collision::trt;
  std::array<double, 2> body_force{0, 0};  ///< m/s2
  double initial_pressure = 1e5;           ///< Pa, also the reference of the gauge pressure
  double speed_limit = 0.2;                ///< lattice units; 0 switches the limiter off

  bool buoyant() const { return thermal_expansion != 0 && (gravity[0] != 0 || gravity[1] != 0); }
  bool viscosity_varies() const { return viscosity_activation_energy != 0 || !viscosity_table.empty(); }
  /// Kinematic viscosity at a temperature (K), m2/s: nu exp(E_a / R (1/T - 1/T_0)), or from the table.
  double viscosity_at(double temperature) const;

  /// S_p >= 1 for coarse lattices: the lattice flows under the gauge pressures of the case divided by it, and what the
  /// fluid does to the rock, and every pressure written out, is multiplied by it (docs/model.md)
  double pressure_scale = 1;
};

struct HeatSection {
  ScalarVelocitySet velocity_set = ScalarVelocitySet::d2q5;
  double fluid_diffusivity = 0, solid_diffusivity = 0;            ///< m2/s
  double fluid_density = 1000, solid_density = 2500;              ///< kg/m3
  double fluid_heat_capacity = 4000, solid_heat_capacity = 1000;  ///< J/(kg K)
  double initial_temperature = 293.15;                            ///< K
};

struct Species {
  std::string name;
  double diffusivity = 0;  ///< m2/s
  double initial = 0;      ///< mol/m3
};
struct SoluteSection {
  std::vector<Species> species;
  ScalarVelocitySet velocity_set = ScalarVelocitySet::d2q5;
  /// tau_h of the lattice kinetic scheme; absent: chosen so that Lambda = 1/4
  std::optional<double> relaxation_time;
  bool advective_form = true;  ///< keep a uniform concentration uniform in a stair-step flow
};

/// How fast one reactant attacks one solid.
struct RateLaw {
  double rate_constant = 0;      ///< k_r^0 at the reference temperature, m/s (also when given by Da and length)
  double activation_energy = 0;  ///< J/mol
  double inverse_equilibrium_constant = 0;  ///< 1/K_eq; 0 = irreversible
  double order = 1;                         ///< n in k C_ref (C/C_ref)^n
  double stoichiometry = 1;                 ///< moles of reactant that a mole of the solid takes
};
/// One more reactant that attacks the same walls, whatever the others do there.
struct FurtherReactant : RateLaw {
  std::string reactant;                ///< name of a species
  std::optional<std::string> product;  ///< name of a species
};

struct ReactionSection : RateLaw {
  std::string reactant;                ///< name of a species
  std::optional<std::string> product;  ///< name of a species
  std::vector<FurtherReactant> further;
  double reference_concentration = 1000;  ///< C_ref of orders other than 1, mol/m3
  double reference_temperature = 273.15;  ///< K
  double temperature = 293.15;            ///< K, of the wall where there is no [heat]
  double molar_volume = 0;                ///< of the solid, m3/mol; 0 = the wall reacts but does not dissolve
  std::optional<double> damkohler;        ///< as given, Da = k_r^0 length / D (Eq. 13)
  std::optional<double> length;           ///< m, l_c of the Damkohler number
  ReactiveWallLaw wall = ReactiveWallLaw::kinetic;
  bool surface_normal = true;  ///< correct the staircase area
  BirthFill birth_fill = BirthFill::mean;
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
};

/// What the aperture of a damaged bond's pathway follows: d_m and c_d (paper), or how far its faces have parted.
enum class ApertureLaw { damage, opening };
struct DamageSection {
  ApertureLaw aperture = ApertureLaw::damage;
  double pathway_factor = 0.2;   ///< c_d: aperture of a broken bond over the distance of its centroids
  double minimum_aperture = 3;   ///< cells
  double residual_aperture = 0;  ///< m, of a crack that is closed; with ApertureLaw::opening
};

enum class LaboratoryTest { compression, tension, brazilian, heating, quench };
/// A loading test of bonded rock alone, without a lattice.
struct LaboratorySection {
  LaboratoryTest test = LaboratoryTest::compression;
  std::array<double, 2> size{0, 0};    ///< of the block, m
  double diameter = 0;                 ///< of the disc, m
  double flat_width = 0.174;           ///< of the disc's flats under the platens, over the diameter (20 degrees of arc)
  std::optional<double> platen_speed;  ///< m/s; absent: 0.5 in compression, 0.1 in tension and splitting
  double confinement = 0;              ///< Pa
  Support flanks = Support::free;      ///< free: the confinement is a membrane's dead load; servo: that of platens
  double chemical_damage = 0;          ///< d_c of all bonds
  double temperature_change = 0;       ///< K: rise at the end of heating, or fall of the quenched face
  double duration = 1e-3;              ///< s in which it is heated or the cold has come down by the diffusion length
  double diffusion_length = 0.01;      ///< 2 sqrt(kappa t) at the end of a quench, m
  /// Of the quenched face: heat transfer coefficient x height / conductivity.
  double biot = std::numeric_limits<double>::infinity();
  double largest_strain = 0.02;  ///< where a loading test ends at the latest
  double sample_strain = 1e-5;   ///< between two points of its curve
  int samples = 200;             ///< temperatures of a quench
};

/// Of the moving platen, m/s; when it is not given, so slow that strengths are within 4 % of those at a quarter of it.
inline double platen_speed(const LaboratorySection& laboratory) {
  return laboratory.platen_speed.value_or(laboratory.test == LaboratoryTest::compression ? 0.5 : 0.1);
}

enum class FlowBoundaryKind { wall, pressure, velocity, outflow, periodic };
struct FlowBoundary {
  FlowBoundaryKind kind = FlowBoundaryKind::wall;
  TimeTable pressure;                       ///< Pa, absolute
  std::array<TimeTable, 2> velocity;        ///< m/s (wall: tangential speed of a moving wall)
  double ramp_time = 0;                     ///< s, over which pressure or velocity rise from those of fluid at rest
  TimeTable speed;                          ///< m/s, of fluid that leaves an opening across its surface
  std::optional<TimeTable> flow_rate;       ///< m2/s: volume per depth that enters; then velocity and speed are 0
  std::optional<TimeTable> mass_flow_rate;  ///< kg/(m s), likewise
  VelocityShape profile = VelocityShape::uniform;
  std::vector<std::array<double, 2>> profile_table;  ///< (m along the stretch, share of the velocity)

  bool has_rate() const { return flow_rate || mass_flow_rate; }
  /// Volume per depth that is given to enter, m2/s.
  double rate(double density, double time) const {
    return flow_rate ? flow_rate->at(time) : mass_flow_rate ? mass_flow_rate->at(time) / density : 0.0;
  }
  double peak_rate(double density) const {
    return flow_rate ? flow_rate->peak() : mass_flow_rate ? mass_flow_rate->peak() / density : 0.0;
  }
  /// Largest velocity or speed that is given as such, m/s.
  double peak_speed() const {
    return std::max(std::hypot(velocity[0].peak(), velocity[1].peak()), std::abs(speed.peak()));
  }
  /// When nothing of it changes any more, s.
  double settled() const {
    double last = std::max({ramp_time, pressure.settled(), velocity[0].settled(), speed.settled()});
    if (flow_rate) last = std::max(last, flow_rate->settled());
    return mass_flow_rate ? std::max(last, mass_flow_rate->settled()) : last;
  }
  /// Share of its value that a ramp has reached at a time, s.
  double risen(double time) const { return ramp_time > 0 ? std::min(1.0, time / ramp_time) : 1.0; }
};
/// Whether fluid may cross it.
inline bool is_open(const FlowBoundary& flow) {
  return flow.kind == FlowBoundaryKind::pressure || flow.kind == FlowBoundaryKind::outflow ||
         flow.kind == FlowBoundaryKind::velocity;
}
enum class HeatBoundaryKind { adiabatic, temperature, flux, convection, outflow, periodic };
struct HeatBoundary {
  HeatBoundaryKind kind = HeatBoundaryKind::adiabatic;
  TimeTable temperature;   ///< K
  TimeTable flux;          ///< W/m2 into the domain
  double coefficient = 0;  ///< W/(m2 K) of convection beyond the side, where the temperature is that given
};
enum class SoluteBoundaryKind { no_flux, concentration, flux, outflow, periodic };
struct SoluteBoundary {
  SoluteBoundaryKind kind = SoluteBoundaryKind::no_flux;
  std::map<std::string, TimeTable> concentration;  ///< mol/m3 by species; missing species: 0
  std::map<std::string, TimeTable> flux;           ///< mol/(m2 s) into the lattice, likewise
};
struct TractionLoad {
  Support support = Support::free;
  TimeTable normal_stress;            ///< Pa, compression positive
  TimeTable shear_stress;             ///< Pa, on the rock along the side: positive to the right, or up
  double stiffness = 0;               ///< Pa/m, of the rock beyond: stress added per outward displacement
  std::array<TimeTable, 2> velocity;  ///< m/s, with which a held side is moved after the preload
};
struct TractionPart {
  double from = 0, to = 0;  ///< m along the side; the same: the one triangle there
  TractionLoad load;
};
struct TractionBoundary {
  TractionLoad load;
  std::vector<TractionPart> parts;  ///< with loads of their own; later ones count where they overlap
};
struct BoundarySection {
  FlowBoundary flow;
  HeatBoundary heat;
  SoluteBoundary solute;
  TractionBoundary traction;
};
/// A stretch of one side with conditions of its own.
struct InjectionSection {
  std::string key = "boundary.injection";  ///< of its table
  std::string name = "injection";          ///< for columns and states
  std::string side = "left";
  double centre = 0;  ///< m along the side
  double width = 0;   ///< m
  BoundarySection conditions;
};

/// The conditions on the surface of a shape that has a name.
struct OpeningSection {
  int shape = 0;  ///< index in GeometrySection::shapes
  BoundarySection conditions;
};

enum class Precision { single_precision, double_precision };
struct AccuracySection {
  std::string preset = "careful";
  Precision precision = Precision::double_precision;
  int update_interval = 10;   ///< lattice steps between births, pathway openings and chemical-damage updates
  int wall_interval = 10;     ///< lattice steps between renewals of the normals and rates of reacting walls, at most
  int heat_interval = 1;      ///< lattice steps per heat step
  int solute_interval = 1;    ///< lattice steps per solute step
  int exchange_interval = 1;  ///< lattice steps for which the fluid's force on the triangles is held
  int guard_interval = 100;   ///< lattice steps between checks for divergence
  /// Largest change of velocity between two checks, over the largest velocity, at which the flow is held until the
  /// pores change; 0: never
  double flow_tolerance = 0;
  /// Volume that dissolves per volume that the acid pays for: the rock ages so many times faster than the fluid
  double dissolution_factor = 1;
};

struct Probe {
  std::string name;
  std::array<double, 2> at;  ///< m
};
enum class GaugeKind { displacement, stress, reaction, opening, crack_tip };
/// Numbers of the rock for the history.
struct Gauge {
  std::string name;
  GaugeKind kind = GaugeKind::displacement;
  std::array<double, 2> at{0, 0};              ///< m, of displacement
  std::array<double, 2> from{0, 0}, to{0, 0};  ///< m, of opening; `from` also of crack_tip
  std::array<double, 2> direction{1, 0};       ///< of crack_tip
  std::optional<Form> region;                  ///< of stress
  std::string side;                            ///< of reaction
  std::optional<double> first, last;           ///< m along it
};
struct OutputSection {
  std::optional<double> interval;  ///< s
  std::optional<std::int64_t> interval_steps;
  std::optional<double> history_interval;     ///< s
  std::optional<double> checkpoint_interval;  ///< s
  std::vector<std::string> fields;            ///< empty: all
  bool compress = true;
  bool forces = false;  ///< of the fluid on sides and named shapes, in the history
  bool flows = false;   ///< of mass, heat and species through them, likewise
  std::vector<Probe> probes;
  std::vector<Gauge> gauges;
};

/// Everything a case file says.
struct Scene {
  std::string path;         ///< of the case file
  std::string source_text;  ///< as read, for provenance; overrides are listed below it
  std::vector<std::string> overrides;
  std::vector<std::string> warnings;  ///< one line each: allowed, but probably not meant
  std::string name, description;
  LatticeSection lattice;
  TimeSection time;
  GeometrySection geometry;
  std::optional<RockSection> rock;
  std::optional<FlowSection> flow;
  std::optional<HeatSection> heat;
  std::optional<SoluteSection> solute;
  std::optional<ReactionSection> reaction;
  std::vector<MineralSection> minerals;  ///< in the order of the file: later ones paint over earlier ones
  std::optional<MechanicsSection> mechanics;
  std::optional<DamageSection> damage;
  std::optional<LaboratorySection> laboratory;  ///< then lattice, time and all other physics are absent
  BoundarySection left, right, bottom, top;
  std::vector<InjectionSection> injections;
  std::vector<OpeningSection> openings;  ///< one per named shape, in the order of shapes
  AccuracySection accuracy;
  OutputSection output;
};

/// Whether a reactant dissolves any of the rock.
bool rock_dissolves(const Scene& scene);

/// The files that a case names beside itself: a mesh, an image.
std::vector<std::string> input_files(const Scene& scene);

/// Reads, overrides (`table.key=value`, value in TOML syntax) and validates a case. Throws InputError with
/// `file:line:column: what is wrong, what was expected`, also for a mesh or image that is not there, or FileError when
/// reading fails half-way.
Scene read_scene(const std::string& path, const std::vector<std::string>& overrides = {});

/// As read_scene, from text (tests); `path` is used for messages and relative files.
Scene parse_scene(const std::string& text, const std::string& path, const std::vector<std::string>& overrides = {});

}  // namespace vug
