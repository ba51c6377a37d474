#pragma once
// The folder of a run: who may write into it, and which of its files are the run's own.
#include "io/run_summary.hpp"

#include <optional>
#include <string>

namespace vug {

/// Where the results of a case or a study go unless told otherwise: "runs/" and the name of its file.
std::string results_directory(const std::string& file);

/// What a folder's lock tells of a process that writes there. `unknown`: the file system has no locks, or the lock was
/// that of another machine, whose locks are not seen everywhere.
enum class InUse { no, yes, unknown };

/// Whether a process holds the folder and writes into it; where that is unknown, `why` says what is in the way.
InUse is_in_use(const std::string& directory, std::string* why = nullptr);

/// A folder that one process writes results into at a time. The lock is the operating system's, on the file run.lock,
/// and ends with the process, however that ends; the file itself stays and means nothing once that has ended.
class RunFolder {
 public:
  enum class Use {
    fresh,      ///< nothing of a run may be there
    resume,     ///< the run that is there goes on
    overwrite,  ///< the run that is there is replaced
  };
  /// Looks, and writes nothing. Throws InputError when another process holds the folder, or when it holds results that
  /// `use` does not give up: `offer` then says what can be done, as "--overwrite replaces it".
  RunFolder(std::string path, Use use, std::string offer);
  RunFolder(const RunFolder&) = delete;
  RunFolder& operator=(const RunFolder&) = delete;

  /// Makes the folder, locks it, and looks again: what has come meanwhile is not touched either. To overwrite, clears
  /// it, error bars of the run with the runs that were made for them included. Throws InputError and FileError.
  void take();
  /// Whether the folder of that name is still the one that was taken: not where somebody has removed or replaced it, or
  /// its run.lock, and another run may be in it.
  bool is_ours() const;
  /// Whether nothing is lost when the run begins anew though it was to be continued: where it ended before its first
  /// checkpoint. Throws InputError where it has had one, and where no run.json says whose results there are.
  void require_dispensable() const;
  /// Removes what a run has written, by the names that vug gives; other files stay, and run.json until it is replaced.
  void clear() const;

  const std::string& path() const { return path_; }
  /// The run that is there.
  const std::optional<RunSummary>& held() const { return held_; }
  /// Why the folder could not be locked, on file systems that have no locks; else empty.
  const std::string& warning() const { return warning_; }

 private:
  void look();
  void clear_error_bars() const;
  void refuse_results_of_others() const;
  void lock(bool create);

  std::string path_;
  Use use_;
  std::string offer_;
  std::optional<RunSummary> held_;
  std::string warning_;
  /// Closed with the folder, and when its constructor throws.
  struct Descriptor {
    int value = -1;
    ~Descriptor();
  } lock_;
};

}  // namespace vug
