#pragma once
// The bytes of a case file, before they are TOML.
#include <string>

namespace vug {

/// The whole file. Throws InputError when there is no such file or it is too large, FileError when it cannot be opened
/// or read.
std::string read_case_text(const std::string& path);

/// Throws InputError when `text` is empty or no text.
void check_text(const std::string& text, const std::string& path);

}  // namespace vug
