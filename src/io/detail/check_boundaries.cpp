// Checks of the conditions at the sides of the lattice: against the modules that they need and against each other.
#include "io/detail/case_checks.hpp"
#include "io/detail/nearest_name.hpp"
#include "io/message.hpp"
#include "io/periodic.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

namespace vug {
namespace {

/// A condition needs the table of its module.
void check_modules_of(const TomlDocument& document, const Scene& scene, const std::string& name) {
  const auto refuse = [&](const char* physics, bool modelled, const char* needed) {
    const std::string key = fmt::format("boundary.{}.{}", name, physics);
    if (!modelled && document.find(key) != nullptr)
      document.fail_at(key, fmt::format("{} needs the table {}", key, needed));
  };
  refuse("flow", scene.flow.has_value(), "[flow]");
  refuse("heat", scene.heat.has_value(), "[heat]");
  refuse("solute", scene.solute.has_value(), "[solute]");
  refuse("traction", scene.mechanics.has_value(), "[mechanics]");
}

void check_concentrations(const TomlDocument& document, const Scene& scene, const std::string& name,
                          const SoluteBoundary& boundary) {
  std::vector<std::string> known;
  if (scene.solute) {
    for (const Species& species : scene.solute->species) known.push_back(species.name);
  }
  for (const auto& [key, values] :
       {std::pair{"concentration", &boundary.concentration}, std::pair{"flux", &boundary.flux}})
    for (const auto& [species, value] : *values) {
      if (std::find(known.begin(), known.end(), species) != known.end()) continue;
      document.fail(fmt::format("boundary.{}.solute.{}.{}", name, key, species),
                    fmt::format("is for \"{}\", which is not the name of a [[solute.species]]{}", excerpt(species),
                                suggestion(species, known)));
    }
}

/// Opposite sides must both be periodic, or neither.
template <class Kind>
void check_pair(const TomlDocument& document, const char* physics, const char* name_a, Kind a, const char* name_b,
                Kind b) {
  if ((a == Kind::periodic) == (b == Kind::periodic)) return;
  const char* periodic = a == Kind::periodic ? name_a : name_b;
  const char* other = a == Kind::periodic ? name_b : name_a;
  document.fail(fmt::format("boundary.{}.{}.type", periodic, physics),
                fmt::format("needs boundary.{}.{}.type = \"periodic\" as well", other, physics));
}

/// Periodicity is a property of the lattice: where one physics is periodic, those without a condition become so as
/// well, and those with another condition are refused.
template <class Kind>
void join(const TomlDocument& document, const char* physics, const char* side, Kind& kind) {
  const std::string key = fmt::format("boundary.{}.{}.type", side, physics);
  if (kind != Kind::periodic && document.find(key) != nullptr) {
    document.fail(key,
                  "is not periodic, but another condition of this side is: a side is periodic for all physics or none");
  }
  kind = Kind::periodic;
}

void check_periodic(const TomlDocument& document, const Scene& scene, const char* name_a, BoundarySection& a,
                    const char* name_b, BoundarySection& b) {
  check_pair(document, "flow", name_a, a.flow.kind, name_b, b.flow.kind);
  check_pair(document, "heat", name_a, a.heat.kind, name_b, b.heat.kind);
  check_pair(document, "solute", name_a, a.solute.kind, name_b, b.solute.kind);
  if (!is_periodic(scene, a)) return;
  for (auto [name, side] : {std::pair{name_a, &a}, std::pair{name_b, &b}}) {
    if (scene.flow) join(document, "flow", name, side->flow.kind);
    if (scene.heat) join(document, "heat", name, side->heat.kind);
    if (scene.solute) join(document, "solute", name, side->solute.kind);
  }
}

/// Mean share over a stretch of `length` (m): shares are linear between their positions and constant beyond them.
double mean_of(const std::vector<std::array<double, 2>>& shares, double length) {
  double before = 0, share = shares.front()[1], sum = 0;
  for (const auto& [position, next] : shares) {
    const double at = std::clamp(position, 0.0, length);
    sum += (share + next) / 2 * (at - before);
    before = at;
    share = next;
  }
  return (sum + share * (length - before)) / length;
}

/// Positions of a profile must lie on its stretch. The shares by which a rate is distributed must have a positive mean.
void check_profile(const TomlDocument& document, const std::string& key, const FlowBoundary& flow, double length,
                   double spacing) {
  const double slack = 1e-6 * spacing;
  for (const auto& [at, share] : flow.profile_table)
    if (at < -slack || at > length + slack)
      document.fail(key + ".flow.profile_table",
                    fmt::format("has the position {:g} m beyond its stretch, 0 ... {:g} m", at, length));
  if (!flow.has_rate() || flow.profile_table.empty()) return;
  const double mean = mean_of(flow.profile_table, length);
  double largest = 0;
  for (const auto& [at, share] : flow.profile_table) largest = std::max(largest, std::abs(share));
  constexpr double rounding = 1e-9;
  if (mean <= rounding * largest)
    document.fail(key + ".flow.profile_table",
                  fmt::format("has shares of the mean {:.3g}, and a rate is spread by the ratio of share to mean: it "
                              "must be positive; the rate's sign says whether fluid enters",
                              mean));
}

void check_injection(const TomlDocument& document, const Scene& scene, const InjectionSection& injection) {
  const double side = scene.lattice.length_of(injection.side);
  const char* const name = name_of(injection.side);
  const double slack = 1e-6 * scene.lattice.spacing;
  if (injection.width > side + slack) {
    document.fail(injection.key + ".width", fmt::format("m is wider than the {} side, {:g} m", name, side));
  }
  if (injection.width < scene.lattice.spacing - slack) {
    document.fail(injection.key + ".width",
                  fmt::format("m is narrower than one cell, lattice.spacing = {:g} m", scene.lattice.spacing));
  }
  if (injection.centre - injection.width / 2 < -slack || injection.centre + injection.width / 2 > side + slack) {
    document.fail(
        injection.key + ".centre",
        fmt::format("m with width = {:g} m reaches beyond the {} side, 0 ... {:g} m", injection.width, name, side));
  }
  if (is_periodic(scene, scene.side(injection.side)))
    document.fail(injection.key + ".side", "is periodic; a stretch of it cannot have conditions of its own");
}

/// Two injections must not share a cell.
void check_apart(const TomlDocument& document, const Scene& scene) {
  const double slack = 1e-6 * scene.lattice.spacing;
  for (const InjectionSection& a : scene.injections)
    for (const InjectionSection& b : scene.injections) {
      if (&b >= &a || a.side != b.side) continue;
      if (std::abs(a.centre - b.centre) < (a.width + b.width) / 2 - slack)
        document.fail(a.key + ".centre", fmt::format("lies within the stretch of {}", b.key));
    }
}

/// Only a whole side can be periodic: parts of sides and shapes have no opposite.
void check_not_periodic(const TomlDocument& document, const std::string& name, const BoundarySection& own) {
  const auto refuse = [&](const char* physics, bool periodic) {
    if (periodic) document.fail(fmt::format("boundary.{}.{}.type", name, physics), "is a condition of a whole side");
  };
  refuse("flow", own.flow.kind == FlowBoundaryKind::periodic);
  refuse("heat", own.heat.kind == HeatCondition::periodic);
  refuse("solute", own.solute.kind == SoluteBoundaryKind::periodic);
}

/// Every shape with a name must have its table, and every such table its shape.
void check_openings(const TomlDocument& document, const Scene& scene) {
  std::vector<std::string> names;
  for (const OpeningSection& opening : scene.openings) {
    const std::string& name = scene.geometry.shapes[opening.shape].name;
    const std::string table = "shape." + name;
    names.push_back(name);
    if (document.find("boundary." + table) == nullptr)
      document.fail(fmt::format("geometry.shapes.{}.name", opening.shape),
                    fmt::format("needs the table [boundary.{}]; it may be empty", table));
    check_modules_of(document, scene, table);
    check_concentrations(document, scene, table, opening.conditions.solute);
    check_not_periodic(document, table, opening.conditions);
  }
  const toml::node* tables = document.find("boundary.shape");
  if (tables == nullptr) return;
  for (const auto& [key, value] : *tables->as_table()) {
    const std::string name(key.str());
    if (std::find(names.begin(), names.end(), name) != names.end()) continue;
    document.fail_at("boundary.shape." + name,
                     fmt::format("[boundary.shape.{}] is for no shape of that name among [[geometry.shapes]]{}",
                                 excerpt(name), names.empty() ? "" : suggestion(name, names)));
  }
}

/// A wall may only move along itself.
void check_wall(const TomlDocument& document, const std::string& key, Side side, const FlowBoundary& flow) {
  const int normal = is_upright(side) ? 0 : 1;
  if (flow.kind == FlowBoundaryKind::wall && flow.velocity[normal].peak() != 0) {
    document.fail(key + ".flow.velocity", fmt::format("moves a wall through itself; its {} component must be 0",
                                                      normal == 0 ? "first" : "second"));
  }
}

}  // namespace

void check_boundaries(const TomlDocument& document, Scene& scene) {
  for (const Side side : all_sides) {
    const std::string name = name_of(side);
    const BoundarySection& own = scene.side(side);
    check_modules_of(document, scene, name);
    check_concentrations(document, scene, name, own.solute);
    check_wall(document, "boundary." + name, side, own.flow);
    check_profile(document, "boundary." + name, own.flow, scene.lattice.length_of(side), scene.lattice.spacing);
  }
  check_periodic(document, scene, "left", scene.left, "right", scene.right);
  check_periodic(document, scene, "bottom", scene.bottom, "top", scene.top);
  check_openings(document, scene);
  for (const InjectionSection& injection : scene.injections) {
    const std::string name = injection.key.substr(std::string_view("boundary.").size());
    check_modules_of(document, scene, name);
    check_concentrations(document, scene, name, injection.conditions.solute);
    check_injection(document, scene, injection);
    check_wall(document, injection.key, injection.side, injection.conditions.flow);
    check_profile(document, injection.key, injection.conditions.flow, injection.width, scene.lattice.spacing);
    check_not_periodic(document, name, injection.conditions);
  }
  check_apart(document, scene);
}

}  // namespace vug
