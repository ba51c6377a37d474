#include "io/checkpoint.hpp"

#include "io/detail/digest.hpp"
#include "io/detail/files.hpp"
#include "io/detail/step_names.hpp"
#include "kernels/base/require.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <filesystem>

// The file: "VUGSTATE", then 64-bit words in the byte order of the machine: version (which also tells the byte order),
// step, time, length of the case's hash; the hash; length of the run's name; the name; number of blocks; for each block
// length of its name, name, size, data; at the end the digest of everything before it. Texts and data are padded with
// zeros to multiples of eight bytes.
namespace vug {

namespace {

namespace fs = std::filesystem;

constexpr std::string_view magic = "VUGSTATE";
constexpr std::uint64_t version = 2;
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
std::vector<fs::path> checkpoints(const std::string& directory) {
  std::vector<fs::path> paths;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(directory, error))
    if (entry.path().extension() == extension && detail::is_step_name(entry.path().stem().string()) &&
        entry.is_regular_file(error))
      paths.push_back(entry.path());
  std::sort(paths.rbegin(), paths.rend());
  return paths;
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
  header.owner.case_hash = in.padded();
  header.owner.run = in.padded();
  return header;
}

// Whether a file belongs to this run, as far as its first bytes tell: a damaged one that was overwritten by nothing
// else is ours as well.
bool is_of(const CheckpointOwner& owner, const fs::path& path) {
  std::string head(4096, '\0');
  std::FILE* file = std::fopen(path.c_str(), "rb");
  if (!file) return false;
  head.resize(std::fread(head.data(), 1, head.size(), file));
  std::fclose(file);
  if (!head.starts_with(magic)) return false;
  try {
    const std::string name = path.string();
    Reader in(head, name);
    const Header header = read_header(in);
    return header.owner.run == owner.run && header.owner.case_hash == owner.case_hash;
  } catch (const FileError&) {
    return false;
  }
}

// Removes what this run has no use for after `step`: all but its newest two, and states of a future that it left.
void prune(const std::string& directory, std::int64_t step, const CheckpointOwner& owner) {
  std::error_code error;
  int kept = 0;
  for (const auto& path : checkpoints(directory)) {
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
  Writer out(fmt::format("{}/{}{}", directory, detail::step_name(step), extension));
  out.raw(magic);
  out.word(version);
  out.word(step);
  out.word(time);
  out.padded(owner.case_hash);
  out.padded(owner.run);
  out.word(static_cast<std::uint64_t>(state.blocks.size()));
  for (const auto& block : state.blocks) {
    out.padded(block.name);
    const auto bytes = block.save();
    out.padded({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
  }
  out.finish();
  prune(directory, step, owner);
}

Checkpoint Checkpoint::open(const std::string& path, const CheckpointOwner& owner) {
  Checkpoint checkpoint;
  checkpoint.path_ = path;
  checkpoint.data_ = detail::read_file(path);
  require_sound(checkpoint.data_, path);
  Reader in(std::string_view(checkpoint.data_).substr(0, checkpoint.data_.size() - 8), path);
  const Header header = read_header(in);
  checkpoint.step_ = header.step;
  checkpoint.time_ = header.time;
  checkpoint.run_ = header.owner.run;
  if (header.owner.case_hash != owner.case_hash) in.fail("the checkpoint belongs to another case");
  if (!owner.run.empty() && header.owner.run != owner.run) in.fail("the checkpoint belongs to another run");
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

std::optional<Checkpoint> Checkpoint::latest(const std::string& directory, const CheckpointOwner& owner) {
  std::vector<std::string> refused;
  for (const auto& path : checkpoints(directory)) {
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

void Checkpoint::load(const StateList& state) const {
  for (const auto& wanted : state.blocks) {
    const auto found =
        std::find_if(blocks_.begin(), blocks_.end(), [&](const Block& b) { return b.name == wanted.name; });
    if (found == blocks_.end())
      throw FileError(fmt::format("{}: the checkpoint has no block '{}'", path_, wanted.name));
    const auto* data = reinterpret_cast<const std::byte*>(data_.data() + found->offset);
    try {
      wanted.load({data, found->size});
    } catch (const FileError& error) {
      throw FileError(path_ + ": " + error.what());
    }
  }
}

}  // namespace vug
