#pragma once
// Checkpoints: the whole state, byte for byte, in files that are either complete or not there.
#include "io/field_list.hpp"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace vug {

namespace detail {
class BinaryFile;
}

/// Whose state it is.
struct CheckpointOwner {
  std::string case_hash;  ///< what was asked for (io/run_record.hpp)
  std::string run;        ///< the run that wrote it; empty: whichever
};

/// Writes the state into `directory` (made when it is missing) as `step_<number>.checkpoint`: under a temporary name,
/// synced to the disk, then renamed. The newest two of this run are kept, and none after `step`; others' stay. Throws
/// FileError; the checkpoints written before are then still there.
void write_checkpoint(const std::string& directory, const StateList& state, std::int64_t step, double time,
                      const CheckpointOwner& owner);

/// A checkpoint that has been read through and found sound.
class Checkpoint {
 public:
  /// The newest sound one of its owner in `directory`; nothing where there is no checkpoint at all. Damaged ones and
  /// those of others are passed over and listed in refused(). Throws FileError, with the reason for each, when none is
  /// left, and when the folder is there and cannot be read.
  static std::optional<Checkpoint> latest(const std::string& directory, const CheckpointOwner& owner);
  /// That of a file. Throws FileError when it is truncated, changed, no checkpoint, or somebody else's.
  static Checkpoint open(const std::string& path, const CheckpointOwner& owner);

  /// Loads the blocks that `state` names, in its order. May be called again with other lists: sizes that the first ones
  /// hold are known then. Throws FileError for a block that is not in the file or does not fit.
  void load(const StateList& state) const;

  std::int64_t step() const { return step_; }
  double time() const { return time_; }
  /// The run that wrote it.
  const std::string& run() const { return run_; }
  const std::string& path() const { return path_; }
  const std::vector<std::string>& refused() const { return refused_; }

 private:
  struct Block {
    std::string name;
    std::size_t offset, size;
  };
  Checkpoint() = default;

  std::string path_, run_;
  std::int64_t step_ = 0;
  double time_ = 0;
  std::shared_ptr<const detail::BinaryFile> file_;  ///< what was read through
  std::vector<Block> blocks_;
  std::vector<std::string> refused_;
};

}  // namespace vug
