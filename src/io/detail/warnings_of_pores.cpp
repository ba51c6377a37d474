// Warnings about fluid, heat, solutes and their reaction: what a case may say but probably does not mean.
#include "io/detail/case_checks.hpp"
#include "io/form.hpp"
#include "io/narrow_cracks.hpp"
#include "io/periodic.hpp"
#include "io/units.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace vug {
namespace {

void warn_about_reaction(Scene& scene) {
  const ReactionSection& reaction = *scene.reaction;
  constexpr double likely = 273.15;  // K; the published 237.15 K probably has two digits exchanged
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

/// Where rock ages faster than the fluid, times are those of the rock, and what it does not depend on lags behind.
void warn_about_ageing(Scene& scene) {
  const std::vector<std::string> passive = passive_species(scene);
  if (scene.accuracy.dissolution_tolerance == 0 || passive.empty()) return;
  scene.warnings.push_back(
      fmt::format("accuracy.dissolution_tolerance: the rock may age faster than the fluid, and nothing that dissolves "
                  "depends on {}, which changes in the time of the fluid: what the output says of {} may be late",
                  fmt::join(passive, ", "), passive.size() > 1 ? "them" : "it"));
}

/// The fluid of heat.fluid_density, which has a default of its own, is that of flow.density.
void warn_about_two_densities(Scene& scene) {
  const double carried = scene.heat->fluid_density, flowing = scene.flow->density;
  if (std::abs(carried - flowing) > 0.05 * flowing)
    scene.warnings.push_back(fmt::format(
        "heat.fluid_density = {:g} kg/m3 and flow.density = {:g} kg/m3 are of the same fluid: what it stores "
        "and carries of heat follows from the former",
        carried, flowing));
}

/// Whether fluid may leave the lattice at a side or, without one, an opening at some time.
bool may_leave(const FlowBoundary& flow, std::optional<Side> side) {
  return flow.kind == FlowBoundaryKind::pressure || flow.kind == FlowBoundaryKind::outflow || draws(flow, side);
}

/// Heat and solutes accumulate at an outlet of the fluid where their own conditions do not let them out.
void warn_about_outlets(Scene& scene) {
  const auto look = [&](const std::string& key, const BoundarySection& at, std::optional<Side> side) {
    if (!scene.flow || !may_leave(at.flow, side)) return;
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
  for (const Side side : all_sides) look(fmt::format("boundary.{}", name_of(side)), scene.side(side), side);
  for (const InjectionSection& injection : scene.injections) look(injection.key, injection.conditions, injection.side);
  for (const OpeningSection& opening : scene.openings)
    look("boundary.shape." + scene.geometry.shapes[opening.shape].name, opening.conditions, std::nullopt);
}

/// The part of a shape that extends beyond a joined side is lost: it does not appear at the opposite side unless the
/// case draws it there as well.
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

/// The pressure scale S assumes that pathways are wider, in metres, on coarser lattices.
void warn_about_scaled_pressure(Scene& scene) {
  if (!scene.flow || scene.flow->pressure_scale == 1) return;
  if (!scene.rock) {
    scene.warnings.push_back(fmt::format(
        "flow.pressure_scale = {0:g} is for the pathways of [rock], which are a number of cells wide; here all "
        "is as wide as it is drawn, and pressures, body forces and buoyancy drive {0:g} times too little flow",
        scene.flow->pressure_scale));
    return;
  }
  if (const char* given = key_of_true_widths(scene))
    scene.warnings.push_back(
        fmt::format("flow.pressure_scale = {:g} compensates for pathways that are too wide on a coarse lattice, but {} "
                    "gives them their true width: the flow through them is {:g} times too small",
                    scene.flow->pressure_scale, given, scene.flow->pressure_scale));
}

/// Whether a boundary has a column of what enters through it.
bool has_flow_column(const Scene& scene, const BoundarySection& at) {
  return (scene.flow && is_open(at.flow)) || (scene.heat && at.heat.kind != HeatCondition::adiabatic) ||
         (scene.solute && at.solute.kind != SoluteBoundaryKind::no_flux);
}

/// The force and the flow of a surface have a column only where it is no periodic side, and is open for something.
void warn_about_missing_columns(Scene& scene) {
  const OutputSection& output = scene.output;
  bool force = false, flow = false;
  const auto look = [&](const BoundarySection& at) {
    force = force || scene.flow.has_value();
    flow = flow || has_flow_column(scene, at);
  };
  for (const Side side : all_sides)
    if (!is_periodic(scene, scene.side(side))) look(scene.side(side));
  for (const InjectionSection& injection : scene.injections) look(injection.conditions);
  for (const OpeningSection& opening : scene.openings) look(opening.conditions);
  if (output.forces && !force)
    scene.warnings.emplace_back(
        "output.forces = true adds no column: forces are those on sides that are not periodic and on named shapes; the "
        "grains of a picture have none");
  if (output.flows && !flow)
    scene.warnings.emplace_back(
        "output.flows = true adds no column: nothing enters through a side or a named shape; the mean velocity of the "
        "fluid is in mean_velocity_x and mean_velocity_y");
}

/// A narrow crack fills so slowly that its flow seems steady while it is not.
void warn_about_held_slits(Scene& scene) {
  if (scene.accuracy.flow_tolerance > 0 && has_cracks_below_a_cell(scene))
    scene.warnings.emplace_back(
        "accuracy.flow_tolerance: the flow is not held while there are cracks narrower than a cell: pressure enters "
        "them too slowly for the flow to be seen as steady");
}

}  // namespace

void warn_about_pores(Scene& scene) {
  if (scene.reaction) warn_about_reaction(scene);
  if (scene.reaction) warn_about_circles(scene);
  warn_about_ageing(scene);
  if (scene.heat && scene.flow) warn_about_two_densities(scene);
  warn_about_outlets(scene);
  warn_about_cut_shapes(scene);
  warn_about_scaled_pressure(scene);
  warn_about_missing_columns(scene);
  if (scene.flow) warn_about_held_slits(scene);
}

}  // namespace vug
