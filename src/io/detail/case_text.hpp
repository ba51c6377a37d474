#pragma once
// The bytes of a case file, before they are TOML.
#include <string>

namespace vug {

/// The whole file. Throws InputError when it is not there, no file or not permitted, FileError when reading it fails.
std::string read_case_text(const std::string& path);

/// Throws InputError when `text` is empty or no text.
void check_text(const std::string& text, const std::string& path);

}  // namespace vug
