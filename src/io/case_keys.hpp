#pragma once
// The keys of the case file as the reader knows them.
#include <string>
#include <string_view>
#include <vector>

namespace vug {

struct KeyDescription {
  std::string key;       ///< full path; elements of arrays as N, sides as <side>, free names as <name>
  std::string type;      ///< "number", "whole number", "text", "word", "true or false", "table", ...
  std::string unit;      ///< SI, "1" where there is none, empty for what is no number
  std::string fallback;  ///< default, "required", or "-" where absence has a meaning of its own
  std::string range;     ///< "> 0", or the words to choose from
};

/// Every key that can be read, in the order of reading.
const std::vector<KeyDescription>& case_keys();

/// Whether a table may be given once or, in double brackets, several times.
constexpr bool may_repeat(std::string_view table) {
  return table == "boundary.injection";
}

}  // namespace vug
