// Remarks on what a case may say but probably does not mean.
#include "io/detail/case_checks.hpp"
#include "io/form.hpp"
#include "io/narrow_cracks.hpp"
#include "io/periodic.hpp"
#include "kernels/base/gas_constant.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

namespace vug {
namespace {

void warn_about_reaction(Scene& scene) {
  const ReactionSection& reaction = *scene.reaction;
  constexpr double likely = 273.15;  // K: the published 237.15 K with two digits exchanged
  if (reaction.activation_energy > 0 && reaction.reference_temperature < 250) {
    const double factor =
        std::exp(reaction.activation_energy / gas_constant * (1 / reaction.reference_temperature - 1 / likely));
    scene.warnings.push_back(
        fmt::format("reaction.reference_temperature = {:g} K is below 250 K; the published table prints 237.15 K where "
                    "{:g} K is likely meant, which makes the rate {:.3g} times as high",
                    reaction.reference_temperature, likely, factor));
  }
  const auto still = [](const RateLaw& rate) { return rate.rate_constant == 0; };
  bool nothing_reacts = still(reaction) && std::all_of(reaction.further.begin(), reaction.further.end(), still);
  for (const MineralSection& mineral : scene.minerals)
    nothing_reacts = nothing_reacts && std::all_of(mineral.rates.begin(), mineral.rates.end(), still);
  if (nothing_reacts) scene.warnings.emplace_back("reaction.rate_constant is 0: nothing reacts");
  if (scene.geometry.kind == GeometryKind::open) {
    scene.warnings.emplace_back(
        "[reaction] acts on walls of rock, and geometry.type = \"open\" has none but the sides");
  }
}

/// Whether the hole opens where the injection is.
bool meets(const InjectionSection& injection, const InjectionHole& hole, const Scene& scene) {
  const bool upright = injection.side == "left" || injection.side == "right";
  const double side_at = injection.side == "right" ? scene.lattice.length_x
                         : injection.side == "top" ? scene.lattice.length_y
                                                   : 0;
  const int across = upright ? 0 : 1, along = upright ? 1 : 0;
  const double cell = scene.lattice.spacing;
  const bool touches = std::min(std::abs(hole.from[across] - side_at), std::abs(hole.to[across] - side_at)) < cell;
  const auto [low, high] = std::minmax(hole.from[along], hole.to[along]);
  return touches && injection.centre + injection.width / 2 > low && injection.centre - injection.width / 2 < high;
}

void warn_about_injections(Scene& scene) {
  const InjectionHole& hole = *scene.rock->hole;
  const auto& all = scene.injections;
  if (std::any_of(all.begin(), all.end(), [&](const InjectionSection& own) { return meets(own, hole, scene); })) return;
  scene.warnings.push_back(fmt::format("{} on the {} side does not meet rock.hole", all[0].key, all[0].side));
}

/// What is drawn into the rock should be found on the lattice.
void warn_about_small_cavities(Scene& scene) {
  const double cell = scene.lattice.spacing;
  const RockSection& rock = *scene.rock;
  if (rock.hole &&
      std::min(std::abs(rock.hole->to[0] - rock.hole->from[0]), std::abs(rock.hole->to[1] - rock.hole->from[1])) < cell)
    scene.warnings.emplace_back("rock.hole is narrower than a cell: it may hold no node");
  std::map<int, double> length;  // of notches that may be rows of lines
  for (const Notch& notch : rock.notches)
    length[notch.entry] += std::hypot(notch.to[0] - notch.from[0], notch.to[1] - notch.from[1]);
  for (const auto& [entry, metres] : length)
    if (metres < cell) scene.warnings.push_back(fmt::format("rock.notches.{} is shorter than a cell", entry));
}

/// The keys by which broken bonds are wider than `width`.
std::string what_widens(double width, double least, double by_distance, bool metres) {
  std::string own = metres ? "damage.minimum_width" : "damage.minimum_aperture";
  if (width >= by_distance) return own;
  return width < least ? own + " and damage.pathway_factor" : "damage.pathway_factor";
}

/// A notch is of broken bonds, which [damage] widens to c_d times the distance of their centroids, or to a least width
/// of its own.
void warn_about_narrow_notches(Scene& scene) {
  const RockSection& rock = *scene.rock;
  const DamageSection& damage = *scene.damage;
  if (damage.aperture == ApertureLaw::opening) return;
  const bool metres = rock.pathway_width.has_value();
  const double cell = metres ? 1 : scene.lattice.spacing;  // in the unit of widths
  const double least = metres ? damage.minimum_width.value_or(*rock.pathway_width) : damage.minimum_aperture;
  const double by_distance = damage.pathway_factor * rock.element_size / std::sqrt(3.0) / cell;  // of the mean triangle
  std::map<int, double> narrow;  // width of notches that may be rows of lines
  for (const Notch& notch : rock.notches) {
    const double width = metres ? notch.width.value_or(*rock.pathway_width) : notch.aperture;
    if (width > 0 && width < std::max(least, by_distance)) narrow[notch.entry] = width;
  }
  for (const auto& [entry, width] : narrow)
    scene.warnings.push_back(
        fmt::format("rock.notches.{} is {:g} {} wide only until the first update, and about {:.3g} wide from then on, "
                    "like every broken bond: lower {} to keep it narrower",
                    entry, width, metres ? "m" : "cells", std::max(least, by_distance),
                    what_widens(width, least, by_distance, metres)));
}

/// Rock that nothing holds drifts away under the thrust of the injection.
void warn_about_support(Scene& scene) {
  for (const BoundarySection* side : {&scene.left, &scene.right, &scene.bottom, &scene.top}) {
    const auto holds = [](const TractionLoad& load) {
      return load.support != Support::free && load.support != Support::servo;
    };
    const std::vector<TractionPart>& parts = side->traction.parts;
    if (holds(side->traction.load)) return;
    if (std::any_of(parts.begin(), parts.end(), [&](const TractionPart& part) { return holds(part.load); })) return;
  }
  scene.warnings.emplace_back("no side supports the rock (boundary.<side>.traction.support): it is free to drift");
}

/// Whether fluid may leave the lattice there at some time. `inward`: of a side, the axis and direction into the
/// lattice.
bool may_leave(const FlowBoundary& flow, std::optional<std::pair<int, int>> inward) {
  if (flow.kind == FlowBoundaryKind::pressure || flow.kind == FlowBoundaryKind::outflow) return true;
  if (flow.kind != FlowBoundaryKind::velocity) return false;
  if (flow.flow_rate && flow.flow_rate->lowest() < 0) return true;
  if (flow.mass_flow_rate && flow.mass_flow_rate->lowest() < 0) return true;
  if (!inward) return flow.speed.lowest() < 0;
  const auto& [axis, sign] = *inward;
  return sign > 0 ? flow.velocity[axis].lowest() < 0 : flow.velocity[axis].highest() > 0;
}

/// Heat and solutes that nothing lets out with the fluid pile up at its outlet.
void warn_about_outlets(Scene& scene) {
  const auto look = [&](const std::string& key, const BoundarySection& at, std::optional<std::pair<int, int>> inward) {
    if (!scene.flow || !may_leave(at.flow, inward)) return;
    const auto remark = [&](const char* what, const char* given) {
      scene.warnings.push_back(
          fmt::format("{0} lets fluid out, but {1} is {2}: what the fluid carries there accumulates at the side; "
                      "give {1} = {{ type = \"outflow\" }} where fluid leaves, or the value of what enters",
                      key, what, given));
    };
    const HeatCondition heat = at.heat.kind;
    if (scene.heat && heat == HeatCondition::adiabatic) remark("heat", "adiabatic");
    if (scene.heat && heat == HeatCondition::flux) remark("heat", "a flux");
    if (scene.heat && heat == HeatCondition::convection) remark("heat", "convection");
    const SoluteBoundaryKind solute = at.solute.kind;
    if (scene.solute && solute == SoluteBoundaryKind::no_flux) remark("solute", "without flux");
    if (scene.solute && solute == SoluteBoundaryKind::flux) remark("solute", "a flux");
  };
  look("boundary.left", scene.left, std::pair{0, 1});
  look("boundary.right", scene.right, std::pair{0, -1});
  look("boundary.bottom", scene.bottom, std::pair{1, 1});
  look("boundary.top", scene.top, std::pair{1, -1});
  for (const InjectionSection& injection : scene.injections) {
    const bool upright = injection.side == "left" || injection.side == "right";
    const bool low = injection.side == "left" || injection.side == "bottom";
    look(injection.key, injection.conditions, std::pair{upright ? 0 : 1, low ? 1 : -1});
  }
  for (const OpeningSection& opening : scene.openings)
    look("boundary.shape." + scene.geometry.shapes[opening.shape].name, opening.conditions, std::nullopt);
}

void warn_about_sides(Scene& scene) {
  const auto remark = [&](const char* pair, const BoundarySection& side) {
    if (is_periodic(scene, side))
      scene.warnings.push_back(fmt::format("the lattice is periodic across {}, the rock never is", pair));
  };
  remark("left and right", scene.left);
  remark("bottom and top", scene.bottom);
}

/// A shape has no image beyond a joined side: what reaches over it is lost, unless the case draws it there as well.
void warn_about_cut_shapes(Scene& scene) {
  const auto& shapes = scene.geometry.shapes;
  const std::array<bool, 2> joined{is_periodic(scene, scene.left), is_periodic(scene, scene.bottom)};
  const std::array<double, 2> length{scene.lattice.length_x, scene.lattice.length_y};
  const double slack = scene.lattice.spacing / 2;
  const auto reach = [](const Form& form, int axis) {
    const Box box = box_of(form);
    return axis == 0 ? std::pair{box.x0, box.x1} : std::pair{box.y0, box.y1};
  };
  for (std::size_t i = 0; i < shapes.size(); ++i)
    for (int axis = 0; axis < 2; ++axis) {
      const auto [low, high] = reach(shapes[i].form, axis);
      const bool below = low + slack < 0;
      const bool above = high - slack > length[axis];
      if (!joined[axis] || below == above) continue;
      const double image = low + (below ? length[axis] : -length[axis]);
      if (std::any_of(shapes.begin(), shapes.end(),
                      [&](const Shape& other) { return std::abs(reach(other.form, axis).first - image) < slack; }))
        continue;
      scene.warnings.push_back(fmt::format(
          "geometry.shapes.{}{} reaches over the {} side, which is periodic, and is cut there: draw a second shape for "
          "what should appear on the other side",
          i, shapes[i].name.empty() ? "" : " (" + shapes[i].name + ")",
          axis == 0 ? (below ? "left" : "right") : (below ? "bottom" : "top")));
    }
}

/// What S does to pressures assumes that pathways are wider in metres the coarser the lattice.
void warn_about_scaled_pressure(Scene& scene) {
  if (!scene.flow || scene.flow->pressure_scale == 1 || !scene.rock) return;
  const char* given = scene.rock->pathway_width                                        ? "rock.pathway_width"
                      : scene.damage && scene.damage->aperture == ApertureLaw::opening ? "damage.aperture = \"opening\""
                                                                                       : nullptr;
  if (given)
    scene.warnings.push_back(
        fmt::format("flow.pressure_scale = {:g} compensates for pathways that are too wide on a coarse lattice, but {} "
                    "gives them their true width: the flow through them is {:g} times too small",
                    scene.flow->pressure_scale, given, scene.flow->pressure_scale));
}

/// A slit fills so slowly that its flow seems steady while it is not.
void warn_about_held_slits(Scene& scene) {
  if (scene.accuracy.flow_tolerance > 0 && has_cracks_below_a_cell(scene))
    scene.warnings.emplace_back(
        "accuracy.flow_tolerance: the flow is not held while there are cracks narrower than a cell: pressure enters "
        "them too slowly for the flow to be seen as steady");
}

/// Inertia strengthens rock as it breaks (docs/validation.md): in compression at 0.5 m/s by 2 % with four times the
/// mass.
void warn_about_mass_scaling(Scene& scene) {
  constexpr double notable = 4;
  const double scaling = scene.mechanics->parameters.mass_scaling;
  if (scaling <= notable || scene.mechanics->scaling_chosen) return;
  scene.warnings.push_back(
      fmt::format("mechanics.mass_scaling = {:g} slows waves down by a factor of {:.3g}, and the rock appears "
                  "stronger: in a compression test by 6 % at 16 and by 17 % at 100",
                  scaling, std::sqrt(scaling)));
}

/// With s times the mass a press acts as if it were sqrt(s) times as fast. Inertia adds to the mean strength in
/// compression 5 % at 1 m/s, in tension 3 % at 0.2 m/s, 7 at 0.4 and 17 at 1, in splitting nothing at 1 and 14 % at 5.
void warn_about_press(Scene& scene) {
  const LaboratoryTest test = scene.laboratory->test;
  if (test == LaboratoryTest::heating || test == LaboratoryTest::quench) return;  // a limit of the specimen
  const double notable = test == LaboratoryTest::tension ? 0.2 : 1;               // m/s
  const double scaling = scene.mechanics->parameters.mass_scaling, speed = platen_speed(*scene.laboratory);
  if (speed * std::sqrt(scaling) <= notable) return;
  scene.warnings.push_back(
      fmt::format("platens at {:g} m/s with mechanics.mass_scaling = {:g} act like {:.3g} m/s: above {:g} m/s "
                  "inertia adds to the strength, soon more than 5 %",
                  speed, scaling, speed * std::sqrt(scaling), notable));
}

}  // namespace

void collect_warnings(Scene& scene) {
  if (scene.laboratory) return warn_about_press(scene);
  if (scene.reaction) warn_about_reaction(scene);
  warn_about_outlets(scene);
  warn_about_cut_shapes(scene);
  warn_about_scaled_pressure(scene);
  if (scene.flow) warn_about_held_slits(scene);
  if (scene.rock && scene.rock->hole && !scene.injections.empty()) warn_about_injections(scene);
  if (scene.rock) warn_about_small_cavities(scene);
  if (scene.rock && scene.damage) warn_about_narrow_notches(scene);
  if (scene.mechanics) warn_about_support(scene);
  if (scene.mechanics) warn_about_sides(scene);
  if (scene.mechanics) warn_about_mass_scaling(scene);
  if (scene.mechanics && scene.mechanics->force_unstable) {
    scene.warnings.emplace_back("mechanics.force_unstable accepts a time step that may diverge");
  }
}

}  // namespace vug
