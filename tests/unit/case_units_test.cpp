// Numbers with a unit of their own, against what the unit is by definition.
#include "io/case_keys.hpp"
#include "io/detail/quantity.hpp"
#include "io/scene.hpp"

#include <gtest/gtest.h>

#include <optional>
#include <set>
#include <sstream>
#include <string>
#include <utility>

namespace vug {
namespace {

constexpr double centimetre = 1.0 / 100, millimetre = 1.0 / 1000, litre = 1.0 / 1000, gram = 1.0 / 1000;
constexpr double square_centimetre = centimetre * centimetre, cubic_centimetre = square_centimetre * centimetre;
constexpr double stokes = square_centimetre, poise = gram / centimetre;  // of CGS: cm2/s and g/(cm s)

const struct {
  Unit si;
  const char* written;
  double factor;
} units[] = {
    {unit::pascal, "kPa", 1e3},
    {unit::pascal, "MPa", 1e6},
    {unit::pascal, "GPa", 1e9},
    {unit::pascal, "bar", 100e3},
    {unit::pascal, "psi", 0.45359237 * 9.80665 / (0.0254 * 0.0254)},  // a pound's weight on a square inch
    {unit::metre, "cm", centimetre},
    {unit::metre, "mm", millimetre},
    {unit::metre, "um", 1e-6},
    {unit::metre, "nm", 1e-9},
    {unit::second, "ms", 1e-3},
    {unit::second, "us", 1e-6},
    {unit::second, "ns", 1e-9},
    {unit::second, "min", 60},
    {unit::second, "h", 60 * 60},
    {unit::second, "d", 24 * 60 * 60},
    {unit::mole_per_cubic_metre, "mol/L", 1 / litre},
    {unit::mole_per_cubic_metre, "mmol/L", 1e-3 / litre},
    {unit::mole_per_cubic_metre, "mol/cm3", 1 / cubic_centimetre},
    {unit::metre_per_second, "cm/s", centimetre},
    {unit::metre_per_second, "mm/s", millimetre},
    {unit::square_metre_per_second, "mm2/s", millimetre* millimetre},
    {unit::square_metre_per_second, "cm2/s", square_centimetre},
    {unit::square_metre_per_second, "St", stokes},
    {unit::square_metre_per_second, "cSt", stokes / 100},
    {unit::pascal_second, "mPa s", 1e-3},
    {unit::pascal_second, "P", poise},
    {unit::pascal_second, "cP", poise / 100},
    {unit::mole_per_square_metre_second, "mol/(cm2 s)", 1 / square_centimetre},
    {unit::kilogram_per_cubic_metre, "g/cm3", gram / cubic_centimetre},
    {unit::joule_per_mole, "kJ/mol", 1e3},
    {unit::cubic_metre_per_mole, "cm3/mol", cubic_centimetre},
    {unit::joule_per_kilogram_kelvin, "kJ/(kg K)", 1e3},
    {unit::watt_per_square_metre, "kW/m2", 1e3},
    {unit::watt_per_square_metre, "MW/m2", 1e6},
};

TEST(CaseUnits, AreWhatTheyAreByDefinition) {
  for (const auto& [si, written, factor] : units) {
    const std::optional<double> value = parse_quantity(std::string("2.5 ") + written, si);
    ASSERT_TRUE(value) << written;
    EXPECT_DOUBLE_EQ(*value, 2.5 * factor) << written;
  }
}

/// As they are typed or pasted: signs and raised digits.
TEST(CaseUnits, MayBeWrittenWithTheirSigns) {
  const struct {
    const char* written;
    Unit si;
    double value;
  } signs[] = {{"3 \u00b5m", unit::metre, 3e-6},
               {"3 \u03bcm", unit::metre, 3e-6},
               {"20 \u00b0C", unit::kelvin, 293.15},
               {"2 mm\u00b2/s", unit::square_metre_per_second, 2e-6},
               {"2 m^2/s", unit::square_metre_per_second, 2},
               {"2 g/cm\u00b3", unit::kilogram_per_cubic_metre, 2000},
               {"2 mol/m^3", unit::mole_per_cubic_metre, 2}};
  for (const auto& [written, si, value] : signs)
    EXPECT_DOUBLE_EQ(parse_quantity(written, si).value_or(0), value) << written;
  EXPECT_FALSE(parse_quantity("3 \u00c2m", unit::metre));
  EXPECT_FALSE(parse_quantity("3 \u00b5", unit::metre));
}

TEST(CaseUnits, OfTheCelsiusScaleCountFromFreezing) {
  for (const auto& [celsius, kelvin] : {std::pair{"0 degC", 273.15}, {"100 degC", 373.15}, {"-273.15 degC", 0.0}})
    EXPECT_DOUBLE_EQ(parse_quantity(celsius, unit::kelvin).value(), kelvin) << celsius;
}

TEST(CaseUnits, OfTheCelsiusScaleAreKelvinsInADifference) {
  for (const char* written : {"100 degC", "100 K"})
    EXPECT_EQ(parse_quantity(written, unit::kelvin_difference).value(), 100) << written;
  const auto laboratory = [](const char* change) {
    return parse_scene(std::string("[laboratory]\ntest = \"heating\"\nsize = [0.015, 0.03]\ntemperature_change = ") +
                           change + "\n[rock]\nelement_size = 2.5e-3\n[mechanics]\n",
                       "a.toml")
        .laboratory->temperature_change;
  };
  EXPECT_EQ(laboratory("\"100 degC\""), 100);
  EXPECT_EQ(laboratory("100"), 100);
}

/// So that no unit comes in without its definition.
TEST(CaseUnits, AreAllInThisTable) {
  std::set<std::string> defined{"degC"};
  for (const auto& row : units) defined.insert(row.written);
  for (const KeyDescription& key : case_keys()) {
    std::istringstream list(accepted_units({key.unit, 0}));
    for (std::string word; std::getline(list >> std::ws, word, ',');)
      EXPECT_TRUE(word == key.unit || defined.contains(word)) << word;
  }
}

}  // namespace
}  // namespace vug
