#include "io/detail/toml_document.hpp"

#include "base/require.hpp"
#include "io/detail/toml_hazards.hpp"
#include "io/detail/toml_hint.hpp"
#include "io/message.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

namespace vug {
namespace {

const toml::node* child(const toml::node& parent, std::string_view name) {
  if (const auto* table = parent.as_table()) return table->get(name);
  if (const auto* array = parent.as_array()) {
    std::size_t index = 0;
    const auto [end, error] = std::from_chars(name.data(), name.data() + name.size(), index);
    if (error == std::errc{} && end == name.data() + name.size() && index < array->size()) return array->get(index);
  }
  return nullptr;
}

bool lies_in(std::string_view key, std::string_view table) {
  return key == table || (key.size() > table.size() && key.starts_with(table) && key[table.size()] == '.');
}

}  // namespace

std::vector<std::string> split_key(std::string_view key) {
  std::vector<std::string> segments;
  std::size_t begin = 0;
  while (begin <= key.size()) {
    const std::size_t end = std::min(key.find('.', begin), key.size());
    segments.emplace_back(key.substr(begin, end - begin));
    begin = end + 1;
  }
  return segments;
}

std::string shown(const toml::node& node) {
  std::string text;
  if (const auto* value = node.as_string()) text = fmt::format("\"{}\"", value->get());
  if (const auto* value = node.as_integer()) text = fmt::format("{}", value->get());
  if (const auto* value = node.as_floating_point()) text = fmt::format("{}", value->get());
  if (const auto* value = node.as_boolean()) text = value->get() ? "true" : "false";
  if (node.is_date() || node.is_time() || node.is_date_time()) text = "a date or time";
  if (node.is_table()) text = "a table";
  if (const auto* array = node.as_array()) {
    for (const toml::node& element : *array) {
      if (text.size() > 60) break;
      text += (text.empty() ? "" : ", ") + shown(element);
    }
    text = "[" + text + "]";
  }
  return excerpt(text);
}

TomlDocument::TomlDocument(const std::string& text, std::string path, const std::vector<std::string>& overrides)
    : path_(std::move(path)) {
  refuse_toml_hazards(text, path_);
  try {
    root_ = toml::parse(text, path_);
  } catch (const toml::parse_error& error) {
    const auto& begin = error.source().begin;
    const std::string hint = hint_on(line_of(text, begin.line));
    throw InputError(one_line(fmt::format("{}:{}:{}: not valid TOML: {}{}", path_, std::max(begin.line, 1u),
                                          std::max(begin.column, 1u), excerpt(error.description(), 300),
                                          hint.empty() ? "" : "; " + hint)));
  }
  for (const std::string& line : overrides) overrides_.push_back(apply_override(root_, line));
}

const toml::node* TomlDocument::find(std::string_view key) const {
  const toml::node* node = &root_;
  if (key.empty()) return node;
  for (const std::string& segment : split_key(key)) {
    node = child(*node, segment);
    if (node == nullptr) return nullptr;
  }
  return node;
}

std::string TomlDocument::where(std::string_view key) const {
  const auto setting = std::find_if(overrides_.rbegin(), overrides_.rend(),
                                    [&](const Override& entry) { return lies_in(key, entry.key); });
  if (setting != overrides_.rend()) return "--set " + setting->text;
  // the nearest enclosing item that is written in the file: overrides and implied tables have no line
  for (std::string_view name = key;;) {
    const toml::node* node = find(name);
    if (node != nullptr && !name.empty() && node->source().begin) {
      return fmt::format("{}:{}:{}", path_, node->source().begin.line, node->source().begin.column);
    }
    if (name.empty()) return path_;
    const auto dot = name.rfind('.');
    name = dot == std::string_view::npos ? std::string_view{} : name.substr(0, dot);
  }
}

void TomlDocument::fail(std::string_view key, std::string_view problem) const {
  const toml::node* node = find(key);
  const std::string name = excerpt(key, 120);
  const bool plain = node != nullptr && !node->is_table() && !node->is_array_of_tables();
  fail_at(key, plain ? fmt::format("{} = {} {}", name, shown(*node), problem) : fmt::format("{} {}", name, problem));
}

void TomlDocument::fail_at(std::string_view key, std::string_view message) const {
  throw InputError(one_line(fmt::format("{}: {}", where(key), message)));
}

}  // namespace vug
