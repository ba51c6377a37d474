#include "io/checkpoint.hpp"

#include "io/detail/digest.hpp"
#include "io/detail/files.hpp"
#include "kernels/require.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <filesystem>

// The file: "VUGSTATE", then 64-bit words in the byte order of the machine: version (which also tells the byte order),
// step, time, length of the hash; the hash; number of blocks; for each block length of its name, name, size, data; at
// the end the digest of everything before it. Texts and data are padded with zeros to multiples of eight bytes.
namespace vug {

namespace {

namespace fs = std::filesystem;

constexpr std::string_view magic = "VUGSTATE";
constexpr std::uint64_t version = 1;
constexpr std::string_view extension = ".checkpoint";

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
  // The tail goes out with its padding in one word, as the digest wants it.
  void padded(std::string_view data) {
    word(static_cast<std::uint64_t>(data.size()));
    const auto whole = data.size() - data.size() % 8;
    raw(data.substr(0, whole));
    if (whole < data.size()) {
      char tail[8] = {};
      std::memcpy(tail, data.data() + whole, data.size() - whole);
      raw({tail, sizeof(tail)});
    }
  }
  void finish() {
    word(digest_.value());
    file_.commit(true);
  }

 private:
  detail::NewFile file_;
  detail::DataDigest digest_;
};

/// Reads what Writer wrote, from memory.
class Reader {
 public:
  Reader(std::string_view data, const std::string& path) : data_(data), path_(path) {}
  [[noreturn]] void fail(const std::string& what) const { throw FileError(path_ + ": " + what); }
  template <class Word>
  Word word() {
    if (data_.size() - at_ < sizeof(Word)) fail("the checkpoint is damaged (it ends too early)");
    Word value;
    std::memcpy(&value, data_.data() + at_, sizeof(value));
    at_ += sizeof(value);
    return value;
  }
  std::string_view padded() {
    const auto size = word<std::uint64_t>();
    if (size > data_.size() - at_ || padding(size) > data_.size() - at_ - size)
      fail("the checkpoint is damaged (a size)");
    const auto found = data_.substr(at_, size);
    at_ += size + padding(size);
    return found;
  }
  bool at_end() const { return at_ == data_.size(); }
  void skip(std::size_t bytes) { at_ += bytes; }

 private:
  std::string_view data_;
  const std::string& path_;
  std::size_t at_ = 0;
};

void require_sound(std::string_view data, const std::string& path) {
  const auto fail = [&path](const std::string& what) { throw FileError(path + ": " + what); };
  if (data.size() < magic.size() || !data.starts_with(magic)) fail("this is no checkpoint");
  if (data.size() < 56 || data.size() % 8 != 0) fail("the checkpoint is damaged (truncated)");
  detail::DataDigest digest;
  digest.add(data.substr(0, data.size() - 8));
  std::uint64_t stored = 0;
  std::memcpy(&stored, data.data() + data.size() - 8, sizeof(stored));
  if (stored != digest.value()) fail("the checkpoint is damaged (its digest does not fit)");
}

// Complete checkpoints of a folder, newest first: the names sort by step.
std::vector<std::string> checkpoints(const std::string& directory) {
  std::vector<std::string> paths;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(directory, error))
    if (entry.path().extension() == extension) paths.push_back(entry.path().string());
  std::sort(paths.rbegin(), paths.rend());
  return paths;
}

}  // namespace

void write_checkpoint(const std::string& directory, const StateList& state, std::int64_t step, double time,
                      const std::string& case_hash) {
  std::error_code error;
  fs::create_directories(directory, error);
  if (error) throw FileError(directory + ": cannot create the folder: " + error.message());
  Writer out(fmt::format("{}/step_{:012d}{}", directory, step, extension));
  out.raw(magic);
  out.word(version);
  out.word(step);
  out.word(time);
  out.padded(case_hash);
  out.word(static_cast<std::uint64_t>(state.blocks.size()));
  for (const auto& block : state.blocks) {
    out.padded(block.name);
    const auto bytes = block.save();
    out.padded({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
  }
  out.finish();
  const auto present = checkpoints(directory);
  for (std::size_t i = 2; i < present.size(); ++i) fs::remove(present[i], error);
}

Checkpoint Checkpoint::open(const std::string& path, const std::string& case_hash) {
  Checkpoint checkpoint;
  checkpoint.path_ = path;
  checkpoint.data_ = detail::read_file(path);
  require_sound(checkpoint.data_, path);
  Reader in(std::string_view(checkpoint.data_).substr(0, checkpoint.data_.size() - 8), path);
  in.skip(magic.size());
  if (const auto found = in.word<std::uint64_t>(); found != version)
    in.fail(fmt::format("the checkpoint has format {}, this program reads {}", found, version));
  checkpoint.step_ = in.word<std::int64_t>();
  checkpoint.time_ = in.word<double>();
  if (const auto found = in.padded(); found != case_hash)
    in.fail(fmt::format("the checkpoint belongs to another case (hash {}, this case has {})", found, case_hash));
  const auto count = in.word<std::uint64_t>();
  for (std::uint64_t i = 0; i < count; ++i) {
    const auto name = in.padded();
    const auto block = in.padded();
    const auto offset = static_cast<std::size_t>(block.data() - checkpoint.data_.data());
    checkpoint.blocks_.push_back({std::string(name), offset, block.size()});
  }
  if (!in.at_end()) in.fail("the checkpoint is damaged (more than its blocks)");
  return checkpoint;
}

Checkpoint Checkpoint::latest(const std::string& directory, const std::string& case_hash) {
  std::vector<std::string> refused;
  for (const auto& path : checkpoints(directory)) {
    try {
      auto checkpoint = open(path, case_hash);
      checkpoint.refused_ = std::move(refused);
      return checkpoint;
    } catch (const FileError& error) {
      refused.emplace_back(error.what());
    }
  }
  if (refused.empty()) throw FileError(directory + ": there is no checkpoint to continue from");
  throw FileError(fmt::format("{}", fmt::join(refused, "; ")));
}

void Checkpoint::load(const StateList& state) const {
  for (const auto& wanted : state.blocks) {
    const auto found =
        std::find_if(blocks_.begin(), blocks_.end(), [&](const Block& b) { return b.name == wanted.name; });
    if (found == blocks_.end())
      throw FileError(fmt::format("{}: the checkpoint has no block '{}'", path_, wanted.name));
    const auto* data = reinterpret_cast<const std::byte*>(data_.data() + found->offset);
    wanted.load({data, found->size});
  }
}

}  // namespace vug
