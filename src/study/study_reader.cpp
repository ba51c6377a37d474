#include "base/require.hpp"
#include "io/detail/case_text.hpp"
#include "io/detail/input_file.hpp"
#include "io/detail/nearest_name.hpp"
#include "io/detail/toml_cursor.hpp"
#include "io/message.hpp"
#include "study/study.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <sstream>

namespace vug {

namespace {

constexpr int most_runs = 100000;

void check_known(const TomlDocument& document, const toml::table& table, const std::string& path,
                 const std::vector<std::string>& known) {
  for (const auto& [name, node] : table) {
    const std::string key(name.str());
    if (std::find(known.begin(), known.end(), key) == known.end())
      document.fail_at(path + key, fmt::format("{}{} is not a key of a study{}", path, key, suggestion(key, known)));
  }
}

/// A node as TOML, with or without text that may extend over several lines or stand as it is between single quotes.
std::string formatted(const toml::node& node, bool plainly) {
  using toml::format_flags;
  const auto lines = format_flags::allow_multi_line_strings, literal = format_flags::allow_literal_strings;
  const auto flags = toml::toml_formatter::default_flags & ~lines;
  std::ostringstream text;
  text << toml::toml_formatter{node, plainly ? flags : flags & ~literal};
  return text.str();
}

/// A value of a list as one line of TOML, arrays and tables included; empty for a date.
std::string text_of(const toml::node& node) {
  if (const auto* number = node.as_integer()) return fmt::format("{}", number->get());
  if (const auto* number = node.as_floating_point()) return fmt::format("{}", number->get());
  if (const auto* truth = node.as_boolean()) return truth->get() ? "true" : "false";
  if (!node.is_string() && !node.is_array() && !node.is_table()) return "";
  std::string line = formatted(node, true);
  if (line.find('\n') != std::string::npos) line = formatted(node, false);
  std::replace(line.begin(), line.end(), '\n', ' ');  // between the elements of a long list
  return line;
}

/// `count` values from `from` to `to`, both included.
std::vector<std::string> spread(const StudyKey& key, int count) {
  std::vector<std::string> values;
  for (int i = 0; i < count; ++i) {
    const double share = static_cast<double>(i) / (count - 1);
    const double value = i == count - 1    ? key.to
                         : key.logarithmic ? key.from * std::pow(key.to / key.from, share)
                                           : key.from + share * (key.to - key.from);
    values.push_back(fmt::format("{:.12g}", value));
  }
  return values;
}

StudyKey read_key(const TomlDocument& document, const TomlCursor& table, int index, Sampling sampling) {
  StudyKey key;
  table.need("key", key.key);
  const std::string path = fmt::format("study.keys.{}", index);
  if (key.key.find_first_of("= \t") != std::string::npos || key.key.find('.') == std::string::npos)
    table.fail("key", "must be a key of the case, such as reaction.damkohler");
  if (const toml::node* values = document.find(path + ".values")) {
    const auto* array = values->as_array();
    if (array == nullptr || array->empty()) table.fail("values", "must be a list of values");
    for (const toml::node& value : *array) key.values.push_back(text_of(value));
    if (std::find(key.values.begin(), key.values.end(), "") != key.values.end())
      table.fail("values", "holds a date, which no key of a case is");
  }
  std::optional<int> seeds, count;
  std::optional<double> from, to;
  table.read("seeds", seeds, range::between(1, most_runs));
  table.read("from", from, unit::none);
  table.read("to", to, unit::none);
  table.read("count", count, range::between(2, most_runs));
  table.choose("scale", key.logarithmic, {{"linear", false}, {"log", true}});
  if (!key.values.empty() + seeds.has_value() + from.has_value() != 1)
    document.fail_at(path, fmt::format("{}: give one of values, seeds, and from with to", path));
  if (seeds)
    for (int i = 1; i <= *seeds; ++i) key.values.push_back(fmt::format("{}", i));
  if (!from) {
    for (const char* other : {"to", "count", "scale"}) table.refuse(other, "needs from");
    return key;
  }
  if (!to) table.fail("to", "is missing; from needs it");
  key.from = *from;
  key.to = *to;
  if (key.logarithmic && !(key.from > 0 && key.to > 0)) table.fail("scale", "needs from and to above 0");
  const bool hypercube = sampling == Sampling::latin_hypercube;
  if (hypercube && count) table.fail("count", "is for grids and lists; study.samples says how many there are");
  if (!hypercube && !count) table.fail("count", "is missing; it says how many values lie from ... to");
  if (count) key.values = spread(key, *count);
  return key;
}

/// Throws where a later key sets what an earlier one has set: only one value would take effect, but the table would
/// show both.
void require_different_keys(const TomlDocument& document, const Study& study) {
  for (std::size_t later = 0; later < study.keys.size(); ++later)
    for (std::size_t earlier = 0; earlier < later; ++earlier) {
      const std::string &key = study.keys[later].key, &before = study.keys[earlier].key;
      if (before != key && !before.starts_with(key + ".")) continue;
      document.fail_at(fmt::format("study.keys.{}.key", later),
                       fmt::format("study.keys.{}.key = \"{}\" sets what study.keys.{}.key = \"{}\" has set; each key "
                                   "must be another",
                                   later, excerpt(key), earlier, excerpt(before)));
    }
}

}  // namespace

Study read_study(const std::string& path) {
  Study study;
  study.path = path;
  study.text = read_case_text(path);
  const TomlDocument document(study.text, path, {});
  if (document.find("study") == nullptr && document.find("lattice") != nullptr)
    document.fail_at("", "is a case, which `vug run` runs; a study has a table [study] that names its case");
  check_known(document, document.root(), "", {"study"});
  const TomlCursor table = TomlCursor(document).table("study");
  if (!table.given()) document.fail_at("", "has no table [study]");
  check_known(document, *document.find("study")->as_table(), "study.",
              {"case", "sampling", "samples", "seed", "set", "keys", "results"});
  table.need("case", study.case_path);
  if (const std::filesystem::path relative(study.case_path); relative.is_relative())
    study.case_path = (std::filesystem::path(path).parent_path() / relative).lexically_normal().string();
  if (const std::string why = detail::why_no_file(study.case_path); !why.empty())
    table.fail("case", fmt::format("{} (looked for {})", why, study.case_path));
  table.choose("sampling", study.sampling,
               {{"grid", Sampling::grid}, {"list", Sampling::list}, {"latin_hypercube", Sampling::latin_hypercube}});
  const bool hypercube = study.sampling == Sampling::latin_hypercube;
  table.read("samples", study.samples, range::between(2, most_runs));
  if (hypercube && study.samples == 0) table.fail("samples", "is missing; a Latin hypercube needs it");
  if (!hypercube) table.refuse("samples", "is for sampling = \"latin_hypercube\"");
  table.read("seed", study.seed);
  table.read("set", study.overrides);
  table.read("results", study.results);
  int index = 0;
  for (const TomlCursor& element : table.tables("keys")) {
    const std::string at = fmt::format("study.keys.{}", index);
    check_known(document, *document.find(at)->as_table(), at + ".",
                {"key", "values", "seeds", "from", "to", "count", "scale"});
    study.keys.push_back(read_key(document, element, index++, study.sampling));
  }
  require_different_keys(document, study);
  if (study.keys.empty()) table.fail("keys", "is missing; a study needs at least one [[study.keys]]");
  double runs = study.sampling == Sampling::grid ? 1 : 0;
  for (const StudyKey& key : study.keys) {
    if (study.sampling == Sampling::grid) runs *= static_cast<double>(key.values.size());
    if (study.sampling == Sampling::list && key.values.size() != study.keys[0].values.size())
      table.fail("sampling", fmt::format("needs keys with equally many values; {} has {}, {} has {}", study.keys[0].key,
                                         study.keys[0].values.size(), key.key, key.values.size()));
  }
  if (runs > most_runs) table.fail("keys", fmt::format("make {:g} runs, at most {} are accepted", runs, most_runs));
  return study;
}

}  // namespace vug
