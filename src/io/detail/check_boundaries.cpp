// Conditions on the sides of the lattice against the modules they need and against each other.
#include "io/detail/case_checks.hpp"
#include "io/detail/nearest_name.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace vug {
namespace {

struct NamedBoundary {
  const char* name;
  const BoundarySection& section;
};

std::array<NamedBoundary, 4> sides(const Scene& scene) {
  return {{{"left", scene.left}, {"right", scene.right}, {"bottom", scene.bottom}, {"top", scene.top}}};
}

/// A condition may only be written where its module is there.
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
  for (const auto& [species, value] : boundary.concentration) {
    if (std::find(known.begin(), known.end(), species) != known.end()) continue;
    document.fail(fmt::format("boundary.{}.solute.concentration.{}", name, species),
                  fmt::format("is for \"{}\", which is not the name of a [[solute.species]]{}", species,
                              suggestion(species, known)));
  }
}

/// Opposite sides are periodic together or not at all.
template <class Kind>
void check_pair(const TomlDocument& document, const char* physics, const NamedBoundary& a, Kind kind_a,
                const NamedBoundary& b, Kind kind_b) {
  if ((kind_a == Kind::periodic) == (kind_b == Kind::periodic)) return;
  const char* periodic = kind_a == Kind::periodic ? a.name : b.name;
  const char* other = kind_a == Kind::periodic ? b.name : a.name;
  document.fail(fmt::format("boundary.{}.{}.type", periodic, physics),
                fmt::format("needs boundary.{}.{}.type = \"periodic\" as well", other, physics));
}

void check_periodic(const TomlDocument& document, const NamedBoundary& a, const NamedBoundary& b) {
  check_pair(document, "flow", a, a.section.flow.kind, b, b.section.flow.kind);
  check_pair(document, "heat", a, a.section.heat.kind, b, b.section.heat.kind);
  check_pair(document, "solute", a, a.section.solute.kind, b, b.section.solute.kind);
}

void check_injection(const TomlDocument& document, const Scene& scene) {
  const InjectionSection& injection = *scene.injection;
  const bool upright = injection.side == "left" || injection.side == "right";
  const double side = upright ? scene.lattice.length_y : scene.lattice.length_x;
  const double slack = 1e-6 * scene.lattice.spacing;
  if (injection.width > side + slack) {
    document.fail("boundary.injection.width", fmt::format("m is wider than the {} side, {:g} m", injection.side, side));
  }
  if (injection.width < scene.lattice.spacing - slack) {
    document.fail("boundary.injection.width",
                  fmt::format("m is narrower than one cell, lattice.spacing = {:g} m", scene.lattice.spacing));
  }
  if (injection.centre - injection.width / 2 < -slack || injection.centre + injection.width / 2 > side + slack) {
    document.fail("boundary.injection.centre",
                  fmt::format("m with width = {:g} m reaches beyond the {} side, 0 ... {:g} m", injection.width,
                              injection.side, side));
  }
  for (const auto& [name, section] : sides(scene)) {
    if (injection.side != name) continue;
    const bool periodic = section.flow.kind == FlowBoundaryKind::periodic ||
                          section.heat.kind == HeatBoundaryKind::periodic ||
                          section.solute.kind == SoluteBoundaryKind::periodic;
    if (periodic)
      document.fail("boundary.injection.side", "is periodic; a stretch of it cannot have conditions of its own");
  }
  const BoundarySection& own = injection.conditions;
  const auto refuse = [&](const char* physics, bool periodic) {
    if (periodic)
      document.fail(fmt::format("boundary.injection.{}.type", physics),
                    "is a condition of a whole side, not of a stretch");
  };
  refuse("flow", own.flow.kind == FlowBoundaryKind::periodic);
  refuse("heat", own.heat.kind == HeatBoundaryKind::periodic);
  refuse("solute", own.solute.kind == SoluteBoundaryKind::periodic);
}

/// A wall only moves along itself.
void check_wall(const TomlDocument& document, const NamedBoundary& side) {
  const FlowBoundary& flow = side.section.flow;
  const std::string_view name = side.name;
  const int normal = name == "left" || name == "right" ? 0 : 1;
  if (flow.kind == FlowBoundaryKind::wall && flow.velocity[normal] != 0) {
    document.fail(
        fmt::format("boundary.{}.flow.velocity", name),
        fmt::format("moves a wall through itself; its {} component must be 0", normal == 0 ? "first" : "second"));
  }
}

}  // namespace

void check_boundaries(const TomlDocument& document, const Scene& scene) {
  for (const NamedBoundary& side : sides(scene)) {
    check_modules_of(document, scene, side.name);
    check_concentrations(document, scene, side.name, side.section.solute);
    check_wall(document, side);
  }
  check_periodic(document, {"left", scene.left}, {"right", scene.right});
  check_periodic(document, {"bottom", scene.bottom}, {"top", scene.top});
  if (!scene.injection) return;
  check_modules_of(document, scene, "injection");
  check_concentrations(document, scene, "injection", scene.injection->conditions.solute);
  check_injection(document, scene);
}

}  // namespace vug
