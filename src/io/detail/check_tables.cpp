// Checks which tables a case needs, and that the files which it names exist.
#include "io/detail/case_checks.hpp"
#include "io/detail/input_file.hpp"
#include "io/message.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

namespace vug {
namespace {

void check_file(const TomlDocument& document, const std::string& key, std::string& file) {
  namespace fs = std::filesystem;
  if (file.empty()) document.fail(key, "must name a file");
  fs::path path(file);
  if (path.is_relative()) path = fs::path(document.path()).parent_path() / path;
  const std::string where = path.lexically_normal().string();
  if (const std::string why = detail::why_no_file(where); !why.empty())
    document.fail(key, fmt::format("{} (looked for {})", why, excerpt(where, 200)));
  file = where;
}

/// Properties of the flow that depend on the temperature need [heat].
void check_thermal_flow(const TomlDocument& document, const Scene& scene) {
  const FlowSection& flow = *scene.flow;
  const bool gravity = flow.gravity[0] != 0 || flow.gravity[1] != 0;
  if (gravity && flow.thermal_expansion == 0)
    document.fail(
        "flow.gravity",
        "acts on differences of density (Boussinesq) and needs flow.thermal_expansion; a uniform driving force "
        "is flow.body_force");
  if (flow.thermal_expansion != 0 && !gravity)
    document.fail("flow.thermal_expansion", "needs flow.gravity, [0, -9.81] on earth");
  for (const char* key : {"gravity", "viscosity_activation_energy", "viscosity_table", "reference_temperature"}) {
    const std::string name = std::string("flow.") + key;
    if (!scene.heat && document.find(name) != nullptr)
      document.fail_at(name, fmt::format("{} needs the table [heat]", name));
  }
  const auto given = [&](const char* key) { return document.find(std::string("flow.") + key) != nullptr; };
  if (given("reference_temperature") && !given("gravity") && !given("viscosity_activation_energy"))
    document.fail("flow.reference_temperature",
                  "is that of flow.gravity and flow.viscosity_activation_energy, and the case has neither");
  const bool two_rates = flow.collision == Collision::trt || flow.collision == Collision::bgk;
  if (flow.viscosity_varies() && !two_rates)
    document.fail("flow.collision", "has rates of one viscosity; where that depends on the temperature use trt or bgk");
}

}  // namespace

void check_modules(const TomlDocument& document, const Scene& scene) {
  const bool rock = scene.geometry.kind == GeometryKind::rock;
  if (rock && !scene.rock) document.fail("geometry.type", "needs the table [rock]");
  if (scene.rock && !rock) document.fail_at("rock", "[rock] needs geometry.type = \"rock\"");
  if (scene.reaction && !scene.solute) document.fail_at("reaction", "[reaction] needs the table [solute]");
  if (scene.mechanics && !scene.rock)
    document.fail_at("mechanics", "[mechanics] needs the table [rock] (and geometry.type = \"rock\")");
  if (scene.flow) check_thermal_flow(document, scene);
  if (!scene.output.gauges.empty() && !scene.mechanics)
    document.fail_at("output.gauges", "[[output.gauges]] needs the table [mechanics]");
  if (scene.damage && !scene.mechanics) document.fail_at("damage", "[damage] needs the table [mechanics]");
  if (!scene.flow && !scene.heat && !scene.solute && !scene.mechanics) {
    document.fail_at("", "the case models nothing; it needs at least one of [flow], [heat], [solute], [mechanics]");
  }
}

void check_ageing(const TomlDocument& document, const Scene& scene) {
  const std::string key = "accuracy.dissolution_tolerance";
  if (scene.accuracy.dissolution_tolerance == 0) return;
  if (document.find("accuracy.dissolution_factor"))
    document.fail("accuracy.dissolution_factor", "stands beside accuracy.dissolution_tolerance, which chooses it");
  for (const auto& [there, table] :
       {std::pair{scene.heat.has_value(), "[heat]"}, {scene.mechanics.has_value(), "[mechanics]"}})
    if (there)
      document.fail(
          key, fmt::format("is for rock that ages faster than the fluid, and {} cannot; leave one of them out", table));
  if (!rock_dissolves(scene)) document.fail(key, "needs rock that dissolves: [reaction] with a molar_volume");
  if (scene.flow && scene.accuracy.flow_tolerance == 0)
    document.fail(key, "needs to know when the flow is steady: give accuracy.flow_tolerance as well, 1e-3 or so");
}

void check_groups(const TomlDocument& document, const Scene& scene) {
  const auto check = [&](const std::string& key, const RockRegion& region) {
    const auto named = [&](const MineralSection& mineral) { return mineral.name == region.mineral; };
    if (!region.group.empty() && !(scene.rock && scene.rock->mesh))
      document.fail(key + ".group", "is a named surface of a mesh; it needs rock.mesh");
    if (!region.mineral.empty() && std::none_of(scene.minerals.begin(), scene.minerals.end(), named))
      document.fail(key + ".mineral", "is not the name of a [[mineral]]");
  };
  for (std::size_t i = 0; i < scene.minerals.size(); ++i)
    for (std::size_t r = 0; r < scene.minerals[i].regions.size(); ++r)
      check(fmt::format("mineral.{}.shapes.{}", i, r), scene.minerals[i].regions[r]);
  if (!scene.mechanics) return;
  for (std::size_t i = 0; i < scene.mechanics->regions.size(); ++i)
    check(fmt::format("mechanics.material.{}", i), scene.mechanics->regions[i]);
  for (std::size_t i = 0; i < scene.mechanics->initial_velocities.size(); ++i)
    check(fmt::format("mechanics.initial_velocity.{}", i), scene.mechanics->initial_velocities[i].region);
}

void check_files(const TomlDocument& document, Scene& scene) {
  if (scene.geometry.kind == GeometryKind::image) check_file(document, "geometry.file", scene.geometry.image.file);
  if (scene.rock && scene.rock->mesh) check_file(document, "rock.mesh", *scene.rock->mesh);
}

}  // namespace vug
