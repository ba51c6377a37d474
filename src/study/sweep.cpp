#include "study/sweep.hpp"

#include "base/require.hpp"
#include "host/interruption.hpp"
#include "host/this_process.hpp"
#include "io/detail/files.hpp"
#include "io/run_folder.hpp"
#include "study/members.hpp"
#include "study/pool.hpp"
#include "study/table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <sys/file.h>
#include <unistd.h>

namespace vug {

namespace {

namespace fs = std::filesystem;

void make_directory(const std::string& path) {
  std::error_code error;
  fs::create_directories(path, error);
  if (error) throw FileError(fmt::format("{}: cannot make the folder: {}", path, error.message()));
}

/// Lock for one sweep at a time in a directory. The runs of a sweep hold it too: if a sweep was killed, the next one
/// waits for those runs that are still writing their checkpoints.
class SweepLock {
 public:
  SweepLock(const std::string& directory, const SweepOptions& options)
      : descriptor_(::open((directory + "/sweep.lock").c_str(), O_RDWR | O_CREAT, 0666)) {
    if (descriptor_ < 0) detail::throw_file_error(directory + "/sweep.lock", "open");
    if (::flock(descriptor_, LOCK_EX | LOCK_NB) == 0) return;
    if (errno != EWOULDBLOCK) {
      if (options.warnings)
        *options.warnings << fmt::format("warning: {}: cannot be locked ({}): see to it that no other sweep runs there",
                                         directory, std::strerror(errno))
                          << std::endl;
      return;
    }
    if (options.only_table) return;  // the files that it writes are complete in any case
    if (options.progress) *options.progress << "waiting for another sweep of " << directory << " to end" << std::endl;
    while (::flock(descriptor_, LOCK_EX) != 0 && errno == EINTR) {
    }
  }
  SweepLock(const SweepLock&) = delete;
  SweepLock& operator=(const SweepLock&) = delete;
  ~SweepLock() { ::close(descriptor_); }

