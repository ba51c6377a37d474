// One overload per type of variable that a key can fill.
#include "io/detail/toml_cursor.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace vug {
namespace {

std::string quoted(const std::string& text) {
  return text.empty() ? "\"\"" : fmt::format("\"{}\"", text);
}

}  // namespace

void TomlCursor::read(std::string_view key, double& value, Unit unit, Range range) const {
  const auto* found =
      look_up({std::string(key), "number", std::string(unit.symbol), fmt::format("{:g}", value), range.text()});
  if (found != nullptr) value = number(*found, inside(key), unit, range);
}

void TomlCursor::read(std::string_view key, Point& value, Unit unit, Range range) const {
  const auto* found = look_up({std::string(key), "two numbers", std::string(unit.symbol),
                               fmt::format("[{:g}, {:g}]", value[0], value[1]), range.text()});
  if (found == nullptr) return;
  const auto& array = array_of(*found, inside(key), 2, "an array of two numbers, [x, y]");
  for (std::size_t i = 0; i < 2; ++i) {
    value[i] = number(*array.get(i), fmt::format("{}.{}", inside(key), i), unit, range);
  }
}

void TomlCursor::read(std::string_view key, std::array<double, 3>& value, Unit unit, Range range) const {
  const auto* found = look_up({std::string(key), "three numbers", std::string(unit.symbol),
                               fmt::format("[{:g}, {:g}, {:g}]", value[0], value[1], value[2]), range.text()});
  if (found == nullptr) return;
  const auto& array = array_of(*found, inside(key), 3, "an array of three numbers");
  for (std::size_t i = 0; i < 3; ++i)
    value[i] = number(*array.get(i), fmt::format("{}.{}", inside(key), i), unit, range);
}

void TomlCursor::read(std::string_view key, std::vector<Point>& value, Unit unit, Range range) const {
  const auto* found = look_up({std::string(key), "list of points", std::string(unit.symbol), "-", range.text()});
  if (found == nullptr) return;
  value.clear();
  const auto& array = array_of(*found, inside(key), 0, "a list of points, [[x, y], [x, y], ...]");
  for (std::size_t i = 0; i < array.size(); ++i) {
    const std::string name = fmt::format("{}.{}", inside(key), i);
    const auto& pair = array_of(*array.get(i), name, 2, "a point, [x, y]");
    value.push_back({number(*pair.get(0), name + ".0", unit, range), number(*pair.get(1), name + ".1", unit, range)});
  }
}

std::vector<std::vector<double>> TomlCursor::rows(const toml::node& node, const std::string& key, std::size_t columns,
                                                  Unit along, Unit unit, Range range, std::string_view expected) const {
  std::vector<std::vector<double>> table;
  const auto& array = array_of(node, key, 0, expected);
  if (array.empty()) document_->fail(key, fmt::format("must be {}", expected));
  for (std::size_t i = 0; i < array.size(); ++i) {
    const std::string name = fmt::format("{}.{}", key, i);
    const auto& row = array_of(*array.get(i), name, columns, expected);
    std::vector<double> numbers{number(*row.get(0), name + ".0", along, range::not_negative)};
    for (std::size_t k = 1; k < columns; ++k)
      numbers.push_back(number(*row.get(k), fmt::format("{}.{}", name, k), unit, range));
    if (!table.empty() && numbers[0] <= table.back()[0])
      document_->fail(name + ".0", fmt::format("{} must be larger than that of the row before", along.symbol));
    table.push_back(std::move(numbers));
  }
  return table;
}

TimeTable TomlCursor::time_table(const toml::node& node, const std::string& key, Unit unit, Range range) const {
  if (!node.is_array()) return number(node, key, unit, range);
  std::vector<double> time, value;
  for (const auto& row :
       rows(node, key, 2, unit::second, unit, range, "a number or a table over time, [[s, value], ...]")) {
    time.push_back(row[0]);
    value.push_back(row[1]);
  }
  return {time, value};
}

void TomlCursor::read(std::string_view key, TimeTable& value, Unit unit, Range range) const {
  const auto* found = look_up(
      {std::string(key), "number or table", std::string(unit.symbol), fmt::format("{:g}", value.at(0)), range.text()});
  if (found != nullptr) value = time_table(*found, inside(key), unit, range);
}

