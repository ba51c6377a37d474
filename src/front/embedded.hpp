#pragma once
// Files of the project that are built into the program.
#include <string>
#include <vector>

namespace vug {

struct Template {
  std::string name, text;
};

/// Templates of cases.
const std::vector<Template>& templates();

/// CITATION.cff.
const char* citation();

}  // namespace vug
