// docs/case-file.md says what the reader does: the same keys, types, units, defaults and ranges.
#include "io/case_keys.hpp"
#include "io/detail/case_checks.hpp"
#include "io/detail/quantity.hpp"
#include "io/presets.hpp"
#include "unit/case_files.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>
#include <sstream>

namespace vug {
namespace {

std::string trimmed(const std::string& text) {
  const auto first = text.find_first_not_of(' ');
  return first == std::string::npos ? "" : text.substr(first, text.find_last_not_of(' ') - first + 1);
}

std::vector<std::string> cells(const std::string& row) {
  std::vector<std::string> result;
  std::istringstream stream(row.substr(1));
  for (std::string cell; std::getline(stream, cell, '|');) result.push_back(trimmed(cell));
  return result;
}

const std::vector<std::string>& lines() {
  static const std::vector<std::string> all = [] {
    std::istringstream stream(testing_cases::bytes_of(std::string(VUG_SOURCE_DIR) + "/docs/case-file.md"));
    std::vector<std::string> result;
    for (std::string line; std::getline(stream, line);) result.push_back(line);
    return result;
  }();
  return all;
}

TEST(CaseDocumentation, EveryKeyWithItsTypeUnitDefaultAndRange) {
  std::set<std::string> documented;
  for (const std::string& line : lines()) {
    if (!line.starts_with("| `")) continue;
    const auto row = cells(line);
    ASSERT_EQ(row.size(), 6u) << line;
    EXPECT_GT(row[5].size(), 5u) << "no meaning: " << line;
    EXPECT_TRUE(documented.insert(fmt::format("{} | {} | {} | {} | {}", row[0], row[1], row[2], row[3], row[4])).second)
        << "twice: " << line;
  }
  std::set<std::string> known;
  for (const KeyDescription& key : case_keys()) {
    known.insert(fmt::format("`{}` | {} | {} | {} | {}", key.key, key.type, key.unit, key.fallback, key.range));
  }
  for (const std::string& row : known) EXPECT_TRUE(documented.contains(row)) << "not documented: | " << row;
  for (const std::string& row : documented) EXPECT_TRUE(known.contains(row)) << "the reader does not know: | " << row;
  EXPECT_GT(known.size(), 100u);
}

TEST(CaseDocumentation, EveryUnitWithItsSpellingsAndLargestValue) {
  const std::vector<Unit> units = {unit::cells,
                                   unit::metre,
                                   unit::second,
                                   unit::kelvin,
                                   unit::pascal,
                                   unit::pascal_per_metre,
                                   unit::metre_per_second,
                                   unit::metre_per_square_second,
                                   unit::square_metre_per_second,
                                   unit::kilogram_per_cubic_metre,
                                   unit::joule_per_kilogram_kelvin,
                                   unit::joule_per_mole,
                                   unit::mole_per_cubic_metre,
                                   unit::cubic_metre_per_mole,
                                   unit::per_kelvin,
                                   unit::pascal_second,
                                   unit::mole_per_square_metre_second,
                                   unit::watt_per_square_metre_kelvin,
                                   unit::watt_per_metre_kelvin,
                                   unit::kilogram_per_metre_second,
                                   unit::newton_per_metre,
                                   unit::newton_second_per_metre,
                                   unit::second_per_metre,
                                   unit::watt_per_square_metre};
  std::set<std::string> checked{"", "1"};
  for (const Unit& unit : units) {
    const std::string all = accepted_units(unit);
    const std::string others = all.size() > unit.symbol.size() ? all.substr(unit.symbol.size() + 2) + " " : "";
    const std::string row = fmt::format("| {} | {}| {:g} |", unit.symbol, others, unit.largest);
    EXPECT_THAT(lines(), testing::Contains(row));
    checked.insert(std::string(unit.symbol));
  }
  for (const KeyDescription& key : case_keys()) EXPECT_TRUE(checked.contains(key.unit)) << key.key << ": " << key.unit;
}

TEST(CaseDocumentation, EveryPresetWithWhatItSets) {
  for (const Preset preset : {Preset::reference, Preset::careful, Preset::balanced, Preset::fast}) {
    const AccuracySection a = accuracy_of(preset);
    const MechanicsSection m = mechanics_of(preset);
    EXPECT_THAT(lines(), testing::Contains(fmt::format(
                             "| {} | {} | {} | {} | {} | {} | {} | {:g} | {:g} | {:g} |", a.preset,
                             a.precision == Precision::double_precision ? "double" : "single", a.update_interval,
                             a.wall_interval, a.heat_interval, a.solute_interval, a.exchange_interval,
                             m.critical_fraction, m.parameters.mass_scaling, m.parameters.rest_tolerance)));
  }
}

TEST(CaseDocumentation, ExamplesUseKeysThatExist) {
  int examples = 0;
  std::string example;
  bool inside = false;
  for (const std::string& line : lines()) {
    if (line == "```toml") {
      inside = true;
      example.clear();
    } else if (inside && line == "```") {
      inside = false;
      ++examples;
      EXPECT_NO_THROW(check_names(TomlDocument(example, "docs/case-file.md", {}))) << example;
    } else if (inside) {
      example += line + "\n";
    }
  }
  EXPECT_GE(examples, 13);  // one per table
}

}  // namespace
}  // namespace vug
