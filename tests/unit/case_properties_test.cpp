// Every key of every table in turn is given what it cannot be; the reader must name it, with its line and column.
#include "io/case_keys.hpp"
#include "unit/case_files.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <set>
#include <sstream>

namespace vug {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

/// One `key = value` line of a case that has one key per line and no inline tables.
struct KeyLine {
  int number;
  std::string table;       ///< "solute.species.0"
  std::string documented;  ///< "solute.species.N.name"
  std::string key, value;
};

struct CaseText {
  std::string path;
  std::vector<std::string> lines;
  std::vector<KeyLine> keys;

  std::string with(int number, const std::string& line) const {
    std::string text;
    for (int i = 0; i < static_cast<int>(lines.size()); ++i) text += (i + 1 == number ? line : lines[i]) + "\n";
    return text;
  }
};

std::string documented_table(const std::string& table) {
  std::string result;
  std::istringstream stream(table);
  for (std::string name; std::getline(stream, name, '.');) {
    if (name.find_first_not_of("0123456789") == std::string::npos) name = "N";
    if (result == "boundary.shape") name = "<name>";
    const bool side = name == "left" || name == "right" || name == "bottom" || name == "top";
    result += (result.empty() ? "" : ".") + (side ? "<side>" : name);
  }
  return result;
}

CaseText text_of(const std::filesystem::path& path) {
  CaseText text{path.string(), {}, {}};
  std::istringstream stream(testing_cases::bytes_of(path));
  std::map<std::string, int> elements;
  std::string table;
  for (std::string line; std::getline(stream, line);) {
    text.lines.push_back(line);
    const int number = static_cast<int>(text.lines.size());
    if (line.starts_with("[[")) {
      std::string array = line.substr(2, line.find(']') - 2);
      if (const auto dot = array.rfind('.'); dot != std::string::npos && elements.contains(array.substr(0, dot)))
        array.insert(dot, fmt::format(".{}", elements[array.substr(0, dot)] - 1));  // within the last element
      table = fmt::format("{}.{}", array, elements[array]++);
    } else if (line.starts_with("[")) {
      table = line.substr(1, line.find(']') - 1);
      for (const auto& [array, count] : elements)  // a table of the last element
        if (table.starts_with(array + "."))
          table = fmt::format("{}.{}{}", array, count - 1, table.substr(array.size()));
    } else if (const auto equals = line.find(" = "); equals != std::string::npos && !line.starts_with("#")) {
      const std::string key = line.substr(0, equals);
      const bool free_key = table.ends_with(".concentration") || table.ends_with("solute.flux");
      const std::string documented = documented_table(table) + "." + (free_key ? "<species>" : key);
      text.keys.push_back({number, table, documented, key, line.substr(equals + 3)});
    }
  }
  return text;
}

std::vector<CaseText> complete_cases() {
  std::vector<CaseText> cases;
  for (const auto& path : testing_cases::cases_in("tests/cases/complete")) cases.push_back(text_of(path));
  return cases;
}

const KeyDescription* description(const std::string& documented) {
  for (const KeyDescription& key : case_keys()) {
    if (key.key == documented) return &key;
  }
  return nullptr;
}

bool is_numeric(const KeyDescription& key) {
  return !key.unit.empty();
}

/// `value` with its first number replaced: "[0.1, 2]" becomes "[nan, 2]".
std::string with_first_number(const std::string& value, const std::string& number) {
  const auto begin = value.find_first_not_of("[ ");
  const auto end = value.find_first_of(",]", begin);
  return value.substr(0, begin) + number + (end == std::string::npos ? "" : value.substr(end));
}

void expect_named(const CaseText& text, const KeyLine& line, const std::string& value) {
  const std::string changed = text.with(line.number, fmt::format("{} = {}", line.key, value));
  const std::string message = testing_cases::refusal(changed, text.path);
  EXPECT_NE(message, "") << "accepted: " << line.table << "." << line.key << " = " << value;
  EXPECT_THAT(message, StartsWith(fmt::format("{}:{}:", text.path, line.number)));
  EXPECT_THAT(message, HasSubstr(fmt::format("{}.{}", line.table, line.key)));
  if (value.front() != '[') {
    EXPECT_THAT(message, StartsWith(fmt::format("{}:{}:{}: ", text.path, line.number, line.key.size() + 4)));
  }
}

TEST(CaseProperties, CompleteCasesAreValidAndCoverEveryKey) {
  std::set<std::string> covered;
  for (const CaseText& text : complete_cases()) {
    EXPECT_EQ(testing_cases::refusal(text.with(0, ""), text.path), "");
    for (const KeyLine& line : text.keys) covered.insert(line.documented);
  }
  for (const KeyDescription& key : case_keys()) EXPECT_TRUE(covered.contains(key.key)) << "not covered: " << key.key;
}

TEST(CaseProperties, EveryNumberRefusesWhatIsNoNumberOfItsRange) {
  int tried = 0;
  for (const CaseText& text : complete_cases()) {
    for (const KeyLine& line : text.keys) {
      const KeyDescription* known = description(line.documented);
      ASSERT_NE(known, nullptr) << line.documented;
      if (!is_numeric(*known)) continue;
      std::vector<std::string> wrong = {"nan",  "-inf",     "1e300",         "-1e300",
                                        "true", "\"many\"", "\"1 furlong\"", "1979-05-27"};
      // infinite means irreversible, or cold at once
      if (line.key != "equilibrium_constant" && line.key != "biot") wrong.emplace_back("inf");
      if (known->range != "any") wrong.emplace_back("-1");
      if (known->type.find("whole") != std::string::npos) wrong.emplace_back("1.5");
      for (const std::string& value : wrong) expect_named(text, line, with_first_number(line.value, value));
      for (const std::string value : {"[]", "[1, 2, 3]", "{ value = 1 }"}) {
        const bool points = known->type == "list of points";
        if (points && std::string(value) == "[]") continue;                       // no points: refused as too few
        if (known->type == "list of whole numbers" && value[0] == '[') continue;  // as many labels as there are
        if (known->type == "three numbers" && value == "[1, 2, 3]") continue;
        const std::string changed = text.with(line.number, fmt::format("{} = {}", line.key, value));
        EXPECT_THAT(testing_cases::refusal(changed, text.path), HasSubstr(fmt::format("{}.{}", line.table, line.key)));
      }
      ++tried;
    }
  }
  EXPECT_GT(tried, 90);
}

TEST(CaseProperties, EveryWordTextAndSwitchRefusesOtherTypes) {
  for (const CaseText& text : complete_cases()) {
    for (const KeyLine& line : text.keys) {
      const KeyDescription* known = description(line.documented);
      ASSERT_NE(known, nullptr) << line.documented;
      if (is_numeric(*known)) continue;
      for (const std::string value : {"1.5", "[[]]", "1979-05-27"}) expect_named(text, line, value);
      if (known->type == "word") expect_named(text, line, "\"nosuchword\"");
      if (known->type == "true or false") expect_named(text, line, "\"true\"");
    }
  }
}

TEST(CaseProperties, EveryMisspeltKeyIsNamedWithTheRightOne) {
  for (const CaseText& text : complete_cases()) {
    for (const KeyLine& line : text.keys) {
      std::string misspelt = line.key;
      std::swap(misspelt[0], misspelt[1]);
      const std::string changed = text.with(line.number, fmt::format("{} = {}", misspelt, line.value));
      const std::string message = testing_cases::refusal(changed, text.path);
      EXPECT_THAT(message, HasSubstr(fmt::format("{}.{}", line.table, misspelt)));
      EXPECT_THAT(message, StartsWith(fmt::format("{}:{}:", text.path, line.number)));
      if (line.documented.ends_with("<species>")) {
        EXPECT_THAT(message, HasSubstr(fmt::format("\"{}\", which is not the name of a", misspelt)));
      } else {
        EXPECT_THAT(message, StartsWith(fmt::format("{}:{}:1: ", text.path, line.number)));
        EXPECT_THAT(message, HasSubstr(fmt::format("did you mean \"{}\"?", line.key)));
      }
    }
  }
}

TEST(CaseProperties, EveryKeyCanBeSetFromTheCommandLine) {
  for (const CaseText& text : complete_cases()) {
    for (const KeyLine& line : text.keys) {
      const std::string key = fmt::format("{}.{}", line.table, line.key);
      EXPECT_EQ(testing_cases::refusal(text.with(0, ""), text.path, {key + "=" + line.value}), "");
      const std::string broken = testing_cases::refusal(text.with(0, ""), text.path, {key + "=nan"});
      const bool text_key = description(line.documented)->type == "text";  // nan is a fine name
      if (!text_key) {
        EXPECT_THAT(broken, StartsWith(fmt::format("--set {}=nan: ", key)));
      }
    }
  }
}

TEST(CaseProperties, EveryRequiredKeyIsMissed) {
  for (const CaseText& text : complete_cases()) {
    for (const KeyLine& line : text.keys) {
      if (description(line.documented)->fallback != "required") continue;
      const std::string message = testing_cases::refusal(text.with(line.number, ""), text.path);
      EXPECT_THAT(message, HasSubstr(fmt::format("{}.{} is missing", line.table, line.key)));
    }
  }
}

}  // namespace
}  // namespace vug
