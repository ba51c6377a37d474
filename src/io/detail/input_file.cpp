#include "io/detail/input_file.hpp"

#include "base/require.hpp"
#include "io/detail/files.hpp"
#include "io/message.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace vug::detail {
namespace {

std::string why_no_file(const struct stat& status) {
  if (S_ISREG(status.st_mode)) return "";
  if (S_ISDIR(status.st_mode)) return "is a folder, not a file";
  return S_ISFIFO(status.st_mode) ? "is a pipe, not a file" : "is a device, not a file";
}

[[noreturn]] void refuse(const std::string& path, const std::string& why) {
  throw InputError(one_line(fmt::format("{}: {}", path, why)));
}

}  // namespace

std::string why_no_file(const std::string& path) {
  struct stat status {};
  if (::stat(path.c_str(), &status) == 0) return why_no_file(status);
  if (errno == ENOENT || errno == ENOTDIR) return "does not exist";
  if (errno == ENAMETOOLONG || errno == ELOOP) return "is no name of a file";
  throw_file_error(path, "open");
}

BinaryFile::BinaryFile(const std::string& path) : path_(path), descriptor_(-1) {
  if (const std::string why = why_no_file(path); !why.empty()) refuse(path, why);
  // O_NONBLOCK: should the name have become that of a pipe in the meantime, opening it does not wait for a writer
  descriptor_ = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY);
  if (descriptor_ < 0) throw_file_error(path, "open");
  struct stat status {};
  const bool known = ::fstat(descriptor_, &status) == 0;
  const int error = errno;
  if (known && why_no_file(status).empty()) {
    size_ = static_cast<std::uint64_t>(status.st_size);
    return;
  }
  ::close(descriptor_);
  if (known) refuse(path, why_no_file(status));
  errno = error;
  throw_file_error(path, "open");
}

BinaryFile::~BinaryFile() {
  ::close(descriptor_);
}

std::size_t BinaryFile::read(std::uint64_t at, void* bytes, std::size_t count) const {
  std::size_t done = 0;
  while (done < count) {
    const ssize_t got =
        ::pread(descriptor_, static_cast<char*>(bytes) + done, count - done, static_cast<off_t>(at + done));
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) throw_file_error(path_, "read");
    if (got == 0) break;
    done += static_cast<std::size_t>(got);
  }
  return done;
}

std::string read_input_file(const std::string& path, std::size_t most) {
  const BinaryFile file(path);
  std::string text;
  char block[1 << 16];
  while (const std::size_t count = file.read(text.size(), block, sizeof block)) {
    if (count > most - text.size())
      refuse(path, fmt::format("is larger than {} MiB, which no such file is", most >> 20));
    text.append(block, count);
  }
  return text;
}

}  // namespace vug::detail
