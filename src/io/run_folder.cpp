#include "io/run_folder.hpp"

#include "base/require.hpp"
#include "host/this_process.hpp"
#include "io/detail/checkpoint_names.hpp"
#include "io/detail/files.hpp"
#include "io/detail/step_names.hpp"
#include "io/run_record.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <sys/file.h>
#include <unistd.h>
#include <utility>
#include <vector>

namespace vug {

namespace {

namespace fs = std::filesystem;

/// How far a run came in whose folder nobody writes now: one that its record calls running was killed.
std::string state_of(const RunSummary& run) {
  return fmt::format("{} at step {}", run.status == "running" ? "unfinished" : run.status, run.steps);
}

/// The path without the ending of a file that is being written.
fs::path finished(const fs::path& path) {
  return path.extension() == ".tmp" ? path.parent_path() / path.stem() : path;
}

bool is_result(const fs::path& path) {
  for (const char* name : {"history.csv", "stress_strain.csv", "cracks.csv", "error_bars.csv", "fields.h5",
                           "fields.xdmf", "particles.h5", "particles.xdmf"})
    if (path.filename() == name) return true;
  return false;
}

bool is_snapshot(const fs::path& path) {
  return path.extension() == ".h5" && (path.stem() == "rock" || detail::is_step_name(path.stem().string()));
}

/// Files in a folder that a run has written, except run.json.
std::vector<fs::path> results_in(const std::string& folder) {
  std::vector<fs::path> found;
  const auto add = [&](const fs::path& where, bool (*own)(const fs::path&)) {
    std::error_code none;
    for (const auto& entry : fs::directory_iterator(where, none))
      if (own(finished(entry.path())) && !entry.is_directory(none)) found.push_back(entry.path());
  };
  add(folder + "/checkpoint", detail::is_checkpoint_name);
  add(folder + "/fields", is_snapshot);
  add(folder + "/particles", is_snapshot);
  add(folder, is_result);
  return found;
}

bool is_run(const std::string& folder) {
  try {
    return read_run_summary(folder).has_value();
  } catch (const InputError&) {
    return false;  // a run.json that is not vug's
  }
}

/// Runs in the folder of a run that were made for its error bars.
std::vector<std::string> twins_of(const std::string& folder) {
  std::vector<std::string> twins;
  for (const char* twin : {"coarse", "coarser", "finer"})
    if (const std::string path = fmt::format("{}/error_bars/{}", folder, twin); is_run(path)) twins.push_back(path);
  return twins;
}

void remove_file(const fs::path& file) {
  std::error_code error;
  fs::remove(file, error);
  if (error) throw FileError(fmt::format("{}: cannot remove: {}", file.string(), error.message()));
}

/// Names this process, for those who find the folder locked.
std::string name_of_process() {
  return fmt::format("process {} on {} since {}", ::getpid(), machine_name(), utc_now());
}

/// What a folder's lock says about its holder, as one line of printable characters.
std::string holder(int lock) {
  char text[400];
  const ssize_t size = ::pread(lock, text, sizeof(text), 0);
  std::string line;
  for (ssize_t i = 0; i < size && text[i] != '\n'; ++i)
    if (text[i] >= ' ' && text[i] <= '~') line += text[i];
  return line.empty() ? "another process" : line;
}

/// The host in the name of a process; empty where there is none.
std::string host_of(const std::string& name) {
  const auto from = name.find(" on "), to = name.rfind(" since ");
  return from < to && to != std::string::npos ? name.substr(from + 4, to - from - 4) : "";
}

struct OpenFile {
  int descriptor;
  ~OpenFile() {
    if (descriptor >= 0) ::close(descriptor);
  }
};

}  // namespace

std::string results_directory(const std::string& file) {
  return "runs/" + fs::path(file).stem().string();
}

InUse is_in_use(const std::string& directory, std::string* why) {
  const auto unknown = [&](const std::string& reason) {
    if (why) *why = reason;
    return InUse::unknown;
  };
  const OpenFile lock{::open((directory + "/run.lock").c_str(), O_RDONLY | O_CLOEXEC)};
  if (lock.descriptor < 0 && errno == ENOENT) return InUse::no;
  if (lock.descriptor < 0) return unknown(fmt::format("run.lock cannot be opened ({})", std::strerror(errno)));
  if (::flock(lock.descriptor, LOCK_SH | LOCK_NB) != 0) {
    if (errno == EWOULDBLOCK) return InUse::yes;
    return unknown(fmt::format("this file system has no locks ({})", std::strerror(errno)));
  }
  // some file systems keep each machine's locks to that machine, and report here that the lock is free
  const std::string host = host_of(holder(lock.descriptor));
  if (host.empty() || host == machine_name()) return InUse::no;
  return unknown(fmt::format("its lock is of another machine, {}, and may not be seen from here", host));
}

RunFolder::RunFolder(std::string path, Use use, std::string offer)
    : path_(std::move(path)), use_(use), offer_(std::move(offer)) {
  std::error_code none;
  if (!fs::is_directory(path_, none)) return;
  lock(false);
  look();
}

RunFolder::Descriptor::~Descriptor() {
  if (value >= 0) ::close(value);
}

void RunFolder::look() {
  held_ = read_run_summary(path_);
  if (held_ && use_ == Use::fresh)
    throw InputError(fmt::format("{}: holds a run ({}); {}", path_, state_of(*held_), offer_));
  if (!held_ && use_ != Use::resume) refuse_results_of_others();
}

void RunFolder::refuse_results_of_others() const {
  for (const fs::path& file : results_in(path_))
    throw InputError(file.string() + ": is in the way, and no run.json says that vug wrote it; choose another folder");
}

void RunFolder::require_dispensable() const {
  if (!held_) return refuse_results_of_others();
  if (held_->had_checkpoint())
    throw InputError(
        fmt::format("{}: holds a run ({}) and no checkpoint to continue it from; bring its checkpoints back, "
                    "or --overwrite replaces it, -o DIR leaves it alone",
                    path_, state_of(*held_)));
}

bool RunFolder::is_ours() const {
  return lock_.value < 0 || detail::names_open_file(path_ + "/run.lock", lock_.value);
}

void RunFolder::lock(bool create) {
  const std::string path = path_ + "/run.lock";
  lock_.value = ::open(path.c_str(), O_RDWR | O_CLOEXEC | (create ? O_CREAT : 0), 0644);
  if (lock_.value < 0 && !create) return;
  if (lock_.value < 0) detail::throw_file_error(path, "create");
  if (::flock(lock_.value, LOCK_EX | LOCK_NB) == 0) {
    if (!is_ours()) throw InputError(path_ + ": is being replaced by another process; choose another folder");
    return;
  }
  if (errno == EWOULDBLOCK)
    throw InputError(fmt::format("{}: is in use by {}; choose another folder", path_, holder(lock_.value)));
  warning_ = fmt::format("{}: cannot be locked ({}): see to it that no other process writes there", path_,
                         std::strerror(errno));
}

void RunFolder::take() {
  std::error_code error;
  fs::create_directories(path_, error);
  if (error) throw FileError(fmt::format("{}: cannot make the run directory: {}", path_, error.message()));
  if (lock_.value < 0) {
    lock(true);
    look();
  }
  const std::string name = name_of_process() + "\n";
  if (::ftruncate(lock_.value, 0) != 0 || ::pwrite(lock_.value, name.data(), name.size(), 0) < 0) {
    // the name could not be written, but the lock holds without it
  }
  if (use_ != Use::overwrite) return;
  for (const std::string& twin : twins_of(path_))
    if (is_in_use(twin) == InUse::yes) throw InputError(twin + ": is in use by another process; choose another folder");
  clear();
  clear_error_bars();
}

void RunFolder::clear() const {
  for (const fs::path& file : results_in(path_)) remove_file(file);
}

void RunFolder::clear_error_bars() const {
  std::error_code kept;  // ignored: folders that contain other files stay
  for (const std::string& twin : twins_of(path_)) {
    for (const fs::path& file : results_in(twin)) remove_file(file);
    for (const char* file : {"run.json", "run.lock"}) remove_file(twin + "/" + file);
    for (const char* folder : {"/checkpoint", "/fields", "/particles", ""}) fs::remove(twin + folder, kept);
  }
  fs::remove(path_ + "/error_bars", kept);
}

}  // namespace vug
