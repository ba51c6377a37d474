#include "io/checkpoint.hpp"

#include "io/detail/checkpoint_names.hpp"
#include "io/detail/digest.hpp"
#include "io/detail/files.hpp"
#include "io/detail/input_file.hpp"
#include "io/detail/step_names.hpp"
#include "kernels/base/require.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <span>
#include <utility>

// The file: "VUGSTATE", then 64-bit words in the byte order of the machine: version (which also tells the byte order),
// step, time, length of the case's hash; the hash; length of the run's name; the name; number of blocks; for each block
// length of its name, name, size, data; at the end the digest of everything before it. Texts and data are padded with
// zeros to multiples of eight bytes.
namespace vug {

namespace {

namespace fs = std::filesystem;

constexpr std::string_view magic = "VUGSTATE";
constexpr std::uint64_t version = 2;

std::size_t padding(std::size_t size) {
  return (8 - size % 8) % 8;
}

/// Writes words and padded bytes, and keeps the digest.
class Writer {
 public:
  explicit Writer(const std::string& path) : file_(path) {}
  void raw(std::string_view data) {
    digest_.add(data);
    file_.write(data);
  }
  template <class Word>
  void word(Word value) {
    static_assert(sizeof(Word) == 8);
    raw({reinterpret_cast<const char*>(&value), sizeof(value)});
  }
  /// Data of `size` bytes are to come, in pieces.
  void begin(std::size_t size) { word(static_cast<std::uint64_t>(size)); }
  void piece(std::string_view data) {
    while (tail_.size() % 8 != 0 && !data.empty()) {
      tail_ += data.front();
      data.remove_prefix(1);
    }
    if (tail_.size() == 8) raw(std::exchange(tail_, {}));
    const auto whole = data.size() - data.size() % 8;
    raw(data.substr(0, whole));
    tail_ += data.substr(whole);
  }
  // The tail goes out with its padding in one word, as the digest wants it.
  void end() {
    tail_.resize(tail_.size() + padding(tail_.size()));
    raw(std::exchange(tail_, {}));
  }
  void padded(std::string_view data) {
    begin(data.size());
    piece(data);
    end();
  }
  void finish() {
    word(digest_.value());
    file_.commit(true);
  }

 private:
  detail::NewFile file_;
  detail::DataDigest digest_;
  std::string tail_;  ///< what pieces until now have beyond whole words
};

/// Bytes [offset, offset + size) of a file.
void read_bytes(const detail::BinaryFile& file, std::size_t offset, char* bytes, std::size_t size) {
  if (file.read(offset, bytes, size) < size) throw FileError(file.path() + ": cannot read: it has become shorter");
}
std::string bytes_of(const detail::BinaryFile& file, std::size_t offset, std::size_t size) {
  std::string bytes(size, '\0');
  read_bytes(file, offset, bytes.data(), size);
  return bytes;
}

bool begins_as_checkpoint(const detail::BinaryFile& file) {
  return file.size() >= magic.size() && bytes_of(file, 0, magic.size()) == magic;
}

/// Where a block's data lie in the file.
struct Extent {
  std::size_t offset = 0, size = 0;
};

/// Reads what Writer wrote, up to `end`.
class Reader {
 public:
  Reader(const detail::BinaryFile& file, std::size_t end) : file_(file), end_(end) {}
  [[noreturn]] void fail(const std::string& what) const { throw FileError(file_.path() + ": " + what); }
  template <class Word>
  Word word() {
    if (end_ - at_ < sizeof(Word)) fail("the checkpoint is damaged (it ends too early)");
    Word value;
    std::memcpy(&value, bytes_of(file_, at_, sizeof(value)).data(), sizeof(value));
    at_ += sizeof(value);
    return value;
  }
  /// Passes over padded bytes.
  Extent extent() {
    const auto size = word<std::uint64_t>();
    if (size > end_ - at_ || padding(size) > end_ - at_ - size) fail("the checkpoint is damaged (a size)");
    const Extent found{at_, size};
    at_ += size + padding(size);
    return found;
  }
  std::string text() {
    constexpr std::size_t longest = 1 << 16;
    const Extent found = extent();
    if (found.size > longest) fail("the checkpoint is damaged (the size of a name)");
    return bytes_of(file_, found.offset, found.size);
  }
  bool at_end() const { return at_ == end_; }
  void skip(std::size_t bytes) { at_ += bytes; }

