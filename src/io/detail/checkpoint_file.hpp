#pragma once
// The format of a checkpoint, for its writer and its reader.
#include "base/require.hpp"
#include "io/checkpoint.hpp"
#include "io/detail/input_file.hpp"

#include <fmt/format.h>

#include <cstring>
#include <string>
#include <string_view>

// A file consists of "VUGSTATE", then 64-bit words in the byte order of the machine: version (which also shows the byte
// order), step, time, length of the case's hash; the hash; length of the run's name; the name; number of blocks; for
// each block length of its name, name, size, data; at the end the digest of everything before it. Texts and data are
// padded with zeros to multiples of eight bytes.
namespace vug::detail {

inline constexpr std::string_view checkpoint_magic = "VUGSTATE";
inline constexpr std::uint64_t checkpoint_version = 2;

/// Number of zeros that follow `size` bytes.
inline std::size_t padding(std::size_t size) {
  return (8 - size % 8) % 8;
}

/// Bytes [offset, offset + size) of a file.
inline void read_bytes(const BinaryFile& file, std::size_t offset, char* bytes, std::size_t size) {
  if (file.read(offset, bytes, size) < size) throw FileError(file.path() + ": cannot read: it has become shorter");
}
inline std::string bytes_of(const BinaryFile& file, std::size_t offset, std::size_t size) {
  std::string bytes(size, '\0');
  read_bytes(file, offset, bytes.data(), size);
  return bytes;
}

inline bool begins_as_checkpoint(const BinaryFile& file) {
  return file.size() >= checkpoint_magic.size() && bytes_of(file, 0, checkpoint_magic.size()) == checkpoint_magic;
}

/// Where the data of a block are in the file.
struct Bytes {
  std::size_t offset = 0, size = 0;
};

/// Reads words, texts and padded bytes up to `end`.
class CheckpointReader {
 public:
  CheckpointReader(const BinaryFile& file, std::size_t end) : file_(file), end_(end) {}
  [[noreturn]] void fail(const std::string& what) const { throw FileError(file_.path() + ": " + what); }
  template <class Word>
  Word word() {
    if (end_ - at_ < sizeof(Word)) fail("the checkpoint is damaged (it ends too early)");
    Word value;
    std::memcpy(&value, bytes_of(file_, at_, sizeof(value)).data(), sizeof(value));
    at_ += sizeof(value);
    return value;
  }
  /// Skips padded bytes.
  Bytes bytes() {
    const auto size = word<std::uint64_t>();
    if (size > end_ - at_ || padding(size) > end_ - at_ - size) fail("the checkpoint is damaged (a size)");
    const Bytes found{at_, size};
    at_ += size + padding(size);
    return found;
  }
  std::string text() {
    constexpr std::size_t longest = 1 << 16;
    const Bytes found = bytes();
    if (found.size > longest) fail("the checkpoint is damaged (the size of a name)");
    return bytes_of(file_, found.offset, found.size);
  }
  bool at_end() const { return at_ == end_; }
  void skip(std::size_t bytes) { at_ += bytes; }

 private:
  const BinaryFile& file_;
  std::size_t end_, at_ = 0;
};

/// What precedes the blocks; the digest is not checked.
struct CheckpointHeader {
  std::int64_t step = 0;
  double time = 0;
  CheckpointOwner owner;
};

inline CheckpointHeader read_header(CheckpointReader& in) {
  in.skip(checkpoint_magic.size());
  if (const auto found = in.word<std::uint64_t>(); found != checkpoint_version)
    in.fail(fmt::format("the checkpoint has format {}, this program reads {}", found, checkpoint_version));
  CheckpointHeader header;
  header.step = in.word<std::int64_t>();
  header.time = in.word<double>();
  header.owner.case_hash = in.text();
  header.owner.run = in.text();
  return header;
}

}  // namespace vug::detail
