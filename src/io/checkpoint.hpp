#pragma once
// Checkpoints: the whole state, byte for byte, in files that are either complete or do not exist.
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

/// The case and the run to which a state belongs.
struct CheckpointOwner {
  std::string case_hash;  ///< of case, overrides and input files (io/run_record.hpp); empty: any case
  std::string run;        ///< the run that wrote it; empty: any run
};

/// Writes the state into `directory` (made when it is missing) as `step_<number>.checkpoint`: under a temporary name,
/// synced to the disk, then renamed. Of the checkpoints of this run the newest two are kept, and none after `step`;
/// those of other runs stay. Throws FileError; the checkpoints written before then still exist.
void write_checkpoint(const std::string& directory, const StateList& state, std::int64_t step, double time,
                      const CheckpointOwner& owner);

/// A checkpoint that has been read completely and whose digest is right.
class Checkpoint {
 public:
  /// Returns the newest undamaged checkpoint of the owner in `directory`, or nothing where there is no checkpoint at
  /// all. Damaged ones and those of other owners are skipped and listed in refused(). Throws FileError where there are
  /// only such ones, with the reason for each, and where the folder exists but cannot be read.
  static std::optional<Checkpoint> latest(const std::string& directory, const CheckpointOwner& owner);
  /// Opens a file. Throws FileError when it is truncated, changed, not a checkpoint, or that of another owner.
  static Checkpoint open(const std::string& path, const CheckpointOwner& owner);

  /// Whether it has a block of that name: earlier versions of vug may not have written it.
  bool holds(const std::string& block) const;
  /// Loads the blocks that `state` names, in its order. May be called again with further lists, whose sizes may be
  /// known only from the blocks of the first. Throws FileError for a block that is not in the file or does not fit.
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
  std::shared_ptr<const detail::BinaryFile> file_;  ///< the open file
  std::vector<Block> blocks_;
  std::vector<std::string> refused_;
};

}  // namespace vug
