#include "io/checkpoint.hpp"

#include "base/require.hpp"
#include "io/detail/checkpoint_file.hpp"
#include "io/detail/checkpoint_names.hpp"
#include "io/detail/digest.hpp"
#include "io/detail/input_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstring>
#include <span>
#include <utility>

namespace vug {

namespace {

void require_sound(const detail::BinaryFile& file) {
  const auto fail = [&file](const std::string& what) { throw FileError(file.path() + ": " + what); };
  if (!detail::begins_as_checkpoint(file)) fail("this is no checkpoint");
  if (file.size() < 56 || file.size() % 8 != 0) fail("the checkpoint is damaged (truncated)");
  constexpr std::size_t piece = 1 << 20;
  const std::size_t end = file.size() - 8;
  detail::DataDigest digest;
  for (std::size_t at = 0; at < end; at += piece) digest.add(detail::bytes_of(file, at, std::min(piece, end - at)));
  std::uint64_t stored = 0;
  std::memcpy(&stored, detail::bytes_of(file, end, sizeof(stored)).data(), sizeof(stored));
  if (stored != digest.value()) fail("the checkpoint is damaged (its digest does not fit)");
}

}  // namespace

Checkpoint Checkpoint::open(const std::string& path, const CheckpointOwner& owner) {
  Checkpoint checkpoint;
  checkpoint.path_ = path;
  try {
    checkpoint.file_ = std::make_shared<detail::BinaryFile>(path);
  } catch (const InputError& error) {
    throw FileError(error.what());
  }
  require_sound(*checkpoint.file_);
  detail::CheckpointReader in(*checkpoint.file_, checkpoint.file_->size() - 8);
  const detail::CheckpointHeader header = detail::read_header(in);
  checkpoint.step_ = header.step;
  checkpoint.time_ = header.time;
  checkpoint.run_ = header.owner.run;
  if (!owner.case_hash.empty() && header.owner.case_hash != owner.case_hash)
    in.fail("the checkpoint belongs to another case");
  if (!owner.run.empty() && header.owner.run != owner.run) in.fail("the checkpoint belongs to another run");
  const auto count = in.word<std::uint64_t>();
  for (std::uint64_t i = 0; i < count; ++i) {
    std::string name = in.text();
    const detail::Bytes data = in.bytes();
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
      throw FileError(
          fmt::format("{}: the checkpoint has no block '{}'; another version of vug wrote it", path_, wanted.name));
    try {
      detail::require_size(wanted.name, found->size, wanted.bytes);
      wanted.load([&](std::size_t at, std::span<std::byte> to) {
        detail::read_bytes(*file_, found->offset + at, reinterpret_cast<char*>(to.data()), to.size());
      });
    } catch (const FileError& error) {
      throw FileError(path_ + ": " + error.what());
    }
  }
}

}  // namespace vug