 private:
  const detail::BinaryFile& file_;
  std::size_t end_, at_ = 0;
};

void require_sound(const detail::BinaryFile& file) {
  const auto fail = [&file](const std::string& what) { throw FileError(file.path() + ": " + what); };
  if (!begins_as_checkpoint(file)) fail("this is no checkpoint");
  if (file.size() < 56 || file.size() % 8 != 0) fail("the checkpoint is damaged (truncated)");
  constexpr std::size_t piece = 1 << 20;
  const std::size_t end = file.size() - 8;
  detail::DataDigest digest;
  for (std::size_t at = 0; at < end; at += piece) digest.add(bytes_of(file, at, std::min(piece, end - at)));
  std::uint64_t stored = 0;
  std::memcpy(&stored, bytes_of(file, end, sizeof(stored)).data(), sizeof(stored));
  if (stored != digest.value()) fail("the checkpoint is damaged (its digest does not fit)");
}

// What stands before the blocks, without a look at the digest.
struct Header {
  std::int64_t step = 0;
  double time = 0;
  CheckpointOwner owner;
};

Header read_header(Reader& in) {
  in.skip(magic.size());
  if (const auto found = in.word<std::uint64_t>(); found != version)
    in.fail(fmt::format("the checkpoint has format {}, this program reads {}", found, version));
  Header header;
  header.step = in.word<std::int64_t>();
  header.time = in.word<double>();
  header.owner.case_hash = in.text();
  header.owner.run = in.text();
  return header;
}

// Whether a file belongs to this run, as far as its first bytes tell: a damaged one that was overwritten by nothing
// else is ours as well.
bool is_of(const CheckpointOwner& owner, const fs::path& path) {
  try {
    const detail::BinaryFile file(path.string());
    if (!begins_as_checkpoint(file)) return false;
    Reader in(file, file.size());
    const Header header = read_header(in);
    return header.owner.run == owner.run && header.owner.case_hash == owner.case_hash;
  } catch (const std::runtime_error&) {
    return false;
  }
}

// Removes what this run has no use for after `step`: all but its newest two, and states of a future that it left.
void prune(const std::string& directory, std::int64_t step, const CheckpointOwner& owner) {
  std::error_code error;
  int kept = 0;
  for (const auto& path : detail::checkpoints(directory)) {
    if (!is_of(owner, path)) continue;
    const bool later = path.stem().string() > detail::step_name(step);
    if (later || ++kept > 2) fs::remove(path, error);
  }
}

}  // namespace

void write_checkpoint(const std::string& directory, const StateList& state, std::int64_t step, double time,
                      const CheckpointOwner& owner) {
  std::error_code error;
  fs::create_directories(directory, error);
  if (error) throw FileError(directory + ": cannot create the folder: " + error.message());
  Writer out(fmt::format("{}/{}", directory, detail::checkpoint_name(step)));
  out.raw(magic);
  out.word(version);
  out.word(step);
  out.word(time);
  out.padded(owner.case_hash);
  out.padded(owner.run);
  out.word(static_cast<std::uint64_t>(state.blocks.size()));
  for (const auto& block : state.blocks) {
    out.padded(block.name);
    out.begin(block.bytes);
    block.save([&](std::span<const std::byte> piece) {
      out.piece({reinterpret_cast<const char*>(piece.data()), piece.size()});
    });
    out.end();
  }
  out.finish();
  prune(directory, step, owner);
}

Checkpoint Checkpoint::open(const std::string& path, const CheckpointOwner& owner) {
  Checkpoint checkpoint;
  checkpoint.path_ = path;
  try {
    checkpoint.file_ = std::make_shared<detail::BinaryFile>(path);
  } catch (const InputError& error) {
    throw FileError(error.what());
  }
  require_sound(*checkpoint.file_);
  Reader in(*checkpoint.file_, checkpoint.file_->size() - 8);
  const Header header = read_header(in);
  checkpoint.step_ = header.step;
  checkpoint.time_ = header.time;
  checkpoint.run_ = header.owner.run;
  if (header.owner.case_hash != owner.case_hash) in.fail("the checkpoint belongs to another case");
  if (!owner.run.empty() && header.owner.run != owner.run) in.fail("the checkpoint belongs to another run");
  const auto count = in.word<std::uint64_t>();
  for (std::uint64_t i = 0; i < count; ++i) {
    std::string name = in.text();
    const Extent data = in.extent();
    checkpoint.blocks_.push_back({std::move(name), data.offset, data.size});
  }
  if (!in.at_end()) in.fail("the checkpoint is damaged (more than its blocks)");
  return checkpoint;
}

std::optional<Checkpoint> Checkpoint::latest(const std::string& directory, const CheckpointOwner& owner) {
  std::vector<std::string> refused;
  for (const auto& path : detail::checkpoints(directory)) {
    try {
      auto checkpoint = open(path.string(), owner);
      checkpoint.refused_ = std::move(refused);
      return checkpoint;
    } catch (const FileError& error) {
      refused.emplace_back(error.what());
    }
  }
  if (refused.empty()) return std::nullopt;
  throw FileError(fmt::format("{}", fmt::join(refused, "; ")));
}

bool Checkpoint::holds(const std::string& block) const {
  return std::any_of(blocks_.begin(), blocks_.end(), [&](const Block& own) { return own.name == block; });
}

void Checkpoint::load(const StateList& state) const {
  for (const auto& wanted : state.blocks) {
    const auto found =
        std::find_if(blocks_.begin(), blocks_.end(), [&](const Block& b) { return b.name == wanted.name; });
    if (found == blocks_.end())
      throw FileError(fmt::format("{}: the checkpoint has no block '{}'", path_, wanted.name));
    try {
      detail::require_size(wanted.name, found->size, wanted.bytes);
      wanted.load([&](std::size_t at, std::span<std::byte> to) {
        read_bytes(*file_, found->offset + at, reinterpret_cast<char*>(to.data()), to.size());
      });
    } catch (const FileError& error) {
      throw FileError(path_ + ": " + error.what());
    }
  }
}

}  // namespace vug
