#pragma once
// Writing files so that a reader finds the old one or the new one, never half of either.
#include <string>
#include <string_view>
#include <vector>

namespace vug::detail {

/// Throws FileError: `path: cannot <action>: <reason of errno>`.
[[noreturn]] void throw_file_error(const std::string& path, const std::string& action);

/// Makes the folder and those above it.
void make_directories(const std::string& path);

/// Writes `parts`, one after the other, under a temporary name beside `path` and renames it. With `sync` the data
/// and the new name have reached the disk before it returns.
void replace_file(const std::string& path, const std::vector<std::string_view>& parts, bool sync);

/// The whole file.
std::string read_file(const std::string& path);

}  // namespace vug::detail
