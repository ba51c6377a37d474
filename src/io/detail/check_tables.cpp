// Which table of a case needs which other, names of species, times, places and files.
#include "io/detail/case_checks.hpp"
#include "io/detail/input_file.hpp"
#include "io/detail/nearest_name.hpp"
#include "io/detail/toml_cursor.hpp"
#include "io/form.hpp"
#include "io/message.hpp"
#include "io/triangle_count.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>

namespace vug {
namespace {

/// A point on the lattice, its edge included; half a cell of slack for decimal fractions.
void check_point(const TomlDocument& document, const LatticeSection& lattice, const std::string& key,
                 const Point& point) {
  const double slack = 1e-6 * lattice.spacing;
  const bool inside = point[0] >= -slack && point[0] <= lattice.length_x + slack && point[1] >= -slack &&
                      point[1] <= lattice.length_y + slack;
  if (!inside) {
    document.fail(
        key, fmt::format("m lies outside the lattice, [0, {:g}] x [0, {:g}] m", lattice.length_x, lattice.length_y));
  }
}

/// Some of a form must be on the lattice.
void require_on_lattice(const TomlDocument& document, const LatticeSection& lattice, const std::string& key,
                        const Form& form) {
  const Box box = box_of(form);
  if (box.x1 > 0 && box.y1 > 0 && box.x0 < lattice.length_x && box.y0 < lattice.length_y) return;
  document.fail(key,
                fmt::format("lies outside the lattice, [0, {:g}] x [0, {:g}] m", lattice.length_x, lattice.length_y));
}

void check_gauge(const TomlDocument& document, const LatticeSection& lattice, const std::string& key,
                 const Gauge& gauge) {
  const bool stress = gauge.kind == GaugeKind::stress, opening = gauge.kind == GaugeKind::opening;
  if (gauge.kind == GaugeKind::displacement || (stress && !gauge.region))
    check_point(document, lattice, key + ".at", gauge.at);
  if (gauge.region) require_on_lattice(document, lattice, key + ".shape", *gauge.region);
  if (gauge.kind == GaugeKind::crack_tip) check_point(document, lattice, key + ".from", gauge.from);
  if (!opening) return;
  check_point(document, lattice, key + ".points", gauge.from);
  check_point(document, lattice, key + ".points", gauge.to);
}

std::vector<std::string> names_of(const SoluteSection& solute) {
  std::vector<std::string> names;
  for (const Species& species : solute.species) names.push_back(species.name);
  return names;
}

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

}  // namespace

namespace {

/// What of the flow depends on the temperature needs one.
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

namespace {

/// Names of a reactant and its product, in the table `key`.
void check_pair(const TomlDocument& document, const std::string& key, const std::vector<std::string>& names,
                const std::string& reactant, const std::optional<std::string>& product) {
  const auto known = [&](const std::string& name) {
    return std::find(names.begin(), names.end(), name) != names.end();
  };
  if (!known(reactant))
    document.fail(key + ".reactant", "is not the name of a [[solute.species]]" + suggestion(reactant, names));
  if (!product) return;
  if (!known(*product))
    document.fail(key + ".product", "is not the name of a [[solute.species]]" + suggestion(*product, names));
  if (*product == reactant) document.fail(key + ".product", "is the reactant; it must be another species");
}

}  // namespace

void check_species(const TomlDocument& document, const Scene& scene) {
  if (!scene.reaction) return;
  const auto names = names_of(*scene.solute);
  const ReactionSection& reaction = *scene.reaction;
  check_pair(document, "reaction", names, reaction.reactant, reaction.product);
  for (std::size_t i = 0; i < reaction.further.size(); ++i) {
    const FurtherReactant& further = reaction.further[i];
    const std::string key = fmt::format("reaction.further.{}", i);
    check_pair(document, key, names, further.reactant, further.product);
    bool again = further.reactant == reaction.reactant;
    for (std::size_t j = 0; j < i; ++j) again = again || reaction.further[j].reactant == further.reactant;
    if (again) document.fail(key + ".reactant", "is that of an earlier reaction; each has its own");
    if (further.reactant == "acid")
      document.fail(key + ".reactant", "is what columns of the history call the first reactant; choose another name");
  }
}

void check_places(const TomlDocument& document, Scene& scene) {
  const LatticeSection& lattice = scene.lattice;
  for (std::size_t i = 0; i < scene.geometry.shapes.size(); ++i) {
    const Form& form = scene.geometry.shapes[i].form;
    require_on_lattice(document, lattice, fmt::format("geometry.shapes.{}", i), form);
    const Box box = box_of(form);
    const auto between_centres = [&](double low, double high) {
      return std::floor(high / lattice.spacing - 0.5) < std::ceil(low / lattice.spacing - 0.5);
    };
    if (scene.geometry.shapes[i].name.empty() && (between_centres(box.x0, box.x1) || between_centres(box.y0, box.y1)))
      scene.warnings.push_back(
          fmt::format("geometry.shapes.{} holds the centre of no cell and leaves no trace on the lattice", i));
  }
  for (std::size_t i = 0; i < scene.output.probes.size(); ++i) {
    check_point(document, lattice, fmt::format("output.probes.{}.at", i), scene.output.probes[i].at);
  }
  for (std::size_t g = 0; g < scene.output.gauges.size(); ++g)
    check_gauge(document, lattice, fmt::format("output.gauges.{}", g), scene.output.gauges[g]);
  for (std::size_t i = 0; i < scene.minerals.size(); ++i)
    for (std::size_t r = 0; r < scene.minerals[i].regions.size(); ++r)
      if (const auto& form = scene.minerals[i].regions[r].form)
        require_on_lattice(document, lattice, fmt::format("mineral.{}.shapes.{}", i, r), *form);
  if (!scene.rock) return;
  const RockSection& rock = *scene.rock;
  for (const Notch& notch : rock.notches) {
    const std::string key = fmt::format("rock.notches.{}", notch.entry);
    const bool row = document.find(key + ".points") != nullptr;
    check_point(document, lattice, key + (row ? ".points" : ".from"), notch.from);
    check_point(document, lattice, key + (row ? ".points" : ".to"), notch.to);
  }
  for (std::size_t i = 0; i < rock.holes.size(); ++i)
    require_on_lattice(document, lattice, fmt::format("rock.holes.{}", i), rock.holes[i]);
  if (rock.hole) {
    check_point(document, lattice, "rock.hole.from", rock.hole->from);
    check_point(document, lattice, "rock.hole.to", rock.hole->to);
  }
  if (scene.mechanics)
    for (std::size_t i = 0; i < scene.mechanics->regions.size(); ++i)
      if (const auto& form = scene.mechanics->regions[i].form)
        require_on_lattice(document, lattice, fmt::format("mechanics.material.{}", i), *form);
  const double largest = std::min(lattice.length_x, lattice.length_y);
  if (!rock.mesh && rock.element_size > largest) {
    document.fail("rock.element_size", fmt::format("is larger than the rock itself; at most {:g} m", largest));
  }
  check_triangles(document, rock, lattice.length_x * lattice.length_y);
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

void check_times(const TomlDocument& document, const Scene& scene) {
  const double step = scene.lattice.time_step;
  const double slack = 1e-9 * step;
  if (scene.time.end && *scene.time.end < step - slack) {
    document.fail("time.end", fmt::format("is shorter than one lattice.time_step = {:g} s", step));
  }
  if (scene.time.end && *scene.time.end / step > 1e15) {
    document.fail("time.end", fmt::format("is more than 1e15 steps of lattice.time_step = {:g} s", step));
  }
  const bool ages = scene.accuracy.dissolution_tolerance > 0;  // then steps say little of the time
  const double end = scene.time.end ? *scene.time.end
                     : ages         ? std::numeric_limits<double>::max()
                                    : static_cast<double>(*scene.time.steps) * step;
  const auto check_interval = [&](const char* key, const std::optional<double>& interval) {
    if (!interval) return;
    if (*interval < step - slack)
      document.fail(key, fmt::format("is shorter than one lattice.time_step = {:g} s", step));
    if (*interval > end + slack) document.fail(key, fmt::format("is longer than the whole run, {:g} s", end));
  };
  check_interval("output.interval", scene.output.interval);
  check_interval("output.history_interval", scene.output.history_interval);
  check_interval("output.checkpoint_interval", scene.output.checkpoint_interval);
  if (scene.output.interval_steps && static_cast<double>(*scene.output.interval_steps) * step > end + slack) {
    document.fail("output.interval_steps", fmt::format("is more than the whole run, {:.0f} steps", end / step));
  }
}

void check_triangles(const TomlDocument& document, const RockSection& rock, double area) {
  if (rock.mesh) return;
  const double triangles = triangles_in(area, rock.element_size);
  if (triangles > most_triangles)
    document.fail("rock.element_size",
                  fmt::format("m makes {:.3g} triangles, at most 2^22 are accepted; use {:.3g} m or more", triangles,
                              rock.element_size * std::sqrt(triangles / most_triangles)));
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
