#pragma once
// Names that a case may give.
#include "io/detail/toml_cursor.hpp"

#include <fmt/format.h>

#include <string>
#include <vector>

namespace vug {

/// Whether a name can be part of a data set's name and of `--set`.
bool is_plain_name(const std::string& name);
/// The rule of is_plain_name, for messages.
inline constexpr const char* plain_name_rule =
    "must begin with a letter and hold at most 40 letters, digits, '_', '+' or '-'";

/// Refuses the name of an element of a list, such as a "gauge", that is not plain or that an earlier element has.
template <class Element>
void check_name(const TomlCursor& table, const std::string& name, const std::vector<Element>& earlier,
                const char* what) {
  if (table.describing()) return;
  if (!is_plain_name(name)) table.fail("name", plain_name_rule);
  for (const Element& other : earlier)
    if (other.name == name) table.fail("name", fmt::format("is the name of an earlier {}", what));
}

}  // namespace vug
