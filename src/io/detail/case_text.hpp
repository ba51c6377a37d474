#pragma once
// The text of a case file, before it is parsed as TOML.
#include <string>

namespace vug {

/// The whole file. Throws InputError when there is no such file or it is too large, FileError when it cannot be opened
/// or read.
std::string read_case_text(const std::string& path);

/// Throws InputError when `text` is empty or not text.
void check_text(const std::string& text, const std::string& path);

}  // namespace vug
