// Makes a Scene of a case file: text, TOML with overrides, known names, tables, contradictions, files.
#include "io/case_keys.hpp"
#include "io/detail/case_checks.hpp"
#include "io/detail/case_tables.hpp"
#include "io/detail/case_text.hpp"
#include "io/override_scene.hpp"
#include "io/rock_inertia.hpp"
#include "io/scene.hpp"

#include <algorithm>

namespace vug {

namespace {

/// The outlines of a region: its own form, or those of its mineral.
std::vector<Form> forms_of(const RockRegion& region, const std::vector<MineralSection>& minerals) {
  std::vector<Form> forms;
  if (region.form) forms.push_back(*region.form);
  for (const MineralSection& mineral : minerals)
    for (const RockRegion& part : mineral.regions)
      if (!region.form && mineral.name == region.mineral && part.form) forms.push_back(*part.form);
  return forms;
}

/// Sets the mass scaling to the largest that the tolerance allows, unless that of the preset is larger. A preset that
/// the case does not give, but the tolerance stands for, was measured with blocks of rock that fluid and heat load.
void choose_mass_scaling(Scene& scene, bool has_preset) {
  double& scaling = scene.mechanics->parameters.mass_scaling;
  if (!has_preset && feels_its_mass(scene)) scaling = 1;
  const double allowed = quasi_static_mass_scaling(scene, scene.accuracy.tolerance);
  scene.mechanics->scaling_chosen = allowed > scaling;
  scaling = std::max(scaling, allowed);
}

}  // namespace

bool rock_dissolves(const Scene& scene) {
  if (!scene.reaction) return false;
  const auto dissolves = [](const MineralSection& mineral) { return !mineral.inert && mineral.molar_volume > 0; };
  return scene.reaction->molar_volume > 0 || std::any_of(scene.minerals.begin(), scene.minerals.end(), dissolves);
}

bool turns_back(const Scene& scene, std::size_t r) {
  const RateLaw& of_rock = r == 0 ? static_cast<const RateLaw&>(*scene.reaction) : scene.reaction->further[r - 1];
  return of_rock.inverse_equilibrium_constant > 0 ||
         std::any_of(scene.minerals.begin(), scene.minerals.end(),
                     [r](const MineralSection& mineral) { return mineral.rates[r].inverse_equilibrium_constant > 0; });
}

std::vector<std::string> passive_species(const Scene& scene) {
  std::vector<std::string> names;
  if (!scene.solute) return names;
  const auto reads = [&](const auto& reaction, std::size_t r, const std::string& name) {
    return reaction.reactant == name || (reaction.product == name && turns_back(scene, r));
  };
  for (const Species& species : scene.solute->species) {
    bool read = scene.reaction && reads(*scene.reaction, 0, species.name);
    for (std::size_t r = 0; scene.reaction && r < scene.reaction->further.size(); ++r)
      read = read || reads(scene.reaction->further[r], r + 1, species.name);
    if (!read) names.push_back(species.name);
  }
  return names;
}

void read_tables(const TomlCursor& root, Scene& scene) {
  if (const auto table = root.table("case"); table.given()) read_case(table, scene);
  const auto laboratory = root.table("laboratory");
  if (!laboratory.given() || root.describing()) {  // a laboratory test has neither
    scene.lattice = read_lattice(root.table("lattice"));
    scene.time = read_time(root.table("time"));
  }
  if (const auto table = root.table("geometry"); table.given()) scene.geometry = read_geometry(table);
  if (const auto table = root.table("rock"); table.given()) scene.rock = read_rock(table);
  if (const auto table = root.table("flow"); table.given()) scene.flow = read_flow(table);
  if (const auto table = root.table("heat"); table.given()) scene.heat = read_heat(table);
  if (const auto table = root.table("solute"); table.given()) scene.solute = read_solute(table);
  if (const auto table = root.table("reaction"); table.given()) scene.reaction = read_reaction(table, scene.solute);
  for (const TomlCursor& mineral : root.tables("mineral")) scene.minerals.push_back(read_mineral(mineral, scene));
  const auto accuracy = root.table("accuracy");
  const Preset preset = accuracy.given() ? read_preset(accuracy) : Preset::careful;
  if (const auto table = root.table("mechanics"); table.given()) {
    scene.mechanics = read_mechanics(table, mechanics_of(preset));
    if (scene.mechanics->lets_fragments_go && !rock_dissolves(scene))
      table.refuse("fragments", "is for rock that dissolves: it needs the table [reaction] with a molar_volume");
  }
  if (scene.rock && scene.mechanics)
    for (const RockRegion& region : scene.mechanics->regions)
      for (const Form& form : forms_of(region, scene.minerals)) scene.rock->borders.push_back(form);
  if (const auto table = root.table("damage"); table.given()) {
    ChemicalDamageLaw unused;  // damage without mechanics is refused later, with a better message
    const bool in_metres = scene.rock && scene.rock->pathway_width;
    scene.damage = read_damage(table, in_metres, scene.mechanics ? scene.mechanics->parameters.chemical : unused);
  }
  if (scene.rock && scene.rock->pathway_width && !scene.damage)
    root.table("rock").refuse("pathway_width", "needs [damage], whose pathways may be narrower than a cell");
  if (laboratory.given()) scene.laboratory = read_laboratory(laboratory, scene.rock && scene.rock->mesh);
  const auto boundary = root.table("boundary");
  scene.left = read_boundary(boundary.table("left", "<side>"));
  if (!root.describing()) {
    scene.right = read_boundary(boundary.table("right", "<side>"));
    scene.bottom = read_boundary(boundary.table("bottom", "<side>"));
    scene.top = read_boundary(boundary.table("top", "<side>"));
  }
  scene.injections = read_injections(boundary);
  scene.openings = read_openings(boundary, scene.geometry);
  const bool may_age = rock_dissolves(scene) && !scene.heat && !scene.mechanics && scene.time.end &&
                       passive_species(scene).empty();  // whose times would be those of the fluid
  if (accuracy.given()) scene.accuracy = read_accuracy(accuracy, preset, may_age, scene.flow.has_value());
  const auto mechanics = root.table("mechanics");
  // more mass gains nothing where the sub-steps are given
  const bool given = mechanics.has("mass_scaling") || mechanics.has("substeps");
  if (scene.mechanics && !scene.laboratory && scene.accuracy.tolerance > 0 && !given)
    choose_mass_scaling(scene, accuracy.has("preset"));
  if (const auto table = root.table("output"); table.given()) scene.output = read_output(table);
}

const std::vector<KeyDescription>& case_keys() {
  static const std::vector<KeyDescription> keys = [] {
    KeyLog log;
    Scene unused;
    read_tables(TomlCursor(log), unused);
    return log;
  }();
  return keys;
}

Scene override_scene(const Scene& scene, const std::vector<std::string>& more) {
  std::vector<std::string> overrides = scene.overrides;
  overrides.insert(overrides.end(), more.begin(), more.end());
  return parse_scene(scene.source_text, scene.path, overrides);
}

std::vector<std::string> input_files(const Scene& scene) {
  std::vector<std::string> files;
  if (scene.rock && scene.rock->mesh) files.push_back(*scene.rock->mesh);
  if (scene.geometry.kind == GeometryKind::image) files.push_back(scene.geometry.image.file);
  return files;
}

Scene parse_scene(const std::string& text, const std::string& path, const std::vector<std::string>& overrides) {
  check_text(text, path);
  const TomlDocument document(text, path, overrides);
  check_names(document);
  Scene scene;
  scene.path = path;
  scene.source_text = text;
  scene.overrides = overrides;
  read_tables(TomlCursor(document), scene);
  if (scene.laboratory) {
    if (!scene.mechanics) scene.mechanics.emplace();
    check_laboratory(document, scene);
    check_groups(document, scene);
    check_files(document, scene);
    collect_warnings(scene);
    return scene;
  }
  check_modules(document, scene);
  if (scene.flow && scene.heat) {
    FlowSection& flow = *scene.flow;
    if (flow.reference_temperature == 0) flow.reference_temperature = scene.heat->initial_temperature;
    if (!flow.viscosity_table.empty()) flow.viscosity = flow.viscosity_at(flow.reference_temperature);
  }
  check_scales(document, scene);
  check_species(document, scene);
  check_minerals(document, scene);
  check_places(document, scene);
  check_groups(document, scene);
  check_ageing(document, scene);
  check_times(document, scene);
  if (scene.mechanics) check_traction(document, scene);
  check_boundaries(document, scene);
  check_files(document, scene);
  collect_warnings(scene);
  return scene;
}

Scene read_scene(const std::string& path, const std::vector<std::string>& overrides) {
  return parse_scene(read_case_text(path), path, overrides);
}

}  // namespace vug
