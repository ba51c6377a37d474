// [laboratory]: a loading test of bonded rock alone.
#include "io/detail/case_checks.hpp"
#include "io/detail/case_tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numbers>

namespace vug {
namespace {

/// A key that some tests need and the others have no use for.
template <class Value, class... Arguments>
void need_if(bool used, const TomlCursor& table, const char* key, const char* otherwise, Value& value,
             Arguments... arguments) {
  if (used || table.describing()) {
    table.need(key, value, arguments...);
  } else {
    table.refuse(key, otherwise);
  }
}

/// The same with a default.
template <class Value, class... Arguments>
void read_if(bool used, const TomlCursor& table, const char* key, const char* otherwise, Value& value,
             Arguments... arguments) {
  if (used || table.describing()) {
    table.read(key, value, arguments...);
  } else {
    table.refuse(key, otherwise);
  }
}

}  // namespace

LaboratorySection read_laboratory(const TomlCursor& table, bool meshed) {
  using Test = LaboratoryTest;
  LaboratorySection laboratory;
  Test& test = laboratory.test;
  table.need_choice("test", test,
                    {{"compression", Test::compression},
                     {"tension", Test::tension},
                     {"brazilian", Test::brazilian},
                     {"heating", Test::heating},
                     {"quench", Test::quench}});
  const bool disc = test == Test::brazilian, pressed = test == Test::compression;
  const bool thermal = test == Test::heating || test == Test::quench, quenched = test == Test::quench;
  need_if(!disc && !meshed, table, "size", meshed ? "is for the generator; rock.mesh replaces it" : "is of a block",
          laboratory.size, unit::metre, range::positive);
  need_if(disc && !meshed, table, "diameter", meshed ? "is for the generator; rock.mesh replaces it" : "is of a disc",
          laboratory.diameter, unit::metre, range::positive);
  read_if(disc && !meshed, table, "flat_width", meshed ? "is for the generator; rock.mesh replaces it" : "is of a disc",
          laboratory.flat_width, unit::none, range::between(0.05, 0.6));
  read_if(!thermal, table, "platen_speed", "is of a test between moving platens", laboratory.platen_speed,
          unit::metre_per_second, range::positive);
  read_if(pressed, table, "confinement", "is only for test = \"compression\"", laboratory.confinement, unit::pascal,
          range::not_negative);
  if (laboratory.confinement > 0 || table.describing()) {
    table.choose("confinement_by", laboratory.flanks, {{"membrane", Support::free}, {"servo", Support::servo}});
  } else {
    table.refuse("confinement_by", "is of a test with laboratory.confinement");
  }
  table.read("chemical_damage", laboratory.chemical_damage, unit::none,
             {.low = 0, .high = ChemicalDamageLaw{}.failure_at, .high_open = true});
  need_if(thermal, table, "temperature_change", "is of heating and quench", laboratory.temperature_change,
          unit::kelvin_difference, range::positive);
  read_if(thermal, table, "duration", "is of heating and quench", laboratory.duration, unit::second, range::positive);
  read_if(quenched, table, "diffusion_length", "is only for test = \"quench\"", laboratory.diffusion_length,
          unit::metre, range::positive);
  read_if(quenched, table, "biot", "is only for test = \"quench\"", laboratory.biot, unit::none,
          Range{.low = 0, .low_open = true, .infinity_allowed = true});
  read_if(!thermal, table, "largest_strain", "is of a test between moving platens", laboratory.largest_strain,
          unit::none, range::positive_to(1));
  read_if(!thermal || test == Test::heating, table, "sample_strain", "is of a test with a curve of stress and strain",
          laboratory.sample_strain, unit::none, range::positive_to(0.1));
  if (!thermal && !table.describing() && laboratory.sample_strain > laboratory.largest_strain)
    table.fail("sample_strain",
               fmt::format("is more than laboratory.largest_strain = {:g}: the test would end at its first point",
                           laboratory.largest_strain));
  read_if(!thermal, table, "energies", "is of a test between moving platens", laboratory.energies);
  read_if(quenched, table, "samples", "is only for test = \"quench\"", laboratory.samples, range::between(10, 1e6));
  return laboratory;
}

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
  for (const char* key : {"mechanics.gravity", "mechanics.initial_velocity", "mechanics.displacement_from",
                          "mechanics.preload", "mechanics.substeps", "mechanics.force_unstable", "mechanics.fragments"})
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
  double expansion = scene.mechanics->parameters.thermal_expansion;
  for (const RockMaterial& material : scene.mechanics->parameters.materials)
    expansion = std::max(expansion, material.thermal_expansion);
  const double rise = expansion * laboratory.temperature_change;
  if (laboratory.test == LaboratoryTest::heating && laboratory.sample_strain > rise)
    document.fail("laboratory.sample_strain",
                  fmt::format("is more than the heat strains the specimen at the end, {:g}", rise));
  check_triangles(document, *scene.rock,
                  disc ? std::numbers::pi / 4 * laboratory.diameter * laboratory.diameter
                       : laboratory.size[0] * laboratory.size[1]);
  for (const char* key : {"output.interval_steps", "output.history_interval", "output.checkpoint_interval",
                          "output.probes", "output.gauges"})
    if (document.find(key) != nullptr)
      document.fail_at(key, fmt::format("{} is of a run on a lattice; a test has output.interval in s", key));
}

}  // namespace vug
