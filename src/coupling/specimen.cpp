#include "coupling/specimen.hpp"

#include "coupling/memory_need.hpp"
#include "coupling/rock_limits.hpp"
#include "dem/materials.hpp"
#include "host/free_memory.hpp"
#include "io/mesh_reader.hpp"
#include "io/rock_generator.hpp"
#include "io/rock_regions.hpp"
#include "kernels/base/require.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

namespace vug {

namespace {

Assembly triangles_of_specimen(const Scene& scene) {
  const LaboratorySection& laboratory = *scene.laboratory;
  if (scene.rock->mesh) return read_mesh(*scene.rock->mesh);
  const bool disc = laboratory.test == LaboratoryTest::brazilian;
  const double area = disc ? laboratory.diameter * laboratory.diameter : laboratory.size[0] * laboratory.size[1];
  require_memory(bytes_of_triangles(*scene.rock, area), scene.path + ": the specimen");
  if (disc) return generate_disc(laboratory.diameter, laboratory.flat_width, *scene.rock);
  return generate_rock(laboratory.size[0], laboratory.size[1], *scene.rock);
}

}  // namespace

Assembly build_specimen(const Scene& scene) {
  Assembly specimen = triangles_of_specimen(scene);
  assign_regions(scene.mechanics->regions, scene.minerals, scene.path, specimen);
  return specimen;
}

double longest_test(const Scene& scene, const Assembly& specimen) {
  const LaboratorySection& laboratory = *scene.laboratory;
  if (laboratory.test == LaboratoryTest::heating || laboratory.test == LaboratoryTest::quench)
    return laboratory.duration;
  const auto [low, high] = std::minmax_element(specimen.vertices.begin(), specimen.vertices.end(),
                                               [](const auto& a, const auto& b) { return a[1] < b[1]; });
  return laboratory.largest_strain * ((*high)[1] - (*low)[1]) / platen_speed(laboratory);
}

LimitTable limits_of_specimen(const Scene& scene, const Assembly& specimen, const Mechanics& rock) {
  constexpr double fewest_steps = 50, unbounded = std::numeric_limits<double>::infinity();
  const LaboratoryTest test = scene.laboratory->test;
  const bool warmed = test == LaboratoryTest::heating || test == LaboratoryTest::quench;
  const double fraction = scene.mechanics->critical_fraction;
  return {{"mechanics", "sub-step over its critical step", fraction, "1", 0, 0.5, "lower mechanics.critical_fraction"},
          {"laboratory", "steps of the test", longest_test(scene, specimen) / (fraction * rock.critical_step()), "1",
           fewest_steps, unbounded, warmed ? "raise laboratory.duration" : "lower laboratory.platen_speed"},
          limit_of_edges(rock)};
}

PlatenTest platen_test(const Scene& scene, const Assembly& specimen) {
  const LaboratorySection& laboratory = *scene.laboratory;
  PlatenTest test;
  test.speed = platen_speed(laboratory);
  if (laboratory.test == LaboratoryTest::tension) test.speed = -test.speed;
  if (laboratory.test == LaboratoryTest::brazilian) test.specimen = Specimen::disc;
  test.largest_strain = laboratory.largest_strain;
  test.sample_strain = laboratory.sample_strain;
  test.step_fraction = scene.mechanics->critical_fraction;
  test.confinement = laboratory.confinement;
  test.flanks = laboratory.flanks;
  test.confining_time = scene.mechanics->preload_time;
  test.confining_damping = scene.mechanics->preload_damping;
  test.chemical_damage = laboratory.chemical_damage;
  if (laboratory.test == LaboratoryTest::heating) {
    test.speed = 0;
    test.heating_rate = laboratory.temperature_change / laboratory.duration;
    test.largest_strain = mean_expansion(scene.mechanics->parameters, specimen) * laboratory.temperature_change;
    if (test.sample_strain > test.largest_strain)
      throw InputError(
          fmt::format("{}: laboratory.sample_strain = {:g} is more than the heat strains the specimen at the end, {:g}",
                      scene.path, test.sample_strain, test.largest_strain));
  }
  return test;
}

QuenchTest quench_test(const Scene& scene) {
  QuenchTest test;
  test.drop = scene.laboratory->temperature_change;
  test.samples = scene.laboratory->samples;
  test.final_length = scene.laboratory->diffusion_length;
  test.biot = scene.laboratory->biot;
  test.duration = scene.laboratory->duration;
  test.chemical_damage = scene.laboratory->chemical_damage;
  test.step_fraction = scene.mechanics->critical_fraction;
  return test;
}

}  // namespace vug
