#pragma once
// The files that a user names: a case, a mesh, a picture. One rule for all: a name that leads to no file, and a file
// with the wrong content, are mistakes of the input; a file that the system will not open or read is a failure of the
// system.
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>

namespace vug::detail {

/// Why there is no file under this name ("does not exist", "is a folder, not a file", ...); empty when there is one.
/// Throws FileError when the system does not say.
std::string why_no_file(const std::string& path);

/// The whole file. Waits for nothing: a pipe or a device is no file. Throws InputError `path: why_no_file` or when it
/// has more than `most` bytes, FileError when the system will not open or read it.
std::string read_input_file(const std::string& path, std::size_t most = std::numeric_limits<std::size_t>::max());

/// A file of which only parts are read. The same rules and errors.
class BinaryFile {
 public:
  explicit BinaryFile(const std::string& path);
  BinaryFile(const BinaryFile&) = delete;
  BinaryFile& operator=(const BinaryFile&) = delete;
  ~BinaryFile();
  const std::string& path() const { return path_; }
  std::uint64_t size() const { return size_; }
  /// As many of the `count` bytes from `at` on as there are. Throws FileError when the system will not read them.
  std::size_t read(std::uint64_t at, void* bytes, std::size_t count) const;

 private:
  std::string path_;
  int descriptor_;
  std::uint64_t size_ = 0;
};

}  // namespace vug::detail