void TomlCursor::read(std::string_view key, std::array<TimeTable, 2>& value, Unit unit, Range range) const {
  const auto* found = look_up({std::string(key), "two numbers or table", std::string(unit.symbol),
                               fmt::format("[{:g}, {:g}]", value[0].at(0), value[1].at(0)), range.text()});
  if (found == nullptr) return;
  const char* const expected = "an array of two numbers, [x, y], or a table over time, [[s, x, y], ...]";
  const auto* array = found->as_array();
  if (array != nullptr && !array->empty() && array->get(0)->is_array()) {
    std::vector<double> time, x, y;
    for (const auto& row : rows(*found, inside(key), 3, unit::second, unit, range, expected)) {
      time.push_back(row[0]);
      x.push_back(row[1]);
      y.push_back(row[2]);
    }
    value = {TimeTable(time, x), TimeTable(time, y)};
    return;
  }
  const auto& pair = array_of(*found, inside(key), 2, expected);
  for (std::size_t i = 0; i < 2; ++i)
    value[i] = number(*pair.get(i), fmt::format("{}.{}", inside(key), i), unit, range);
}

void TomlCursor::read_curve(std::string_view key, std::vector<Point>& value, Unit along, Unit unit, Range range) const {
  const auto* found = look_up({std::string(key), "table", std::string(unit.symbol), "-", range.text()});
  if (found == nullptr) return;
  value.clear();
  for (const auto& row :
       rows(*found, inside(key), 2, along, unit, range, fmt::format("a table, [[{}, value], ...]", along.symbol)))
    value.push_back({row[0], row[1]});
}

void TomlCursor::read(std::string_view key, int& value, Range range) const {
  const auto* found = look_up({std::string(key), "whole number", "1", fmt::format("{}", value), range.text()});
  if (found != nullptr) value = whole_int(*found, inside(key), range);
}

void TomlCursor::read(std::string_view key, std::int64_t& value, Range range) const {
  const auto* found = look_up({std::string(key), "whole number", "1", fmt::format("{}", value), range.text()});
  if (found != nullptr) value = whole(*found, inside(key), range);
}

void TomlCursor::read(std::string_view key, std::uint64_t& value) const {
  const auto* found = look_up({std::string(key), "whole number", "1", fmt::format("{}", value), ">= 0"});
  if (found != nullptr) value = static_cast<std::uint64_t>(whole(*found, inside(key), range::not_negative));
}

void TomlCursor::read(std::string_view key, std::array<int, 2>& value, Range range) const {
  const auto* found =
      look_up({std::string(key), "two whole numbers", "1", fmt::format("[{}, {}]", value[0], value[1]), range.text()});
  if (found == nullptr) return;
  const auto& array = array_of(*found, inside(key), 2, "an array of two whole numbers");
  for (std::size_t i = 0; i < 2; ++i) value[i] = whole_int(*array.get(i), fmt::format("{}.{}", inside(key), i), range);
}

void TomlCursor::read(std::string_view key, bool& value) const {
  const auto* found = look_up({std::string(key), "true or false", "", value ? "true" : "false", ""});
  if (found == nullptr) return;
  if (!found->is_boolean()) fail(key, "must be true or false");
  value = found->as_boolean()->get();
}

void TomlCursor::read(std::string_view key, std::string& value) const {
  const auto* found = look_up({std::string(key), "text", "", quoted(value), ""});
  if (found == nullptr) return;
  if (!found->is_string()) fail(key, "must be text in quotes");
  value = found->as_string()->get();
}

void TomlCursor::read(std::string_view key, std::vector<std::string>& value) const {
  const auto* found = look_up({std::string(key), "list of text", "", value.empty() ? "[]" : "-", ""});
  if (found == nullptr) return;
  const auto& array = array_of(*found, inside(key), 0, "a list of texts");
  value.clear();
  for (std::size_t i = 0; i < array.size(); ++i) {
    const auto* text = array.get(i)->as_string();
    if (text == nullptr) document_->fail(fmt::format("{}.{}", inside(key), i), "must be text in quotes");
    value.push_back(text->get());
  }
}

void TomlCursor::read(std::string_view key, std::vector<std::int64_t>& value) const {
  const auto* found = look_up({std::string(key), "list of whole numbers", "1", value.empty() ? "[]" : "-", "any"});
  if (found == nullptr) return;
  const auto& array = array_of(*found, inside(key), 0, "a list of whole numbers");
  value.clear();
  for (std::size_t i = 0; i < array.size(); ++i)
    value.push_back(whole(*array.get(i), fmt::format("{}.{}", inside(key), i), range::any));
}

}  // namespace vug
