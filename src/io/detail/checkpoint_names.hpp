#pragma once
// The names of checkpoints, and which there are.
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace vug::detail {

/// "step_000000000120.checkpoint".
std::string checkpoint_name(std::int64_t step);

/// Whether a file has the name of a checkpoint.
bool is_checkpoint_name(const std::filesystem::path& path);

/// What has the name of a checkpoint in a folder, newest first: the names sort by step. Empty where there is no folder;
/// throws FileError where it cannot be read: whoever took it for one without checkpoints would begin anew where a run
/// lies.
std::vector<std::filesystem::path> checkpoints(const std::string& directory);

}  // namespace vug::detail
