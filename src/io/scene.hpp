#pragma once
// The parsed case: plain structs in SI units, one for each table of the case file. A table that is absent is physics
// that is not modelled. Units and ranges of every key are in docs/case-file.md.
#include "io/scene/boundaries.hpp"
#include "io/scene/fluid.hpp"
#include "io/scene/geometry.hpp"
#include "io/scene/laboratory.hpp"
#include "io/scene/reaction.hpp"
#include "io/scene/rock.hpp"
#include "io/scene/run.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace vug {

/// Everything a case file says.
struct Scene {
  std::string path;         ///< of the case file
  std::string source_text;  ///< as read, recorded as the origin of results; overrides are listed below it
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
  const BoundarySection& side(Side which) const {
    return which == Side::left ? left : which == Side::right ? right : which == Side::bottom ? bottom : top;
  }
  std::vector<InjectionSection> injections;
  std::vector<OpeningSection> openings;  ///< one per named shape, in the order of shapes
  AccuracySection accuracy;
  OutputSection output;
};

/// Whether a reactant dissolves any of the rock.
bool rock_dissolves(const Scene& scene);

/// Whether the product of reaction number r (0: the one of [reaction] itself) turns back into the reactant at some
/// rock.
bool turns_back(const Scene& scene, std::size_t r);

/// Names of the species that no reaction reads: tracers, and products that do not turn back. What dissolves does not
/// depend on them.
std::vector<std::string> passive_species(const Scene& scene);

/// The files that a case names: a mesh, an image.
std::vector<std::string> input_files(const Scene& scene);

/// Reads a case, applies the overrides (`table.key=value`, value in TOML syntax) and validates it. Throws InputError
/// with `file:line:column: what is wrong, what was expected`, also for a mesh or image that does not exist, and
/// FileError when reading fails half-way.
Scene read_scene(const std::string& path, const std::vector<std::string>& overrides = {});

/// The same from text (for tests); `path` is used for messages and relative files.
Scene parse_scene(const std::string& text, const std::string& path, const std::vector<std::string>& overrides = {});

}  // namespace vug
