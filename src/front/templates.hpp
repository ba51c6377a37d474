#pragma once
// `vug new` and `vug --cite`.
#include <string>

namespace vug {

/// Writes the template of that name to `path` (<name>.toml if empty) and returns the path. Throws InputError when there
/// is no such template or the file exists already, FileError.
std::string new_case(const std::string& name, std::string path);

/// How to cite vug: the text of CITATION.cff (YAML).
std::string citation_text();

}  // namespace vug
