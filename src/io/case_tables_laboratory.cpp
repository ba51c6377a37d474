// [laboratory]: a loading test of bonded rock alone.
#include "io/detail/case_tables.hpp"

#include <fmt/format.h>

namespace vug {

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
  const char* const replaced = "is for the generator; rock.mesh replaces it";
  const char* const of_disc = meshed ? replaced : "is of a disc";
  table.need_if(!disc && !meshed, "size", meshed ? replaced : "is of a block", laboratory.size, unit::metre,
                range::positive);
  table.need_if(disc && !meshed, "diameter", of_disc, laboratory.diameter, unit::metre, range::positive);
  table.read_if(disc && !meshed, "flat_width", of_disc, laboratory.flat_width, unit::none, range::between(0.05, 0.6));
  table.read_if(!thermal, "platen_speed", "is of a test between moving platens", laboratory.platen_speed,
                unit::metre_per_second, range::positive);
  table.read_if(pressed, "confinement", "is only for test = \"compression\"", laboratory.confinement, unit::pascal,
                range::not_negative);
  if (laboratory.confinement > 0 || table.describing())
    table.choose("confinement_by", laboratory.flanks, {{"membrane", Support::free}, {"servo", Support::servo}});
  else
    table.refuse("confinement_by", "is of a test with laboratory.confinement");
  table.read("chemical_damage", laboratory.chemical_damage, unit::none,
             {.low = 0, .high = ChemicalDamageLaw{}.failure_at, .high_open = true});
  table.need_if(thermal, "temperature_change", "is of heating and quench", laboratory.temperature_change,
                unit::kelvin_difference, range::positive);
  table.read_if(thermal, "duration", "is of heating and quench", laboratory.duration, unit::second, range::positive);
  table.read_if(quenched, "diffusion_length", "is only for test = \"quench\"", laboratory.diffusion_length, unit::metre,
                range::positive);
  table.read_if(quenched, "biot", "is only for test = \"quench\"", laboratory.biot, unit::none,
                Range{.low = 0, .low_open = true, .infinity_allowed = true});
  table.read_if(!thermal, "largest_strain", "is of a test between moving platens", laboratory.largest_strain,
                unit::none, range::positive_to(1));
  table.read_if(!thermal || test == Test::heating, "sample_strain", "is of a test with a curve of stress and strain",
                laboratory.sample_strain, unit::none, range::positive_to(0.1));
  if (!thermal && !table.describing() && laboratory.sample_strain.value_or(0) > laboratory.largest_strain)
    table.fail("sample_strain",
               fmt::format("is more than laboratory.largest_strain = {:g}: the test would end at its first point",
                           laboratory.largest_strain));
  table.read_if(!thermal, "energies", "is of a test between moving platens", laboratory.energies);
  table.read_if(quenched, "samples", "is only for test = \"quench\"", laboratory.samples, range::between(10, 1e6));
  return laboratory;
}

}  // namespace vug
