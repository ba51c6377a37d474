#pragma once
// A case file as TOML, with the overrides of the command line applied. It knows where each value was written.
#include <toml++/toml.h>

#include <string>
#include <string_view>
#include <vector>

namespace vug {

/// Path and text of a value given on the command line.
struct Override {
  std::string key;   ///< "lattice.spacing", array elements by number: "solute.species.0.name"
  std::string text;  ///< as typed, "lattice.spacing=1e-4"
};

class TomlDocument {
 public:
  /// Parses the text and applies the overrides. Throws InputError that names line and column, or the override.
  TomlDocument(const std::string& text, std::string path, const std::vector<std::string>& overrides);

  const toml::table& root() const { return root_; }
  const std::string& path() const { return path_; }

  /// The node at a dotted key path (numbers index arrays), or null.
  const toml::node* find(std::string_view key) const;

  /// "file:line:column" of a key, of the nearest enclosing table when it is absent, or the override that set it.
  std::string where(std::string_view key) const;

  /// Throws InputError "where: key = value problem"; the value is included only where it is not a table or list.
  [[noreturn]] void fail(std::string_view key, std::string_view problem) const;
  /// Throws InputError "where: message".
  [[noreturn]] void fail_at(std::string_view key, std::string_view message) const;

 private:
  toml::table root_;
  std::string path_;
  std::vector<Override> overrides_;
};

/// Splits "key=value", checks its form and writes the value into `root`; missing tables are added.
Override apply_override(toml::table& root, const std::string& text);

/// The segments of a dotted key.
std::vector<std::string> split_key(std::string_view key);

/// A value as it may appear in a message: at most 60 characters, on one line.
std::string shown(const toml::node& node);

}  // namespace vug
