#include "front/templates.hpp"

#include "base/require.hpp"
#include "front/embedded.hpp"
#include "io/detail/files.hpp"

#include <fmt/format.h>

#include <filesystem>

namespace vug {

std::string new_case(const std::string& name, std::string path) {
  std::string names;
  if (path.empty()) path = name + ".toml";
  for (const Template& candidate : templates()) {
    names += (names.empty() ? "" : ", ") + candidate.name;
    if (candidate.name != name) continue;
    if (std::filesystem::exists(std::filesystem::symlink_status(path)))
      throw InputError(path + ": is there already; give another name");
    detail::replace_file(path, candidate.text, false);
    return path;
  }
  throw InputError(fmt::format("there is no template \"{}\"; there are {}", name, names));
}

std::string citation_text() {
  return citation();
}

}  // namespace vug
