// [laboratory]: a loading test of bonded rock alone.
#include "io/detail/case_tables.hpp"

#include <fmt/format.h>

namespace vug {
namespace {

/// Reads a key that some tests need; refuses it in the others, which have no use for it.
template <class Value, class... Arguments>
void need_if(bool used, const TomlCursor& table, const char* key, const char* otherwise, Value& value,
             Arguments... arguments) {
  if (used || table.describing()) {
    table.need(key, value, arguments...);
  } else {
    table.refuse(key, otherwise);
  }
}

/// Does the same for a key that has a default.
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

}  // namespace vug
