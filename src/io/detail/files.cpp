#include "io/detail/files.hpp"

#include "kernels/require.hpp"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <unistd.h>

namespace vug::detail {

namespace {

/// A file descriptor that closes itself.
struct Descriptor {
  int number;
  Descriptor(const std::string& path, int flags, const std::string& action)
      : number(::open(path.c_str(), flags, 0644)) {
    if (number < 0) throw_file_error(path, action);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() {
    if (number >= 0) ::close(number);
  }
};

void write_all(const Descriptor& file, std::string_view data, const std::string& path) {
  while (!data.empty()) {
    const auto written = ::write(file.number, data.data(), data.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) throw_file_error(path, "write");
    data.remove_prefix(static_cast<std::size_t>(written));
  }
}

void write_new(const std::string& path, const std::vector<std::string_view>& parts, bool sync) {
  Descriptor file(path, O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, "create");
  for (const auto part : parts) write_all(file, part, path);
  if (sync && ::fsync(file.number) != 0) throw_file_error(path, "write");
  const int number = file.number;
  file.number = -1;
  if (::close(number) != 0) throw_file_error(path, "write");  // some file systems report a full disk only here
}

}  // namespace

void throw_file_error(const std::string& path, const std::string& action) {
  const int reason = errno;
  throw FileError(path + ": cannot " + action + ": " + std::strerror(reason));
}

void make_directories(const std::string& path) {
  std::error_code error;
  std::filesystem::create_directories(path, error);
  if (error) throw FileError(path + ": cannot create the folder: " + error.message());
}

void replace_file(const std::string& path, const std::vector<std::string_view>& parts, bool sync) {
  const std::string temporary = path + ".tmp";
  try {
    write_new(temporary, parts, sync);
    if (std::rename(temporary.c_str(), path.c_str()) != 0) throw_file_error(path, "rename the new file");
  } catch (...) {
    ::unlink(temporary.c_str());
    throw;
  }
  if (!sync) return;
  const auto parent = std::filesystem::path(path).parent_path();
  const std::string folder = parent.empty() ? "." : parent.string();
  const Descriptor directory(folder, O_RDONLY | O_DIRECTORY | O_CLOEXEC, "open");
  if (::fsync(directory.number) != 0 && errno != EINVAL) throw_file_error(folder, "write");
}

std::string read_file(const std::string& path) {
  const Descriptor file(path, O_RDONLY | O_CLOEXEC, "open");
  std::string text;
  char buffer[1 << 16];
  while (true) {
    const auto count = ::read(file.number, buffer, sizeof(buffer));
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) throw_file_error(path, "read");
    if (count == 0) return text;
    text.append(buffer, static_cast<std::size_t>(count));
  }
}

}  // namespace vug::detail
