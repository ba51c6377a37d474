#pragma once
// Checkpoints: the whole state, byte for byte, in files that are either complete or not there.
#include "io/field_list.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace vug {

/// Writes the state into `directory` (made when it is missing) as `step_<number>.checkpoint`: under a temporary name,
/// synced to the disk, then renamed. The newest two are kept. `case_hash` tells whose state it is (io/run_record.hpp).
/// Throws FileError; the checkpoints written before are then still there.
void write_checkpoint(const std::string& directory, const StateList& state, std::int64_t step, double time,
                      const std::string& case_hash);

/// A checkpoint that has been read through and found sound.
class Checkpoint {
 public:
  /// The newest sound one of `directory`. Damaged ones are passed over and listed in refused(). Throws FileError, with
  /// the reason for each, when there is none, and for a state of another case.
  static Checkpoint latest(const std::string& directory, const std::string& case_hash);
  /// That of a file. Throws FileError when it is truncated, changed, no checkpoint, or of another case.
  static Checkpoint open(const std::string& path, const std::string& case_hash);

  /// Loads the blocks that `state` names, in its order. May be called again with other lists: sizes that the first ones
  /// hold are known then. Throws FileError for a block that is not in the file or does not fit.
  void load(const StateList& state) const;

  std::int64_t step() const { return step_; }
  double time() const { return time_; }
  const std::string& path() const { return path_; }
  const std::vector<std::string>& refused() const { return refused_; }

 private:
  struct Block {
    std::string name;
    std::size_t offset, size;
  };
  Checkpoint() = default;

  std::string path_;
  std::int64_t step_ = 0;
  double time_ = 0;
  std::string data_;
  std::vector<Block> blocks_;
  std::vector<std::string> refused_;
};

}  // namespace vug
