#pragma once
// What the members of a study have found, one row each.
#include "study/members.hpp"

#include <string>
#include <vector>

namespace vug {

/// Whether the history of a member has columns already. Throws InputError where the study wants a result that is none.
bool look_at_columns(const Study& study, const Member& member);

/// Rows of the members that are done, in the order of the study: name, values of the keys, and the last row of each
/// history, copied as it stands there; the columns of the study's results, or else all of the first history. Throws
/// InputError for a result that is no column of a history, FileError.
std::string table_text(const Study& study, const std::vector<Member>& members);

/// Rows of the others: name, values of the keys, what state they are in, the last line that they have said.
std::string failures_text(const Study& study, const std::vector<Member>& members);

}  // namespace vug
