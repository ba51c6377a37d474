#pragma once
// The names of checkpoints, and the list of those in a folder.
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace vug::detail {

/// "step_000000000120.checkpoint".
std::string checkpoint_name(std::int64_t step);

/// Whether a file has the name of a checkpoint.
bool is_checkpoint_name(const std::filesystem::path& path);

/// Paths in a folder with the name of a checkpoint, newest first: the names sort by step. Empty where the folder does
/// not exist. Throws FileError where it cannot be read: if it counted as empty, a run could begin anew over an existing
/// one.
std::vector<std::filesystem::path> checkpoints(const std::string& directory);

/// Likewise those of checkpoints that a process began to write and did not finish.
std::vector<std::filesystem::path> unfinished_checkpoints(const std::string& directory);

}  // namespace vug::detail
