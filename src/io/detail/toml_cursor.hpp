#pragma once
// Reads the keys of one table of a case into variables that already hold their defaults, and checks type, unit and
// range. With a KeyLog it reads nothing and logs each key that is requested instead. The documentation and the search
// for misspelt keys use that list, so that keys are named in the reader only.
#include "io/case_keys.hpp"
#include "io/detail/range.hpp"
#include "io/detail/toml_document.hpp"
#include "io/time_table.hpp"

#include <array>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace vug {

using Point = std::array<double, 2>;
using KeyLog = std::vector<KeyDescription>;

class TomlCursor {
 public:
  explicit TomlCursor(const TomlDocument& document) : document_(&document), given_(true) {}
  /// A cursor that only describes its keys.
  explicit TomlCursor(KeyLog& log) : log_(&log), given_(true) {}

  /// Whether the table is in the case; always true while describing.
  bool given() const { return given_; }
  bool describing() const { return log_ != nullptr; }
  /// For instance "boundary.left".
  const std::string& path() const { return path_; }
  bool has(std::string_view key) const { return !describing() && given_ && document_->find(inside(key)) != nullptr; }

  /// The table `key` below this one; `documented` replaces its name in the documentation ("<side>").
  TomlCursor table(std::string_view key, std::string_view documented = {}) const;
  /// The elements of the array of tables `key`; one empty element while describing.
  std::vector<TomlCursor> tables(std::string_view key) const;
  /// The table `key`, or the elements of an array of tables of that name (see may_repeat).
  std::vector<TomlCursor> one_or_more(std::string_view key) const;
  /// Names and values of a table with free keys; `documented` is how such a key appears in the documentation.
  std::vector<std::pair<std::string, TimeTable>> named_numbers(std::string_view key, std::string_view documented,
                                                               Unit unit, Range range) const;

  void read(std::string_view key, double& value, Unit unit, Range range = range::any) const;
  /// Reads a number of a part, such as a material. Where the key is absent, `value` keeps the number of the whole.
  void read_own(std::string_view key, double& value, Unit unit, Range range) const {
    std::optional<double> own;
    read(key, own, unit, range);
    if (own) value = *own;
  }
  void read(std::string_view key, Point& value, Unit unit, Range range = range::any) const;
  void read(std::string_view key, std::array<double, 3>& value, Unit unit, Range range = range::any) const;
  void read(std::string_view key, std::vector<Point>& value, Unit unit, Range range = range::any) const;
  /// A number, or a table over time, [[s, value], ...].
  void read(std::string_view key, TimeTable& value, Unit unit, Range range = range::any) const;
  /// Two numbers, or a table over time, [[s, x, y], ...].
  void read(std::string_view key, std::array<TimeTable, 2>& value, Unit unit, Range range = range::any) const;
  /// A table of pairs whose first numbers ascend.
  void read_curve(std::string_view key, std::vector<Point>& value, Unit along, Unit unit, Range range) const;
  void read(std::string_view key, int& value, Range range) const;
  void read(std::string_view key, std::int64_t& value, Range range) const;
  void read(std::string_view key, std::uint64_t& value) const;
  void read(std::string_view key, std::array<int, 2>& value, Range range) const;
  void read(std::string_view key, bool& value) const;
  void read(std::string_view key, std::string& value) const;
  void read(std::string_view key, std::vector<std::string>& value) const;
  void read(std::string_view key, std::vector<std::int64_t>& value) const;
  /// A key without a default: where it is absent, `value` stays as it is.
  template <class Value, class... Arguments>
  void read(std::string_view key, std::optional<Value>& value, Arguments... arguments) const;

  template <class Value>
  using Choices = std::initializer_list<std::pair<std::string_view, Value>>;
  /// Reads one of a list of words.
  template <class Value>
  void choose(std::string_view key, Value& value, Choices<std::type_identity_t<Value>> choices) const;

  /// As `read` and `choose`, but the key is required.
  template <class Value, class... Arguments>
  void need(std::string_view key, Value& value, Arguments... arguments) const;
  template <class Value>
  void need_choice(std::string_view key, Value& value, Choices<std::type_identity_t<Value>> choices) const;

  /// As `read` and `need` where the key is `used`; elsewhere refuses it, for this reason.
  template <class Value, class... Arguments>
  void read_if(bool used, std::string_view key, std::string_view reason, Value& value, Arguments... arguments) const {
    used || describing() ? read(key, value, arguments...) : refuse(key, reason);
  }
  template <class Value, class... Arguments>
  void need_if(bool used, std::string_view key, std::string_view reason, Value& value, Arguments... arguments) const {
    used || describing() ? need(key, value, arguments...) : refuse(key, reason);
  }

  /// Refuses `key` where another choice makes it meaningless; `reason` as in "is only for type = \"pressure\"".
  void refuse(std::string_view key, std::string_view reason) const;
  [[noreturn]] void fail(std::string_view key, std::string_view problem) const {
    document_->fail(inside(key), problem);
  }
  /// Full path of a key, for messages and for checks between tables.
  std::string inside(std::string_view key) const;

 private:
  const toml::node* look_up(KeyDescription description) const;
  const toml::node* node(std::string_view key) const;
  /// Rows of numbers, the first of each in `along` and ascending, the others in `unit`.
  std::vector<std::vector<double>> rows(const toml::node& node, const std::string& key, std::size_t columns, Unit along,
                                        Unit unit, Range range, std::string_view expected) const;
  TimeTable time_table(const toml::node& node, const std::string& key, Unit unit, Range range) const;
  double number(const toml::node& node, const std::string& key, Unit unit, Range range) const;
  std::int64_t whole(const toml::node& node, const std::string& key, Range range) const;
  int whole_int(const toml::node& node, const std::string& key, Range range) const;
  std::string word(std::string_view key, const std::string& fallback, const std::vector<std::string>& words) const;
  const toml::array& array_of(const toml::node& node, const std::string& key, std::size_t size,
                              std::string_view expected) const;
  void require(std::string_view key) const;
  void mark_required() const;
  std::string documented(std::string_view key) const;

  const TomlDocument* document_ = nullptr;
  KeyLog* log_ = nullptr;
  std::string path_, documented_path_;
  bool given_ = false;
};

template <class Value>
void TomlCursor::choose(std::string_view key, Value& value, Choices<std::type_identity_t<Value>> choices) const {
  std::vector<std::string> words;
  std::string fallback;
  for (const auto& [name, meaning] : choices) {
    words.emplace_back(name);
    if (meaning == value) fallback = name;
  }
  const std::string chosen = word(key, fallback, words);
  for (const auto& [name, meaning] : choices) {
    if (name == chosen) value = meaning;
  }
}

template <class Value, class... Arguments>
void TomlCursor::read(std::string_view key, std::optional<Value>& value, Arguments... arguments) const {
  Value given{};
  read(key, given, arguments...);
  if (describing())
    log_->back().fallback = "-";
  else if (has(key))
    value = given;
}

template <class Value, class... Arguments>
void TomlCursor::need(std::string_view key, Value& value, Arguments... arguments) const {
  require(key);
  read(key, value, arguments...);
  mark_required();
}

template <class Value>
void TomlCursor::need_choice(std::string_view key, Value& value, Choices<std::type_identity_t<Value>> choices) const {
  require(key);
  choose(key, value, choices);
  mark_required();
}

}  // namespace vug
