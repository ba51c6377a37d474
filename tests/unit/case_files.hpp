#pragma once
// What the tests of the case reader share.
#include "io/scene.hpp"
#include "kernels/base/require.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

namespace vug::testing_cases {

inline std::string bytes_of(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

inline std::vector<std::filesystem::path> cases_in(const std::string& folder) {
  std::vector<std::filesystem::path> paths;
  for (const auto& entry : std::filesystem::directory_iterator(std::string(VUG_SOURCE_DIR) + "/" + folder)) {
    if (entry.path().extension() == ".toml") paths.push_back(entry.path());
  }
  std::sort(paths.begin(), paths.end());
  return paths;
}

/// The message of the InputError that a case causes, empty when it is accepted.
inline std::string refusal(const std::string& text, const std::string& path,
                           const std::vector<std::string>& overrides = {}) {
  try {
    parse_scene(text, path, overrides);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

}  // namespace vug::testing_cases
