// Checks every name in a case against the keys that the reader knows.
#include "base/require.hpp"
#include "io/case_keys.hpp"
#include "io/detail/case_checks.hpp"
#include "io/detail/nearest_name.hpp"
#include "io/message.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace vug {
namespace {

/// Known names in each documented table: "lattice" -> size, spacing, time_step. Leaves have no entry of their own.
using NameTree = std::map<std::string, std::vector<std::string>>;

NameTree name_tree() {
  NameTree tree;
  for (const KeyDescription& known : case_keys()) {
    std::string parent;
    for (const std::string& name : split_key(known.key)) {
      auto& names = tree[parent];
      if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
      parent += (parent.empty() ? "" : ".") + name;
    }
  }
  return tree;
}

std::vector<std::string> spelled_out(const std::vector<std::string>& names) {
  std::vector<std::string> result;
  for (const std::string& name : names) {
    if (name == "<side>") {
      result.insert(result.end(), {"left", "right", "bottom", "top"});
    } else if (name.front() != '<') {
      result.push_back(name);
    }
  }
  return result;
}

/// Documented form of `name` in a table with the known `names`, such as "<side>" for "left"; empty if unknown.
std::string documented_name(const std::string& name, const std::vector<std::string>& names) {
  const auto known = spelled_out(names);
  if (std::find(known.begin(), known.end(), name) != known.end()) {
    return std::find(names.begin(), names.end(), name) != names.end() ? name : "<side>";
  }
  const auto wildcard =
      std::find_if(names.begin(), names.end(), [](const auto& n) { return n.front() == '<' && n != "<side>"; });
  return wildcard != names.end() ? *wildcard : "";
}

/// The table of this name, or another table that has a key of this name, for a key in the wrong table.
std::string elsewhere(const std::string& name, const NameTree& tree) {
  if (const auto own = tree.find(name); own != tree.end()) {
    const bool repeated = own->second.front() == "N";
    return fmt::format(" ({0}{1}{2} is a table of its own)", repeated ? "[[" : "[", name, repeated ? "]]" : "]");
  }
  for (const auto& [table, names] : tree) {
    if (!table.empty() && std::find(names.begin(), names.end(), name) != names.end()) {
      return fmt::format(" (table \"{}\" has a key of this name)", table);
    }
  }
  return "";
}

std::string position(const TomlDocument& document, const std::string& key, const toml::key& name) {
  const auto& begin = name.source().begin;
  const std::string where = document.where(key);
  return begin && !where.starts_with("--set") ? fmt::format("{}:{}:{}", document.path(), begin.line, begin.column)
                                              : where;
}

struct NameCheck {
  const TomlDocument& document;
  NameTree tree = name_tree();

  void table(const toml::table& table, const std::string& path, const std::string& documented) const {
    const auto& names = tree.at(documented);
    for (const auto& [name, node] : table) {
      const std::string own(name.str());
      const std::string key = path.empty() ? own : path + "." + own;
      const std::string known = documented_name(own, names);
      if (known.empty()) unknown(key, own, name, names, documented);
      const std::string inner = documented.empty() ? known : documented + "." + known;
      value(node, key, inner);
    }
  }

  void value(const toml::node& node, const std::string& key, const std::string& documented) const {
    const auto below = tree.find(documented);
    if (below == tree.end()) return;  // a plain key: its reader checks the type
    if (below->second.front() == "N") return elements(node, key, documented + ".N");
    if (node.is_array() && may_repeat(documented)) return elements(node, key, documented);
    if (!node.is_table()) document.fail(key, fmt::format("must be a table, [{}]", key));
    table(*node.as_table(), key, documented);
  }

  void elements(const toml::node& node, const std::string& key, const std::string& documented) const {
    const auto* array = node.as_array();
    if (array == nullptr)
      document.fail_at(key, fmt::format("{} must be an array of tables, each begun by [[{}]]", key, key));
    for (std::size_t i = 0; i < array->size(); ++i) {
      const std::string element = fmt::format("{}.{}", key, i);
      if (!array->get(i)->is_table()) document.fail(element, fmt::format("must be a table, begun by [[{}]]", key));
      table(*array->get(i)->as_table(), element, documented);
    }
  }

  [[noreturn]] void unknown(const std::string& key, const std::string& own, const toml::key& name,
                            const std::vector<std::string>& names, const std::string& documented) const {
    const auto valid = spelled_out(names);
    const std::string what = documented.empty() ? "table" : "key";
    const std::string shown_key = excerpt(key, 100);
    const bool study = documented.empty() && own == "study";
    const std::string hint = study ? "; `vug sweep` runs a study" : suggestion(own, valid) + elsewhere(own, tree);
    throw InputError(
        one_line(fmt::format("{}: unknown {} \"{}\"{}", position(document, key, name), what, shown_key, hint)));
  }
};

}  // namespace

void check_names(const TomlDocument& document) {
  NameCheck{document}.table(document.root(), "", "");
}

}  // namespace vug
