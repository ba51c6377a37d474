// Remarks on what a case may say but probably does not mean.
#include "io/detail/case_checks.hpp"

#include <fmt/format.h>

namespace vug {
namespace {

void warn_about_reaction(Scene& scene) {
  const ReactionSection& reaction = *scene.reaction;
  if (reaction.activation_energy > 0 && reaction.reference_temperature < 250) {
    scene.warnings.push_back(
        fmt::format("reaction.reference_temperature = {:g} K is below 250 K; the published table prints 237.15 K where "
                    "273.15 K is likely "
                    "meant, which changes the rate 66 times",
                    reaction.reference_temperature));
  }
  if (reaction.rate_constant == 0) scene.warnings.emplace_back("reaction.rate_constant is 0: nothing reacts");
  if (scene.geometry.kind == GeometryKind::open) {
    scene.warnings.emplace_back(
        "[reaction] acts on walls of rock, and geometry.type = \"open\" has none but the sides");
  }
}

void warn_about_sides(Scene& scene) {
  const auto remark = [&](const char* pair, const BoundarySection& side) {
    if (side.flow.kind != FlowBoundaryKind::periodic) return;
    if (scene.heat && side.heat.kind != HeatBoundaryKind::periodic) {
      scene.warnings.push_back(fmt::format("the flow is periodic across {}, the heat is not", pair));
    }
    if (scene.solute && side.solute.kind != SoluteBoundaryKind::periodic) {
      scene.warnings.push_back(fmt::format("the flow is periodic across {}, the solutes are not", pair));
    }
    if (scene.mechanics)
      scene.warnings.push_back(fmt::format("the flow is periodic across {}, the rock never is", pair));
  };
  remark("left and right", scene.left);
  remark("bottom and top", scene.bottom);
}

}  // namespace

void collect_warnings(Scene& scene) {
  if (scene.reaction) warn_about_reaction(scene);
  warn_about_sides(scene);
  if (scene.rock && !scene.rock->mesh && scene.rock->element_size < 4 * scene.lattice.spacing) {
    scene.warnings.push_back(
        fmt::format("rock.element_size = {:g} m is below four cells: triangles too small for the lattice",
                    scene.rock->element_size));
  }
  if (scene.mechanics && scene.mechanics->force_unstable) {
    scene.warnings.emplace_back("mechanics.force_unstable accepts a time step that may diverge");
  }
}

}  // namespace vug
