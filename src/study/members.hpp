#pragma once
// The runs of a study: their settings and their state.
#include "study/study.hpp"

#include <string>
#include <vector>

namespace vug {

struct Member {
  std::string name;                    ///< "0001"
  std::string directory;               ///< of its run
  std::string log;                     ///< file with its output
  std::vector<std::string> values;     ///< of the keys of the study
  std::vector<std::string> overrides;  ///< for --set
  std::string hash;                    ///< of its case (io/run_record.hpp)
};

/// The members of a study whose results go to `directory`; reads the case of each. Throws InputError with the name of a
/// member whose case is invalid.
std::vector<Member> members_of(const Study& study, const std::string& directory);

enum class MemberState { missing, unfinished, done, diverged, other_case };
/// State of a member according to its run.json.
MemberState state_of(const Member& member);

}  // namespace vug
