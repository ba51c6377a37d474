#include "io/detail/files.hpp"

#include "base/require.hpp"
#include "host/free_memory.hpp"

#include <cerrno>
#include <cstdio>
#include <fcntl.h>
#include <filesystem>
#include <sys/stat.h>
#include <unistd.h>
#include <utility>

namespace vug::detail {

namespace {

int open_file(const std::string& path, int flags, const std::string& action) {
  const int descriptor = ::open(path.c_str(), flags | O_CLOEXEC, 0644);
  if (descriptor < 0) throw_file_error(path, action);
  return descriptor;
}

// Syncs the folder, which holds the entry of a new name.
void sync_folder(const std::string& path) {
  const auto parent = std::filesystem::path(path).parent_path();
  const std::string folder = parent.empty() ? "." : parent.string();
  const int descriptor = open_file(folder, O_RDONLY | O_DIRECTORY, "open");
  const bool failed = ::fsync(descriptor) != 0 && errno != EINVAL;  // EINVAL: the file system does not support this
  const int reason = errno;
  ::close(descriptor);
  errno = reason;
  if (failed) throw_file_error(folder, "write");
}

}  // namespace

void throw_file_error(const std::string& path, const std::string& action, std::error_code reason) {
  const std::string what = path + ": cannot " + action + ": " + reason.message();
  if (reason == std::errc::not_enough_memory) throw MemoryError(what);
  throw FileError(what);
}

void throw_file_error(const std::string& path, const std::string& action) {
  throw_file_error(path, action, std::error_code(errno, std::generic_category()));
}

NewFile::NewFile(const std::string& path)
    : path_(path),
      temporary_(path + ".tmp"),
      descriptor_(open_file(temporary_, O_WRONLY | O_CREAT | O_TRUNC, "create")) {}

NewFile::~NewFile() {
  if (descriptor_ >= 0) ::close(descriptor_);
  if (!temporary_.empty()) ::unlink(temporary_.c_str());
}

void NewFile::write(std::string_view data) {
  while (!data.empty()) {
    const auto written = ::write(descriptor_, data.data(), data.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) throw_file_error(path_, "write");
    data.remove_prefix(static_cast<std::size_t>(written));
  }
}

void NewFile::commit(bool sync) {
  if (sync && ::fsync(descriptor_) != 0) throw_file_error(path_, "write");
  // some file systems report a full disk only on closing
  if (::close(std::exchange(descriptor_, -1)) != 0) throw_file_error(path_, "write");
  if (std::rename(temporary_.c_str(), path_.c_str()) != 0) throw_file_error(path_, "rename the new file");
  temporary_.clear();
  if (sync) sync_folder(path_);
}

void replace_file(const std::string& path, std::string_view text, bool sync) {
  NewFile file(path);
  file.write(text);
  file.commit(sync);
}

bool names_open_file(const std::string& path, int descriptor) {
  struct stat named {};
  struct stat open {};
  return ::stat(path.c_str(), &named) == 0 && ::fstat(descriptor, &open) == 0 && named.st_dev == open.st_dev &&
         named.st_ino == open.st_ino;
}

std::string read_file(const std::string& path) {
  const int descriptor = open_file(path, O_RDONLY, "open");
  std::string text;
  char buffer[1 << 16];
  ssize_t count = 0;
  while ((count = ::read(descriptor, buffer, sizeof(buffer))) > 0 || (count < 0 && errno == EINTR))
    if (count > 0) text.append(buffer, static_cast<std::size_t>(count));
  const int reason = errno;
  ::close(descriptor);
  errno = reason;
  if (count < 0) throw_file_error(path, "read");
  return text;
}

}  // namespace vug::detail
