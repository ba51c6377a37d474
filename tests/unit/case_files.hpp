#pragma once
// What the tests of the case reader share.
#include "base/require.hpp"
#include "io/scene.hpp"

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

/// A case of the project, with other values for some keys.
inline Scene shipped(const std::string& name, const std::vector<std::string>& overrides = {}) {
  return read_scene(VUG_SOURCE_DIR "/cases/" + name, overrides);
}

/// The least that flows; what follows are further tables.
inline const std::string open_flow = R"([lattice]
size = [0.01, 0.02]
spacing = 1e-3
time_step = 1e-4
[time]
steps = 10
[flow]
viscosity = 1e-3
)";

inline Scene parsed(const std::string& more, const std::vector<std::string>& overrides = {}) {
  return parse_scene(open_flow + more, "a.toml", overrides);
}

}  // namespace vug::testing_cases
