#include "io/detail/toml_cursor.hpp"

#include "base/require.hpp"
#include "io/detail/nearest_name.hpp"
#include "io/detail/quantity.hpp"
#include "io/detail/toml_hint.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace vug {
namespace {

std::string in_unit(Unit unit) {
  return unit.symbol == unit::none.symbol ? "" : fmt::format(" ({})", unit.symbol);
}

std::string joined(const std::string& path, std::string_view key) {
  return path.empty() ? std::string(key) : fmt::format("{}.{}", path, key);
}

}  // namespace

std::string TomlCursor::inside(std::string_view key) const {
  return joined(path_, key);
}
std::string TomlCursor::documented(std::string_view key) const {
  return joined(documented_path_, key);
}

const toml::node* TomlCursor::node(std::string_view key) const {
  return given_ && !describing() ? document_->find(inside(key)) : nullptr;
}

/// The node of a key, or null where its default applies. While describing it only adds the key to the log.
const toml::node* TomlCursor::look_up(KeyDescription description) const {
  if (describing()) {
    description.key = documented(description.key);
    log_->push_back(std::move(description));
    return nullptr;
  }
  return node(description.key);
}

TomlCursor TomlCursor::table(std::string_view key, std::string_view documented_key) const {
  TomlCursor inner = *this;
  inner.path_ = inside(key);
  inner.documented_path_ = documented(documented_key.empty() ? key : documented_key);
  if (describing()) return inner;
  const toml::node* found = node(key);
  inner.given_ = found != nullptr;
  if (found != nullptr && !found->is_table()) document_->fail(inner.path_, "must be a table");
  return inner;
}

std::vector<TomlCursor> TomlCursor::tables(std::string_view key) const {
  std::vector<TomlCursor> elements;
  TomlCursor element = *this;
  element.documented_path_ = documented(fmt::format("{}.N", key));
  if (describing()) return {element};
  const toml::node* found = node(key);
  if (found == nullptr) return {};
  const auto* array = found->as_array();
  if (array == nullptr || (!array->empty() && !array->is_homogeneous(toml::node_type::table))) {
    document_->fail(inside(key), fmt::format("must be an array of tables, each begun by [[{}]]", inside(key)));
  }
  for (std::size_t i = 0; i < array->size(); ++i) {
    element.path_ = fmt::format("{}.{}", inside(key), i);
    elements.push_back(element);
  }
  return elements;
}

std::vector<TomlCursor> TomlCursor::one_or_more(std::string_view key) const {
  const toml::node* found = node(key);
  if (found != nullptr && found->is_array()) return tables(key);
  const TomlCursor one = table(key);
  if (!one.given()) return {};
  return {one};
}

std::vector<std::pair<std::string, TimeTable>> TomlCursor::named_numbers(std::string_view key,
                                                                         std::string_view documented_name, Unit unit,
                                                                         Range range) const {
  const toml::node* found = look_up(
      {fmt::format("{}.{}", key, documented_name), "number or table", std::string(unit.symbol), "-", range.text()});
  if (describing()) return {};
  found = node(key);
  if (found == nullptr) return {};
  const auto* entries = found->as_table();
  if (entries == nullptr) document_->fail(inside(key), "must be a table such as { L1 = 3000 }");
  std::vector<std::pair<std::string, TimeTable>> values;
  for (const auto& [name, value] : *entries) {
    const std::string path = fmt::format("{}.{}", inside(key), name.str());
    values.emplace_back(std::string(name.str()), time_table(value, path, unit, range));
  }
  return values;
}

