#pragma once
// Files of the project that the program carries with it.
#include <string>
#include <vector>

namespace vug {

struct Template {
  std::string name, text;
};

/// Cases to begin with.
const std::vector<Template>& templates();

/// CITATION.cff.
const char* citation();

}  // namespace vug
