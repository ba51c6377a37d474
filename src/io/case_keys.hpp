#pragma once
// The keys of the case file as the reader knows them.
#include <string>
#include <string_view>
#include <vector>

namespace vug {

struct KeyDescription {
  std::string key;       ///< full path; elements of arrays as N, sides as <side>, free names as <name>
  std::string type;      ///< "number", "whole number", "text", "word", "true or false", "table", ...
  std::string unit;      ///< SI, "1" where there is none, empty where the value is not a number
  std::string fallback;  ///< default, "required", or "-" where the key has no value when it is absent
  std::string range;     ///< "> 0", or the list of allowed words
};

/// Every key that can be read, in the order of reading.
const std::vector<KeyDescription>& case_keys();

/// Whether a table may be given either once or, in double brackets, several times.
constexpr bool may_repeat(std::string_view table) {
  return table == "boundary.injection";
}

}  // namespace vug
