#pragma once
// Checks the fields that a case requests against those that exist.
#include "io/field_list.hpp"

#include <string>
#include <vector>

namespace vug {

/// Throws InputError for a name in `names` (output.fields) that no list has.
void require_fields(const FieldList& fields, const std::vector<std::string>& names);

}  // namespace vug