double TomlCursor::number(const toml::node& node, const std::string& key, Unit unit, Range range) const {
  double value = 0;
  if (const auto* integer = node.as_integer()) {
    value = static_cast<double>(integer->get());
  } else if (const auto* real = node.as_floating_point()) {
    value = real->get();
  } else if (const auto* text = node.as_string()) {
    const auto parsed = parse_quantity(text->get(), unit);
    const std::string units = accepted_units(unit);
    if (!parsed && has_decimal_comma(text->get())) document_->fail(key, "must have a decimal point instead of a comma");
    if (!parsed && units.empty()) document_->fail(key, "must be a number, without quotes");
    if (!parsed)
      document_->fail(key, fmt::format("must be a number{} or text with one of the units {}", in_unit(unit), units));
    value = *parsed;
  } else {
    document_->fail(key, fmt::format("must be a number{}", in_unit(unit)));
  }
  if (range.infinity_allowed && value == std::numeric_limits<double>::infinity()) return value;
  if (!std::isfinite(value)) document_->fail(key, fmt::format("must be a finite number{}", in_unit(unit)));
  if (!range.contains(value)) document_->fail(key, fmt::format("must be {}{}", range.text(), in_unit(unit)));
  if (std::abs(value) > unit.largest) {
    document_->fail(key, fmt::format("is too large: at most {:g}{} is accepted", unit.largest, in_unit(unit)));
  }
  return value;
}

std::int64_t TomlCursor::whole(const toml::node& node, const std::string& key, Range range) const {
  constexpr double exact = 9007199254740992.0;  // 2^53, beyond which not every whole number is a double
  std::int64_t value = 0;
  if (const auto* integer = node.as_integer()) {
    value = integer->get();
  } else if (const auto* real = node.as_floating_point();
             real != nullptr && std::abs(real->get()) <= exact && real->get() == std::floor(real->get())) {
    value = static_cast<std::int64_t>(real->get());
  } else {
    document_->fail(key, "must be a whole number");
  }
  if (!range.contains(static_cast<double>(value))) {
    document_->fail(key, fmt::format("must be a whole number {}", range.text()));
  }
  return value;
}

int TomlCursor::whole_int(const toml::node& node, const std::string& key, Range range) const {
  const std::int64_t number = whole(node, key, range);
  if (number > std::numeric_limits<int>::max()) document_->fail(key, "is too large: at most 2147483647 is accepted");
  if (number < std::numeric_limits<int>::min()) document_->fail(key, "is too small: at least -2147483648 is accepted");
  return static_cast<int>(number);
}

const toml::array& TomlCursor::array_of(const toml::node& node, const std::string& key, std::size_t size,
                                        std::string_view expected) const {
  const auto* array = node.as_array();
  if (array == nullptr || (size > 0 && array->size() != size)) {
    document_->fail(key, fmt::format("must be {}", expected));
  }
  return *array;
}

std::string TomlCursor::word(std::string_view key, const std::string& fallback,
                             const std::vector<std::string>& words) const {
  const toml::node* found = look_up(
      {std::string(key), "word", "", fmt::format("\"{}\"", fallback), fmt::format("{}", fmt::join(words, ", "))});
  if (found == nullptr) return fallback;
  const auto* text = found->as_string();
  if (text == nullptr) fail(key, fmt::format("must be one of the words \"{}\"", fmt::join(words, "\", \"")));
  if (std::find(words.begin(), words.end(), text->get()) == words.end()) {
    fail(key, fmt::format("must be one of \"{}\"{}", fmt::join(words, "\", \""), likely_name(text->get(), words)));
  }
  return text->get();
}

void TomlCursor::require(std::string_view key) const {
  if (describing() || node(key) != nullptr) return;
  const std::string name = documented(key);
  for (const KeyDescription& known : case_keys()) {
    if (known.key != name) continue;
    const std::string unit = known.unit.empty() || known.unit == "1" ? "" : fmt::format(" in {}", known.unit);
    const std::string range = known.range.empty() || known.range == "any" ? "" : fmt::format(", {}", known.range);
    document_->fail_at(inside(key),
                       fmt::format("{} is missing; it must be given ({}{}{})", inside(key), known.type, unit, range));
  }
  document_->fail_at(inside(key), fmt::format("{} is missing", inside(key)));
}

void TomlCursor::mark_required() const {
  if (describing()) log_->back().fallback = "required";
}

void TomlCursor::refuse(std::string_view key, std::string_view reason) const {
  if (has(key)) fail(key, reason);
}

}  // namespace vug
