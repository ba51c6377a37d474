#pragma once
// `vug schema`: the keys of the case file for editors.
#include <string>

namespace vug {

/// A JSON schema (draft 7) of the case file, made from the keys that the reader knows.
std::string case_schema();

}  // namespace vug
