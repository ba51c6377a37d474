#include "base/require.hpp"
#include "io/checkpoint.hpp"
#include "io/detail/checkpoint_file.hpp"
#include "io/detail/checkpoint_names.hpp"
#include "io/detail/digest.hpp"
#include "io/detail/files.hpp"
#include "io/detail/step_names.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <span>
#include <utility>

namespace vug {

namespace {

namespace fs = std::filesystem;

/// Writes words and padded bytes, and computes the digest.
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
  /// Begins data of `size` bytes, which follow in pieces.
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
  // Writes the tail with its padding as one word, as the digest requires.
  void end() {
    tail_.resize(tail_.size() + detail::padding(tail_.size()));
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
  std::string tail_;  ///< bytes of the pieces so far that do not fill a word
};

// Whether a file belongs to this run, judged by its header only: a damaged file whose header is intact counts as well.
bool is_of(const CheckpointOwner& owner, const fs::path& path) {
  try {
    const detail::BinaryFile file(path.string());
    if (!detail::begins_as_checkpoint(file)) return false;
    detail::CheckpointReader in(file, file.size());
    const detail::CheckpointHeader header = detail::read_header(in);
    return header.owner.run == owner.run;  // the hash is another one where the end of the run has been moved
  } catch (const std::runtime_error&) {
    return false;
  }
}

// Removes the checkpoints that this run no longer needs: all but its newest two up to `step`, and all after `step`,
// which are left where it was resumed from an earlier one; and those that a killed process did not finish.
void prune(const std::string& directory, std::int64_t step, const CheckpointOwner& owner) {
  std::error_code error;
  int kept = 0;
  for (const auto& path : detail::checkpoints(directory)) {
    if (!is_of(owner, path)) continue;
    const bool later = path.stem().string() > detail::step_name(step);
    if (later || ++kept > 2) fs::remove(path, error);
  }
  for (const auto& path : detail::unfinished_checkpoints(directory)) fs::remove(path, error);
}

}  // namespace

void write_checkpoint(const std::string& directory, const StateList& state, std::int64_t step, double time,
                      const CheckpointOwner& owner) {
  std::error_code error;
  fs::create_directories(directory, error);
  if (error) throw FileError(directory + ": cannot create the folder: " + error.message());
  Writer out(fmt::format("{}/{}", directory, detail::checkpoint_name(step)));
  out.raw(detail::checkpoint_magic);
  out.word(detail::checkpoint_version);
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

}  // namespace vug
