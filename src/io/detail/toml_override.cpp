// `--set table.key=value` replaces a value of the file by one from the command line; `--set table={...}` replaces a
// whole table.
#include "base/require.hpp"
#include "io/detail/toml_document.hpp"
#include "io/detail/toml_hazards.hpp"
#include "io/message.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

namespace vug {
namespace {

constexpr std::size_t deepest = 16;  // cases have fewer levels

/// An override as it may appear in a message.
std::string shortened(const std::string& text) {
  return excerpt(text, 120);
}

[[noreturn]] void refuse(const std::string& text, const std::string& problem) {
  throw InputError(one_line(fmt::format("--set {}: {}", shortened(text), problem)));
}

std::string trimmed(const std::string& text) {
  const auto first = text.find_first_not_of(" \t");
  if (first == std::string::npos) return "";
  return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

/// Whether a segment is a number, that is an array index.
bool is_index(const std::string& segment) {
  return !segment.empty() && segment.size() < 10 &&
         std::all_of(segment.begin(), segment.end(), [](char c) { return c >= '0' && c <= '9'; });
}

/// The value as a one-entry table { value = ... }: TOML where it parses, otherwise the text itself.
toml::table parsed_value(const std::string& text, const std::string& value) {
  if (value.find_first_of("\r\n") != std::string::npos) refuse(text, "the value must stand on one line");
  const bool looks_structured = std::string_view("[{\"'").find(value.front()) != std::string_view::npos;
  toml::table bare;
  bare.insert("value", value);
  // toml++ may see characters beyond ASCII between quotes only (toml_hazards.cpp)
  if (!looks_structured && std::any_of(value.begin(), value.end(), is_beyond_ascii)) return bare;
  refuse_toml_hazards("value = " + value, "--set " + shortened(text));
  try {
    toml::table table = toml::parse("value = " + value);
    if (table.size() == 1 && table.contains("value")) return table;
  } catch (const toml::parse_error& error) {
    if (looks_structured) refuse(text, fmt::format("the value is not valid TOML: {}", error.description()));
  }
  return bare;
}

/// Whether a node is a table or a list of tables, which may stand at the top level of a case.
bool is_whole_table(const toml::node& node) {
  const auto* array = node.as_array();
  return node.is_table() || (array != nullptr && (array->empty() || array->is_homogeneous<toml::table>()));
}

toml::node& element(toml::array& array, const std::string& segment, const std::string& text, bool last) {
  if (!is_index(segment)) {
    refuse(text, fmt::format("\"{}\" must be the number of an element, counted from 0", excerpt(segment)));
  }
  std::size_t index = 0;
  std::from_chars(segment.data(), segment.data() + segment.size(), index);
  if (index > array.size()) {
    refuse(text, fmt::format("element {} does not exist, there are {} (counted from 0)", index, array.size()));
  }
  if (index == array.size()) {
    if (last) {
      array.push_back(0);
    } else {
      array.push_back(toml::table{});
    }
  }
  return *array.get(index);
}

/// The child of `node` on the way to a key. A missing one is added, as a table or a list as the next segment requires.
toml::node& descend(toml::node& node, const std::string& segment, const std::string& next, const std::string& text) {
  if (auto* array = node.as_array()) return element(*array, segment, text, false);
  auto* table = node.as_table();
  if (table == nullptr) refuse(text, fmt::format("\"{}\" is looked for inside a plain value", excerpt(segment)));
  if (!table->contains(segment)) {
    if (next == "0") {
      table->insert(segment, toml::array{});
    } else {
      table->insert(segment, toml::table{});
    }
  }
  return *table->get(segment);
}

}  // namespace

Override apply_override(toml::table& root, const std::string& text) {
  const auto equals = text.find('=');
  if (equals == std::string::npos) refuse(text, "expected table.key=value");
  if (!is_utf8(text)) refuse(text, "is no UTF-8 text");
  const std::string key = trimmed(text.substr(0, equals));
  const std::string value = trimmed(text.substr(equals + 1));
  const std::vector<std::string> segments = split_key(key);
  const bool nameless = std::any_of(segments.begin(), segments.end(), [](const auto& s) { return s.empty(); });
  if (nameless) refuse(text, "expected table.key=value");
  if (segments.size() > deepest) refuse(text, "no key lies that deep");
  if (value.empty()) refuse(text, "the value is missing, expected table.key=value");

  toml::node* node = &root;
  for (std::size_t i = 0; i + 1 < segments.size(); ++i) node = &descend(*node, segments[i], segments[i + 1], text);
  toml::table holder = parsed_value(text, value);
  const toml::node& parsed = *holder.get("value");
  if (segments.size() < 2 && !is_whole_table(parsed))
    refuse(text, "expected table.key=value, or for a whole table table={ key = value }");
  if (auto* array = node->as_array()) {
    element(*array, segments.back(), text, true);
    std::size_t index = 0;
    std::from_chars(segments.back().data(), segments.back().data() + segments.back().size(), index);
    parsed.visit(
        [&](const auto& typed) { array->replace(array->begin() + static_cast<std::ptrdiff_t>(index), typed); });
  } else if (auto* table = node->as_table()) {
    parsed.visit([&](const auto& typed) { table->insert_or_assign(segments.back(), typed); });
  } else {
    refuse(text, fmt::format("\"{}\" is looked for inside a plain value", excerpt(segments.back())));
  }
  return {key, shortened(text)};
}

}  // namespace vug
