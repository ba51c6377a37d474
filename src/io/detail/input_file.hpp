#pragma once
// The files that a user names: a case, a mesh, a picture. The same rule holds for all. A name without a file, and a
// file with wrong content, are errors of the input; a file that the system does not open or read is an error of the
// system.
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>

namespace vug::detail {

/// Why there is no file of this name ("does not exist", "is a folder, not a file", ...); empty when there is one.
/// Throws FileError when the system does not tell.
std::string why_no_file(const std::string& path);

/// Reads the whole file. It never waits: a pipe or a device does not count as a file. Throws InputError
/// `path: why_no_file`, or when it has more than `most` bytes; FileError when the system does not open or read it.
std::string read_input_file(const std::string& path, std::size_t most = std::numeric_limits<std::size_t>::max());

/// A file of which only parts are read, with the same rules and errors.
class BinaryFile {
 public:
  explicit BinaryFile(const std::string& path);
  BinaryFile(const BinaryFile&) = delete;
  BinaryFile& operator=(const BinaryFile&) = delete;
  ~BinaryFile();
  const std::string& path() const { return path_; }
  std::uint64_t size() const { return size_; }
  /// Reads `count` bytes from `at` on, or as many as there are. Throws FileError when the system does not read them.
  std::size_t read(std::uint64_t at, void* bytes, std::size_t count) const;

 private:
  std::string path_;
  int descriptor_;
  std::uint64_t size_ = 0;
};

}  // namespace vug::detail
