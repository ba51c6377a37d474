#include "study/members.hpp"

#include "base/require.hpp"
#include "io/run_folder.hpp"
#include "io/run_record.hpp"
#include "io/scene.hpp"

#include <fmt/format.h>

#include <map>

namespace vug {

std::vector<Member> members_of(const Study& study, const std::string& directory) {
  std::vector<Member> members;
  std::map<std::string, InputFile> digests;  // of files that several members name
  for (const auto& values : sample(study)) {
    Member member;
    member.name = fmt::format("{:04}", members.size() + 1);
    member.directory = fmt::format("{}/runs/{}", directory, member.name);
    member.log = fmt::format("{}/runs/{}.log", directory, member.name);
    member.values = values;
    member.overrides = study.overrides;
    for (std::size_t k = 0; k < study.keys.size(); ++k)
      member.overrides.push_back(fmt::format("{}={}", study.keys[k].key, values[k]));
    try {
      const Scene scene = read_scene(study.case_path, member.overrides);
      if (scene.laboratory) throw InputError(study.case_path + ": describes a laboratory test; a study is of runs");
      std::vector<InputFile> inputs;
      for (const std::string& path : input_files(scene)) {
        if (!digests.contains(path)) digests[path] = digest_of_file(path);
        inputs.push_back(digests[path]);
      }
      member.hash = case_hash(scene.source_text, scene.overrides, inputs);
    } catch (const InputError& error) {
      throw InputError(fmt::format("{}: run {}: {}", study.path, member.name, error.what()));
    }
    members.push_back(std::move(member));
  }
  return members;
}

MemberState state_of(const Member& member) {
  const std::optional<RunSummary> run = read_run_summary(member.directory);
  if (!run) return MemberState::missing;
  if (run->case_hash != member.hash) return MemberState::other_case;
  if (run->status == "done") return MemberState::done;
  return run->status == "diverged" ? MemberState::diverged : MemberState::unfinished;
}

}  // namespace vug