 private:
  int descriptor_;
};

std::vector<std::string> words_of(const Study& study, const Member& member) {
  std::vector<std::string> words = {this_program(), "run",     study.case_path, "-o", member.directory,
                                    "--resume",     "--quiet", "--threads",     "1"};
  for (const std::string& entry : member.overrides) {
    words.emplace_back("--set");
    words.push_back(entry);
  }
  return words;
}

/// The members that still have to be run. Throws InputError where the directory contains something else.
std::vector<const Member*> open_members(const std::vector<Member>& members, const std::string& directory, bool resume) {
  std::vector<const Member*> open;
  for (const Member& member : members) {
    const MemberState state = state_of(member);
    if (state == MemberState::other_case)
      throw InputError(fmt::format("{}: holds a run of another study; -o DIR leaves it alone", member.directory));
    if (state != MemberState::missing && !resume)
      throw InputError(fmt::format("{}: holds a study; --resume continues it, -o DIR leaves it alone", directory));
    if (state == MemberState::missing || state == MemberState::unfinished) open.push_back(&member);
  }
  return open;
}

/// Files that a sweep writes beside its runs.
constexpr const char *copy_of_study = "study.toml", *table = "table.csv", *failures = "failures.csv";

/// Throws InputError where the folder contains files of these names that were written by no sweep, or by another one.
void require_own_files(const Study& study, const std::vector<Member>& members, const std::string& directory,
                       bool resume) {
  const bool begun = std::any_of(members.begin(), members.end(),
                                 [](const Member& member) { return state_of(member) != MemberState::missing; });
  const bool swept = begun || fs::exists(directory + "/sweep.lock");
  if (swept && resume) return;
  for (const char* name : {copy_of_study, table, failures}) {
    const std::string path = directory + "/" + name;
    if (!fs::exists(fs::symlink_status(path))) continue;
    if (swept)
      throw InputError(fmt::format("{}: holds a study; --resume continues it, -o DIR leaves it alone", directory));
    if (name == copy_of_study && fs::is_regular_file(path) && detail::read_file(path) == study.text) continue;
    throw InputError(fmt::format("{}: is in the way, and no sweep wrote it; choose another folder with -o DIR", path));
  }
}

std::string said_of(const Ended& ended, const Member& member, const Study& study) {
  std::string line =
      fmt::format("run {} {}", member.name, ended.code == 0 ? "done" : fmt::format("failed ({})", ended.code));
  for (std::size_t k = 0; k < study.keys.size(); ++k)
    line += fmt::format(", {} = {}", study.keys[k].key, member.values[k]);
  return line + fmt::format(", {:.3g} s", ended.seconds);
}

/// Writes table.csv and failures.csv; returns how many members are not done.
int write_tables(const Study& study, const std::vector<Member>& members, const std::string& directory) {
  detail::replace_file(directory + "/" + table, table_text(study, members), false);
  detail::replace_file(directory + "/" + failures, failures_text(study, members), false);
  return static_cast<int>(std::count_if(members.begin(), members.end(),
                                        [](const Member& member) { return state_of(member) != MemberState::done; }));
}

}  // namespace

std::string directory_of(const std::string& study, const SweepOptions& options) {
  return options.directory.empty() ? results_directory(study) : options.directory;
}

int sweep(const std::string& path, const SweepOptions& options) {
  const Study study = read_study(path);
  const std::string directory = directory_of(path, options);
  const std::vector<Member> members = members_of(study, directory);
  const bool go_on = options.resume || options.only_table;
  open_members(members, directory, go_on);  // checks before anything is written
  require_own_files(study, members, directory, go_on);
  if (options.only_table && !fs::exists(directory + "/runs"))
    throw InputError(directory + ": holds no study of which there could be a table");
  make_directory(directory + "/runs");
  const SweepLock lock(directory, options);
  const StopsInOrder in_order;  // also while the table is made after the last run
  const std::vector<const Member*> open = open_members(members, directory, go_on);
  for (const Member& member : members) look_at_columns(study, member);  // of earlier runs
  detail::replace_file(directory + "/" + copy_of_study, study.text, false);
  if (options.only_table) return write_tables(study, members, directory);
  std::vector<Job> jobs;
  for (const Member* member : open) jobs.push_back({words_of(study, *member), member->log});
  std::size_t ended = members.size() - open.size();
  const int at_once = options.at_once > 0 ? options.at_once : processors();
  if (options.progress)
    *options.progress << fmt::format("{} runs, {} of them to do, {} at once", members.size(), open.size(), at_once)
                      << std::endl;
  const auto tell = [&](const Ended& job) {
    ++ended;
    if (options.progress)
      *options.progress << fmt::format("[{}/{}] {}", ended, members.size(), said_of(job, *open[job.job], study))
                        << std::endl;
  };
  // checked as soon as a run has begun, not when all have ended
  run_jobs(jobs, at_once, tell, [&](std::size_t job) { return look_at_columns(study, *open[job]); });
  const int not_done = write_tables(study, members, directory);
  say_when_ended("interrupted when the study was done");
  if (stop_requested()) throw Interrupted(stop_reason() + "; --resume continues the study");
  return not_done;
}

void become_member(const std::string& path, const SweepOptions& options, int number) {
  const Study study = read_study(path);
  const std::string directory = directory_of(path, options);
  const std::vector<Member> members = members_of(study, directory);
  if (number < 0 || static_cast<std::size_t>(number) >= members.size())
    throw InputError(
        fmt::format("{}: has {} runs, counted from 0; --member {} is none of them", path, members.size(), number));
  make_directory(directory + "/runs");
  std::vector<std::string> words = words_of(study, members[number]);
  std::vector<char*> pointers;
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  const int log = ::open(members[number].log.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0666);
  if (log < 0) detail::throw_file_error(members[number].log, "open");
  ::dup2(log, STDOUT_FILENO);
  ::dup2(log, STDERR_FILENO);
  ::execv(pointers[0], pointers.data());
  throw FileError(fmt::format("{}: cannot run it: {}", words[0], std::strerror(errno)));
}

}  // namespace vug
