#include "coupling/flow_paths.hpp"

#include "base/require.hpp"
#include "coupling/body_forces.hpp"
#include "coupling/corner_contacts.hpp"
#include "coupling/force_speed.hpp"
#include "coupling/given_passages.hpp"
#include "coupling/mouths.hpp"
#include "coupling/narrow_passages.hpp"
#include "coupling/pore_runs.hpp"
#include "coupling/pore_width.hpp"
#include "coupling/pressed_speed.hpp"
#include "coupling/ways_out.hpp"
#include "coupling/weight_wave.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <utility>

namespace vug {

namespace {

/// Throws InputError where a given velocity is above speed_bound.
void look_for_speeds(const Scene& scene, const std::vector<Mouth>& mouths) {
  for (const Mouth& mouth : mouths) {
    const FlowBoundary& flow = mouth.conditions->flow;
    if (mouth.peak_speed <= speed_bound) continue;
    const char* const key = flow.flow_rate             ? "flow_rate"
                            : flow.mass_flow_rate      ? "mass_flow_rate"
                            : flow.speed.peak() != 0.0 ? "speed"
                                                       : "velocity";
    if (std::isinf(mouth.peak_speed))
      throw InputError(
          fmt::format("{}: the shares of {}.flow.profile_table beside fluid have no positive sum, and {} is spread by "
                      "them",
                      scene.path, mouth.key, key));
    throw InputError(
        fmt::format("{}: {}.flow.{} is {:.3g} cells in a time step, and above {:g} no run is stable; lower it "
                    "or lattice.time_step",
                    scene.path, mouth.key, key, mouth.peak_speed, speed_bound));
  }
}

/// Reports conditions whose stretches touch no fluid at all: a warning for a side; an error for an injection or a
/// shape, which have no other purpose, unless rock may open later.
void look_for_dry_mouths(const Scene& scene, const std::vector<Mouth>& mouths, bool rock_opens, FlowPaths& found) {
  for (const Mouth& mouth : mouths) {
    const bool flows = scene.flow && mouth.lets_fluid_through(), carries = scene.solute && mouth.lets_solute_through();
    const bool dry = std::all_of(mouths.begin(), mouths.end(),
                                 [&](const Mouth& other) { return other.key != mouth.key || other.nodes.empty(); });
    if ((!flows && !carries) || !dry) continue;
    const std::string line = fmt::format("{}.{} has no effect{}: no fluid touches it", mouth.key,
                                         flows ? "flow" : "solute", rock_opens ? " until rock opens" : "");
    const bool on_purpose = mouth.key.starts_with("boundary.injection") || mouth.key.starts_with("boundary.shape.");
    if (on_purpose && !rock_opens) throw InputError(fmt::format("{}: {}", scene.path, line));
    if (std::find(found.warnings.begin(), found.warnings.end(), line) == found.warnings.end())
      found.warnings.push_back(line);
  }
}

/// Warns where no path of fluid leads from the mouth with the highest pressure to another mouth.
void look_for_paths(const std::vector<Mouth>& mouths, const std::vector<int>& piece, bool rock_opens,
                    FlowPaths& found) {
  const Mouth* inlet = nullptr;
  for (const Mouth& mouth : mouths)
    if (!mouth.nodes.empty() && mouth.conditions->flow.kind == FlowBoundaryKind::pressure &&
        (!inlet || mouth.conditions->flow.pressure.peak() > inlet->conditions->flow.pressure.peak()))
      inlet = &mouth;
  if (!inlet) return;
  std::set<int> own;
  for (const Mouth& mouth : mouths)
    if (mouth.key == inlet->key)
      for (const std::size_t n : mouth.nodes) own.insert(piece[n]);
  bool others = false;
  for (const Mouth& mouth : mouths) {
    if (mouth.key == inlet->key || !mouth.lets_fluid_through() || mouth.nodes.empty()) continue;
    others = true;
    if (std::any_of(mouth.nodes.begin(), mouth.nodes.end(), [&](std::size_t n) { return own.count(piece[n]) > 0; }))
      return;
  }
  if (others)
    found.warnings.push_back(
        fmt::format("no path of fluid leads from {} to another open side or shape: nothing flows{}", inlet->key,
                    rock_opens ? " until rock opens" : ""));
}

/// Warns where a force drives the fluid towards joined sides and no pore leads through them back to where it began.
void look_for_ways_around(const Scene& scene, const FluidPicture& picture, bool rock_opens, FlowPaths& found) {
  std::optional<JoinedPores> joined;
  for (const int axis : {0, 1}) {
    if (scene.flow->body_force[axis] == 0 || !picture.joined(axis)) continue;
    if (!joined) joined = joined_pores(picture);
    if ((axis == 0 ? joined->along_x : joined->along_y) == 0)
      found.warnings.push_back(
          fmt::format("flow.body_force: no path of fluid leads around from {} through the joined sides: it "
                      "drives nothing around that way{}",
                      axis == 0 ? "left to right" : "bottom to top", rock_opens ? " until rock opens" : ""));
  }
}

/// Warns where a parabolic profile, which spans its whole side or injection, also covers rock.
void look_for_cut_profiles(const Scene& scene, const Geometry& geometry, const std::vector<Mouth>& mouths,
                           FlowPaths& found) {
  const std::vector<Stretch> stretches = boundary_stretches(scene, geometry);
  for (std::size_t m = 0; m < mouths.size(); ++m) {
    const Stretch& stretch = stretches[m];
    const std::size_t cells = stretch.last + 1 - stretch.first, wet = mouths[m].nodes.size();
    const FlowBoundary& flow = stretch.conditions.flow;
    if (stretch.opening || flow.kind != FlowBoundaryKind::velocity || flow.profile != VelocityShape::parabolic)
      continue;
    if (wet == 0 || wet == cells) continue;
    found.warnings.push_back(fmt::format(
        "{}.flow.profile: the parabola spans all {} nodes there, {} of which are rock, so that it is not 0 beside the "
        "rock and a given velocity is not the mean of the fluid; give a [boundary.injection] as wide as the fluid",
        mouths[m].key, cells, cells - wet));
  }
}

/// Warns where a pressure that changes drives fluid to an outflow, which answers to the change of its speed
/// (docs/model.md, "Outflow").
void look_for_changing_pressures(const Scene& scene, const std::vector<Mouth>& mouths, FlowPaths& found) {
  const auto first = [&](const auto& wanted) {
    return std::find_if(mouths.begin(), mouths.end(),
                        [&](const Mouth& mouth) { return !mouth.nodes.empty() && wanted(mouth.conditions->flow); });
  };
  const auto out = first([](const FlowBoundary& flow) { return flow.kind == FlowBoundaryKind::outflow; });
  const auto driven = first([](const FlowBoundary& flow) {
    return flow.kind == FlowBoundaryKind::pressure && (flow.ramp_time > 0 || !flow.pressure.constant());
  });
  if (out == mouths.end() || driven == mouths.end()) return;
  found.warnings.push_back(fmt::format(
      "{}.flow changes its pressure, and {}.flow is an outflow: it holds back changes of the flow as {} more "
      "cells of fluid along the flow would; give it type = \"pressure\" where changes matter",
      driven->key, out->key, 4 * std::max(scene.lattice.nx, scene.lattice.ny)));
}

/// Warns where a temperature given for the fluid that enters is that of rock beside it as well.
void look_for_rock_at_given_temperature(const Scene& scene, const Geometry& geometry, const std::vector<Mouth>& mouths,
                                        FlowPaths& found) {
  if (!scene.heat) return;
  constexpr double notable = 0.1;  // share of rock
  const std::vector<Stretch> stretches = boundary_stretches(scene, geometry);
  for (std::size_t m = 0; m < mouths.size(); ++m) {
    const Stretch& stretch = stretches[m];
    const FlowBoundaryKind flow = stretch.conditions.flow.kind;
    const std::size_t cells = stretch.last + 1 - stretch.first, wet = mouths[m].nodes.size();
    if (stretch.opening || stretch.conditions.heat.kind != HeatCondition::temperature || wet == 0 ||
        (flow != FlowBoundaryKind::velocity && flow != FlowBoundaryKind::pressure) ||
        static_cast<double>(cells - wet) <= notable * static_cast<double>(cells))
      continue;
    found.warnings.push_back(fmt::format(
        "{}.heat: {} of the {} nodes there are rock, which is kept at the given temperature as well as the fluid that "
        "enters; if only the fluid is meant, give a [boundary.injection] as wide as the fluid, or let some cells of "
        "fluid lie in front of the rock",
        mouths[m].key, cells - wet, cells));
  }
}

}  // namespace

FlowPaths find_flow_paths(const Scene& scene, const Geometry& geometry, const LatticeUnits& units) {
  FlowPaths found;
  if (!scene.flow && !scene.solute) return found;
  const FluidPicture picture(scene, geometry);
  if (picture.fluid_nodes() == 0)
    throw InputError(fmt::format(
        "{}: the geometry has no fluid node, and {} is only in fluid{}", scene.path, scene.flow ? "[flow]" : "[solute]",
        scene.rock && scene.rock->porosity > 0
            ? fmt::format(": rock.porosity = {:g} is less than one pathway", scene.rock->porosity)
            : ""));
  const bool rock_opens = scene.damage || rock_dissolves(scene);
  const std::vector<Mouth> mouths = mouths_of(scene, geometry, units, picture);
  if (scene.flow) look_for_speeds(scene, mouths);
  look_for_dry_mouths(scene, mouths, rock_opens, found);
  if (std::string remark = remark_on_corners(scene, picture, mouths); !remark.empty())
    found.warnings.push_back(std::move(remark));
  if (!scene.flow) return found;
  look_for_ways_around(scene, picture, rock_opens, found);
  const std::vector<int> piece = pieces_of(picture);
  look_for_ways_out(scene, mouths, piece, units, rock_opens, found);
  look_for_paths(mouths, piece, rock_opens, found);
  const NoSlipWalls walls(picture, scene);
  look_for_passages(scene, walls, picture, mouths, piece, units, found);
  look_for_cut_profiles(scene, geometry, mouths, found);
  look_for_changing_pressures(scene, mouths, found);
  look_for_rock_at_given_temperature(scene, geometry, mouths, found);
  found.pressed = pressed_flow(scene, picture, mouths, pore_widths(picture, walls), units);
  if (const BodyForces forces = body_forces(scene, units); forces.act()) {
    const std::vector<double> width = shorter_widths(scene, picture);
    const ForceSpeed driven = body_force_speed(scene, forces, picture, width, mouths, piece, units);
    found.force_speed = driven.by_the_end;
    found.lasting_force_speed = driven.ever;
    found.weight_speed = weight_wave_speed(scene, forces, picture, width, mouths, piece, units);
  }
  for (std::string& remark : remarks_on_narrow_passages(scene, picture, units))
    found.warnings.push_back(std::move(remark));
  return found;
}

}  // namespace vug
