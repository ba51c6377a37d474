#include "io/detail/input_file.hpp"

#include "io/detail/files.hpp"
#include "io/message.hpp"
#include "kernels/require.hpp"

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

/// Closes what it holds.
struct Descriptor {
  int number;
  ~Descriptor() {
    if (number >= 0) ::close(number);
  }
};

}  // namespace

std::string why_no_file(const std::string& path) {
  struct stat status {};
  if (::stat(path.c_str(), &status) == 0) return why_no_file(status);
  if (errno == ENOENT || errno == ENOTDIR) return "does not exist";
  if (errno == ENAMETOOLONG || errno == ELOOP) return "is no name of a file";
  throw_file_error(path, "open");
}

std::string read_input_file(const std::string& path, std::size_t most) {
  if (const std::string why = why_no_file(path); !why.empty()) refuse(path, why);
  // O_NONBLOCK: if the name has become that of a pipe meanwhile, opening it does not wait for a writer
  const Descriptor file{::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY)};
  struct stat status {};
  if (file.number < 0 || ::fstat(file.number, &status) != 0) throw_file_error(path, "open");
  if (const std::string why = why_no_file(status); !why.empty()) refuse(path, why);
  std::string text;
  char block[1 << 16];
  while (true) {
    const ssize_t count = ::read(file.number, block, sizeof block);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) throw_file_error(path, "read");
    if (count == 0) return text;
    if (static_cast<std::size_t>(count) > most - text.size())
      refuse(path, fmt::format("is larger than {} MiB, which no such file is", most >> 20));
    text.append(block, static_cast<std::size_t>(count));
  }
}

}  // namespace vug::detail
