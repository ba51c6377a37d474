// Warnings about the rock: what a case may say but probably does not mean. Those about the contents of the pores are in
// warnings_of_pores.cpp.
#include "io/detail/case_checks.hpp"
#include "io/detail/platen_motion.hpp"
#include "io/notch_remarks.hpp"
#include "io/periodic.hpp"
#include "io/rock_inertia.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace vug {
namespace {

/// Whether the hole opens where the injection is.
bool meets(const InjectionSection& injection, const InjectionHole& hole, const Scene& scene) {
  const bool upright = is_upright(injection.side);
  const double side_at = injection.side == Side::right ? scene.lattice.length_x
                         : injection.side == Side::top ? scene.lattice.length_y
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
  scene.warnings.push_back(fmt::format("{} on the {} side does not meet rock.hole", all[0].key, name_of(all[0].side)));
}

/// A hole or notch smaller than a cell may have no node.
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

/// Rock without a support drifts away under the thrust of the injection.
void warn_about_support(Scene& scene) {
  if (is_supported(scene)) return;
  scene.warnings.emplace_back("no side supports the rock (boundary.<side>.traction.support): it is free to drift");
}

void warn_about_sides(Scene& scene) {
  const auto remark = [&](const char* pair, const BoundarySection& side) {
    if (is_periodic(scene, side))
      scene.warnings.push_back(fmt::format("the lattice is periodic across {}, the rock never is", pair));
  };
  remark("left and right", scene.left);
  remark("bottom and top", scene.bottom);
}

/// Inertia strengthens rock as it breaks (docs/validation.md): in compression at 0.5 m/s by 2 % with four times the
/// mass.
void warn_about_mass_scaling(Scene& scene) {
  constexpr double notable = 4;
  const double scaling = scene.mechanics->parameters.mass_scaling;
  if (scaling <= notable || scene.mechanics->scaling_chosen) return;
  // dashpots of bonds take less from slower waves
  const char* undamped =
      scene.mechanics->parameters.local_damping > 0
          ? ""
          : "; with mechanics.local_damping = 0 these waves hardly decay and break bonds: give 0.3 or "
            "more where loads change slowly";
  scene.warnings.push_back(
      fmt::format("mechanics.mass_scaling = {:g} slows waves down by a factor of {:.3g}, and the rock appears "
                  "stronger: in a compression test by 6 % at 16 and by 17 % at 100{}",
                  scaling, std::sqrt(scaling), undamped));
}

/// With s times the mass a press acts as if it were sqrt(s) times as fast. Inertia increases the mean strength: in
/// compression by 5 % at 1 m/s; in tension by 3 % at 0.2 m/s, 7 % at 0.4 m/s and 17 % at 1 m/s; in splitting by nothing
/// at 1 m/s and 14 % at 5 m/s. These are two (splitting: ten) times the default speeds. Rock that is weak for its
/// stiffness has lower ones: strengths of bonds of 10 and 2.6 MPa with 48 GPa are 13, 15 and 8 % higher at 0.5, 0.1 and
/// 0.1 m/s than at the default speed.
void warn_about_press(Scene& scene) {
  const LaboratoryTest test = scene.laboratory->test;
  if (test == LaboratoryTest::heating || test == LaboratoryTest::quench) return;  // the limit depends on the specimen
  const MechanicsParameters& rock = scene.mechanics->parameters;
  const double notable = (test == LaboratoryTest::brazilian ? 10 : 2) * usual_platen_speed(test, rock);  // m/s
  const double scaling = rock.mass_scaling, speed = platen_speed(*scene.laboratory, rock);
  if (speed * std::sqrt(scaling) <= notable) return;
  scene.warnings.push_back(
      fmt::format("platens at {:g} m/s with mechanics.mass_scaling = {:g} act like {:.3g} m/s: above {:.3g} m/s "
                  "inertia adds to the strength, soon more than 5 %",
                  speed, scaling, speed * std::sqrt(scaling), notable));
}

/// The generator cuts a block along the outlines of materials, but not a disc.
void warn_about_materials_of_a_disc(Scene& scene) {
  const bool disc = scene.laboratory->test == LaboratoryTest::brazilian && !scene.rock->mesh;
  const auto& regions = scene.mechanics->regions;
  const auto is_drawn = [](const RockRegion& region) { return region.form.has_value(); };
  if (disc && std::any_of(regions.begin(), regions.end(), is_drawn))
    scene.warnings.emplace_back(
        "the triangles of a generated disc do not follow the outlines of [[mechanics.material]]: each is of the "
        "material at its middle; rock.mesh may have other triangles");
}

/// The same for sides and parts of them that move in a run. A push that is over before its wave has crossed the rock is
/// no press but an impact, of which the wave is what is wanted.
void warn_about_platens(Scene& scene) {
  const double scaling = scene.mechanics->parameters.mass_scaling;
  const auto remark = [&](const std::string& key, const TractionLoad& load) {
    const double speed = fastest(load), felt = speed * std::sqrt(scaling);
    if (felt <= fastest_press || comes_to_rest(load) < std::sqrt(scaling) * crossing_time(scene)) return;
    const std::string scaled =
        scaling == 1 ? ""
                     : fmt::format(", which with mechanics.mass_scaling = {:g} acts like {:.3g} m/s", scaling, felt);
    scene.warnings.push_back(fmt::format(
        "{}.velocity moves a platen at up to {:g} m/s{}: above {:g} m/s (in tension 0.2 m/s) inertia adds to "
        "the strength, soon more than 5 %",
        key, speed, scaled, fastest_press));
  };
  for (const Side side : all_sides) {
    const TractionBoundary& traction = scene.side(side).traction;
    const std::string key = fmt::format("boundary.{}.traction", name_of(side));
    remark(key, traction.load);
    for (std::size_t p = 0; p < traction.parts.size(); ++p)
      remark(fmt::format("{}.parts.{}", key, p), traction.parts[p].load);
  }
}

}  // namespace

void collect_warnings(Scene& scene) {
  if (scene.laboratory) {
    warn_about_units(scene);
    warn_about_press(scene);
    return warn_about_materials_of_a_disc(scene);
  }
  warn_about_pores(scene);
  warn_about_units(scene);
  if (scene.rock && scene.rock->hole && !scene.injections.empty()) warn_about_injections(scene);
  if (scene.rock) warn_about_small_cavities(scene);
  if (scene.rock && scene.damage && !scene.rock->mesh)  // the size of a mesh's triangles is known once it is read
    for (std::string& remark : remarks_on_notches(scene, scene.rock->element_size))
      scene.warnings.push_back(std::move(remark));
  if (scene.mechanics) warn_about_support(scene);
  if (scene.rock) warn_about_sides(scene);
  if (scene.mechanics) warn_about_mass_scaling(scene);
  if (scene.mechanics) warn_about_platens(scene);
  if (scene.mechanics && scene.mechanics->force_unstable) {
    scene.warnings.emplace_back("mechanics.force_unstable accepts a time step that may diverge");
  }
}

}  // namespace vug
