#pragma once
// The runs of a study: what each is given, and what has become of it.
#include "study/study.hpp"

#include <string>
#include <vector>

namespace vug {

struct Member {
  std::string name;                    ///< "0001"
  std::string directory;               ///< of its run
  std::string log;                     ///< file with what it has said
  std::vector<std::string> values;     ///< of the keys of the study
  std::vector<std::string> overrides;  ///< for --set
  std::string hash;                    ///< of its case (io/run_record.hpp)
};

/// The members of a study whose results go to `directory`; each case is read. Throws InputError naming the member whose
/// case is none.
std::vector<Member> members_of(const Study& study, const std::string& directory);

enum class MemberState { missing, unfinished, done, diverged, other_case };
/// What run.json says of a member.
MemberState state_of(const Member& member);

}  // namespace vug
