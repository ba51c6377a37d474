#pragma once
// Results of the members of a study, one row each.
#include "study/members.hpp"

#include <string>
#include <vector>

namespace vug {

/// Whether the history of a member has columns already. Throws InputError where a result that the study asks for is not
/// one of them.
bool look_at_columns(const Study& study, const Member& member);

/// Rows of the members that are done, in the order of the study: name, values of the keys, and values of the last row
/// of the history. Its columns are the study's results or, if it names none, all of the first history. Throws
/// InputError for a result that is no column of a history, FileError.
std::string table_text(const Study& study, const std::vector<Member>& members);

/// Rows of the other members: name, values of the keys, state, last line of their output.
std::string failures_text(const Study& study, const std::vector<Member>& members);

}  // namespace vug
