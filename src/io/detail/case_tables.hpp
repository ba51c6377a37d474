#pragma once
// One function per table of the case file, from keys to struct. Each is called with the table's cursor only when the
// table is given (or when the keys are being described). Checks between tables are in case_checks.hpp.
#include "io/detail/plain_name.hpp"
#include "io/detail/toml_cursor.hpp"
#include "io/presets.hpp"
#include "io/scene.hpp"

namespace vug {

/// Reads the keys of a form, `type` first. With a mesh `type` may be "group"; then nothing is returned.
enum class FormOf { geometry, mesh, rock };  ///< with `rock` the type may also be "mineral"
std::optional<Form> read_form(const TomlCursor& table, FormOf of);
/// A form or, where there is a mesh, its named surface: keys of a form and `group`; with FormOf::rock also `mineral`.
RockRegion read_region(const TomlCursor& table, FormOf of);

/// Reads the required key `side`.
void read_side(const TomlCursor& table, Side& side);

void read_case(const TomlCursor& table, Scene& scene);
LatticeSection read_lattice(const TomlCursor& table);
TimeSection read_time(const TomlCursor& table);
GeometrySection read_geometry(const TomlCursor& table);
RockSection read_rock(const TomlCursor& table);
FlowSection read_flow(const TomlCursor& table);
HeatSection read_heat(const TomlCursor& table);
SoluteSection read_solute(const TomlCursor& table);
/// Uses the solutes for the diffusivity in the Damkohler number.
ReactionSection read_reaction(const TomlCursor& table, const std::optional<SoluteSection>& solute);
/// Reads the keys of a rate. Where one is absent, `rate` keeps the value of the rock.
void read_own_rate(const TomlCursor& table, RateLaw& rate);
inline constexpr Unit equilibrium_unit{"1", 1e100};
inline constexpr Range equilibrium_range{.low = 1e-12, .infinity_allowed = true};
/// Where a value is absent, it is that of the reaction or the heat of the scene.
MineralSection read_mineral(const TomlCursor& table, const Scene& scene);
/// `fallback` has the values that the case's preset chooses.
MechanicsSection read_mechanics(const TomlCursor& table, const MechanicsSection& fallback);
/// Reads one key of [mechanics.bond] before the others, because the profile of [mechanics] needs it.
void read_weibull_shape(const TomlCursor& bonds, BondParameters& bond);
/// Reads the parts of [mechanics] on bonds, elasticity and the materials of regions.
void read_materials(const TomlCursor& table, MechanicsSection& mechanics);
/// Also fills the chemical law of the mechanics. `in_metres`: widths are in metres (rock.pathway_width).
DamageSection read_damage(const TomlCursor& table, bool in_metres, ChemicalDamageLaw& chemical);
/// `meshed`: the size of the specimen is that of the rock's mesh.
LaboratorySection read_laboratory(const TomlCursor& table, bool meshed);
TractionBoundary read_traction(const TomlCursor& table);
BoundarySection read_boundary(const TomlCursor& table);
std::vector<InjectionSection> read_injections(const TomlCursor& boundary);
/// The tables [boundary.shape.<name>] of the shapes that have a name.
std::vector<OpeningSection> read_openings(const TomlCursor& boundary, const GeometrySection& geometry);
Preset read_preset(const TomlCursor& table);
/// `may_age`: a tolerance may let the rock age faster than the fluid. `flows`: the case has [flow].
AccuracySection read_accuracy(const TomlCursor& table, Preset preset, bool may_age, bool flows);
std::vector<Gauge> read_gauges(const TomlCursor& output);
OutputSection read_output(const TomlCursor& table);

/// All tables of a case, in the order of docs/case-file.md.
void read_tables(const TomlCursor& root, Scene& scene);

}  // namespace vug
