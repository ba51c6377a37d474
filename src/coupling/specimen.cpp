#include "coupling/specimen.hpp"

#include "base/require.hpp"
#include "coupling/memory_need.hpp"
#include "coupling/rock_limits.hpp"
#include "dem/extent.hpp"
#include "dem/materials.hpp"
#include "dem/require_edges.hpp"
#include "dem/slab_cooling.hpp"
#include "dem/test_steps.hpp"
#include "host/free_memory.hpp"
#include "io/mesh_reader.hpp"
#include "io/rock_generator.hpp"
#include "io/rock_regions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace vug {

namespace {

/// Throws InputError unless a mesh has the height and the area of a disc, with flats no wider than those of the
/// generator. The widest, 0.6 of the diameter, leave 0.8 of the height and 0.90 of the area; polygons have a little
/// less.
void require_disc(const Scene& scene, const Assembly& mesh) {
  double area = 0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) area += triangle_of(mesh, static_cast<int>(t)).area();
  const Extent extent = extent_of(mesh);
  const double width = extent.width(), height = extent.height() / width;
  const double filled = area / (std::numbers::pi / 4 * width * width);
  if (height < 0.79 || height > 1.01 || filled < 0.88 || filled > 1.02)
    throw InputError(fmt::format(
        "{}: {} is no disc, which test = \"brazilian\" splits: it is {:.3g} m wide and {:.3g} m high and fills "
        "{:.3g} of the circle of that width",
        scene.path, *scene.rock->mesh, width, extent.height(), filled));
}

