// Checks of [laboratory] against all other tables.
#include "io/detail/case_checks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numbers>

namespace vug {

void check_laboratory(const TomlDocument& document, const Scene& scene) {
  for (const char* table : {"lattice", "time", "geometry", "flow", "heat", "solute", "reaction", "mineral", "damage",
                            "boundary", "accuracy"})
    if (document.find(table) != nullptr)
      document.fail_at(table, fmt::format("[{}] has no place beside [laboratory], a test of rock alone", table));
  if (!scene.rock) document.fail_at("laboratory", "[laboratory] needs the table [rock]");
  const LaboratorySection& laboratory = *scene.laboratory;
  const bool disc = laboratory.test == LaboratoryTest::brazilian;
  for (const char* key : {"rock.porosity", "rock.pathway_aperture", "rock.pathway_width"})
    if (document.find(key) != nullptr) document.fail(key, "is of pathways on a lattice");
  if (disc)
    for (const char* key : {"rock.grading", "rock.notches", "rock.hole", "rock.holes"})
      if (document.find(key) != nullptr) document.fail_at(key, fmt::format("{} is of a block, not of a disc", key));
  if (scene.rock->mesh && !scene.rock->notches.empty())
    document.fail_at("rock.notches",
                     "rock.notches are of a generated specimen; of a mesh, lines of the group \"crack\" are notches");
  for (const char* key :
       {"mechanics.gravity", "mechanics.initial_velocity", "mechanics.displacement_from", "mechanics.preload",
        "mechanics.substeps", "mechanics.force_unstable", "mechanics.fragments", "mechanics.rest_tolerance"})
    if (document.find(key) != nullptr) document.fail_at(key, fmt::format("{} is of a run on a lattice", key));
  for (const char* key : {"mechanics.preload_time", "mechanics.preload_damping"})
    if (laboratory.confinement == 0 && document.find(key) != nullptr)
      document.fail_at(key, fmt::format("{} is of a test with laboratory.confinement", key));
  if (laboratory.test == LaboratoryTest::quench && document.find("mechanics.local_damping") != nullptr)
    document.fail_at("mechanics.local_damping", "mechanics.local_damping is 0.3 in a quench, whatever is given");
  const double smallest = disc ? laboratory.diameter : std::min(laboratory.size[0], laboratory.size[1]);
  if (!scene.rock->mesh && scene.rock->element_size > smallest / 5)
    document.fail("rock.element_size",
                  fmt::format("leaves fewer than five elements across the specimen; at most {:g} m", smallest / 5));
  check_places_of_specimen(document, scene);
  double expansion = scene.mechanics->parameters.thermal_expansion;
  for (const RockMaterial& material : scene.mechanics->parameters.materials)
    expansion = std::max(expansion, material.thermal_expansion);
  const double rise = expansion * laboratory.temperature_change;
  if (laboratory.test == LaboratoryTest::heating && sample_strain(laboratory, scene.mechanics->parameters) > rise)
    document.fail("laboratory.sample_strain",
                  fmt::format("is more than the heat strains the specimen at the end, {:g}", rise));
  check_thermal_strain(document, scene, laboratory.temperature_change);
  check_triangles(document, *scene.rock,
                  disc ? std::numbers::pi / 4 * laboratory.diameter * laboratory.diameter
                       : laboratory.size[0] * laboratory.size[1]);
  for (const char* key : {"output.interval_steps", "output.history_interval", "output.checkpoint_interval",
                          "output.probes", "output.gauges", "output.forces", "output.flows"})
    if (document.find(key) != nullptr)
      document.fail_at(key, fmt::format("{} is of a run on a lattice; a test has output.interval in s", key));
}

}  // namespace vug
