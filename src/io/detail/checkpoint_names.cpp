#include "io/detail/checkpoint_names.hpp"

#include "base/require.hpp"
#include "io/detail/step_names.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace vug::detail {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view extension = ".checkpoint";

/// The paths in a folder that are `wanted`, the last name first; none where there is no folder.
template <class Wanted>
std::vector<fs::path> paths_of(const std::string& directory, const Wanted& wanted) {
  std::vector<fs::path> paths;
  std::error_code error;
  if (fs::symlink_status(directory, error).type() == fs::file_type::not_found) return paths;
  fs::directory_iterator entry;
  if (!error) entry = fs::directory_iterator(directory, error);
  for (; !error && entry != fs::directory_iterator(); entry.increment(error))
    if (wanted(entry->path())) paths.push_back(entry->path());
  if (error) throw FileError(fmt::format("{}: cannot look for checkpoints: {}", directory, error.message()));
  std::sort(paths.rbegin(), paths.rend());
  return paths;
}

}  // namespace

std::string checkpoint_name(std::int64_t step) {
  return fmt::format("{}{}", step_name(step), extension);
}

bool is_checkpoint_name(const fs::path& path) {
  return path.extension() == extension && is_step_name(path.stem().string());
}

std::vector<fs::path> checkpoints(const std::string& directory) {
  return paths_of(directory, is_checkpoint_name);
}

std::vector<fs::path> unfinished_checkpoints(const std::string& directory) {
  return paths_of(directory,
                  [](const fs::path& path) { return path.extension() == ".tmp" && is_checkpoint_name(path.stem()); });
}

}  // namespace vug::detail