Assembly triangles_of_specimen(const Scene& scene) {
  const LaboratorySection& laboratory = *scene.laboratory;
  const bool disc = laboratory.test == LaboratoryTest::brazilian;
  if (scene.rock->mesh) {
    Assembly mesh = read_mesh(*scene.rock->mesh);
    if (disc) require_disc(scene, mesh);
    return mesh;
  }
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

namespace {

/// Time over the duration of a quench in which the slab cools fastest: the first tenth.
constexpr double start_of_quench = 0.1;

/// Mean temperature change of a quenched slab at the end of that time over the drop, 0 to 1.
double cooled_at_the_start(const LaboratorySection& laboratory, double height) {
  const SlabCooling cooling(1, height, laboratory.biot);
  return -cooling.mean_change(laboratory.diffusion_length * std::sqrt(start_of_quench));  // length = 2 sqrt(kappa t)
}

/// Limits the speed of the thermal strain over the height of the specimen, converted to a specimen without mass
/// scaling; of a quench in its fastest tenth. In heating, 0.3, 1 and 3 m/s gave strengths of 98, 99 and 106 MPa. In a
/// quench, 0.07, 0.3, 0.7 and 3 m/s gave crack spacings of 20, 20, 10 and 7 mm.
Limit limit_of_heat(const Scene& scene, const Assembly& specimen) {
  const MechanicsParameters& rock = scene.mechanics->parameters;
  const LaboratorySection& laboratory = *scene.laboratory;
  const double height = extent_of(specimen).height();
  const bool quenched = laboratory.test == LaboratoryTest::quench;
  const double quicker = quenched ? cooled_at_the_start(laboratory, height) / start_of_quench : 1;
  const double growth = mean_expansion(rock, specimen) * laboratory.temperature_change * height;
  return {"laboratory",
          "speed of thermal strain over the height",
          quicker * growth / laboratory.duration * std::sqrt(rock.mass_scaling),
          "m/s",
          0,
          quenched ? 0.35 : 1,
          "inertia changes what breaks; raise laboratory.duration or lower mechanics.mass_scaling"};
}

/// Throws InputError for a slab that is cold in a small part of its quench.
void require_slow_cooling(const Scene& scene, const Assembly& specimen) {
  constexpr double cold = 0.9;
  const double height = extent_of(specimen).height();
  if (cooled_at_the_start(*scene.laboratory, height) <= cold) return;
  throw InputError(
      fmt::format("{}: laboratory.diffusion_length = {:g} m cools the slab, {:g} m high, almost through in a tenth of "
                  "laboratory.duration: lower it; a slab whose face is cold at once is cold at three times its height",
                  scene.path, scene.laboratory->diffusion_length, height));
}

}  // namespace

double longest_test(const Scene& scene, const Assembly& specimen) {
  const LaboratorySection& laboratory = *scene.laboratory;
  if (laboratory.test == LaboratoryTest::heating || laboratory.test == LaboratoryTest::quench)
    return laboratory.duration;
  return laboratory.largest_strain * extent_of(specimen).height() /
         platen_speed(laboratory, scene.mechanics->parameters);
}

void age_chemically(const Scene& scene, const Mechanics& rock) {
  Kokkos::deep_copy(rock.bonds().d_c, scene.laboratory->chemical_damage);
}

void require_testable(const Scene& scene, const Assembly& specimen, const Mechanics& rock) {
  const LaboratoryTest test = scene.laboratory->test;
  const double step = scene.mechanics->critical_fraction * rock.critical_step();
  const bool heated = test == LaboratoryTest::heating;
  if (test != LaboratoryTest::quench)
    whole_steps(longest_test(scene, specimen) / step,
                fmt::format("{}: laboratory.{}", scene.path, heated ? "duration" : "platen_speed"));
  if (test == LaboratoryTest::quench) {
    require_slow_cooling(scene, specimen);
    require_depth_for_cracks(specimen, scene.path);
    steps_of_quench(quench_test(scene), step, scene.path + ": laboratory");
    return;
  }
  Loads loads = press(platen_test(scene, specimen));
  for (std::string& name : loads.name) name = scene.path + ": " + name;
  require_edges(specimen, rock.boundary(), loads, rock.particles());
}

LimitTable limits_of_specimen(const Scene& scene, const Assembly& specimen, const Mechanics& rock) {
  constexpr double fewest_steps = 50, unbounded = std::numeric_limits<double>::infinity();
  const LaboratoryTest test = scene.laboratory->test;
  const bool warmed = test == LaboratoryTest::heating || test == LaboratoryTest::quench;
  const double fraction = scene.mechanics->critical_fraction;
  LimitTable table{
      {"mechanics", "sub-step over its critical step", fraction, "1", 0, 0.5, "lower mechanics.critical_fraction"},
      {"laboratory", "steps of the test", longest_test(scene, specimen) / (fraction * rock.critical_step()), "1",
       fewest_steps, unbounded, warmed ? "raise laboratory.duration" : "lower laboratory.platen_speed"},
      limit_of_edges(rock, 0)};
  if (warmed) table.push_back(limit_of_heat(scene, specimen));
  if (warmed)
    table.push_back(
        limit_of_thermal_strain(largest_expansion(scene.mechanics->parameters), scene.laboratory->temperature_change));
  if (scene.laboratory->confinement > 0) {
    const auto share = [&](RockSide flank) {
      return loaded_length(specimen, rock.boundary(), flank) / extent_of(specimen).height();
    };
    table.push_back({"laboratory", "share of a flank that the confinement presses",
                     std::min(share(RockSide::left), share(RockSide::right)), "1", 0.999, 1.001,
                     scene.rock->mesh
                         ? "edges of the mesh beside the bounding rectangle are not pressed: make the flanks straight"
                         : "walls of holes and notches that reach a flank are not pressed: draw them inside"});
  }
  if (test == LaboratoryTest::brazilian)
    table.push_back({"laboratory", "width of the flats over the diameter", flat_width(specimen, rock.boundary()), "1",
                     0, 0.301,
                     "rigid platens press most at the ends of flats this wide, which the strength does not know: it is "
                     "too high; lower laboratory.flat_width"});
  return table;
}

PlatenTest platen_test(const Scene& scene, const Assembly& specimen) {
  const LaboratorySection& laboratory = *scene.laboratory;
  PlatenTest test;
  test.speed = platen_speed(laboratory, scene.mechanics->parameters);
  if (laboratory.test == LaboratoryTest::tension) test.speed = -test.speed;
  if (laboratory.test == LaboratoryTest::brazilian) test.specimen = Specimen::disc;
  test.largest_strain = laboratory.largest_strain;
  test.sample_strain = sample_strain(laboratory, scene.mechanics->parameters);
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
