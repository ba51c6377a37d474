#pragma once
// The folder of a run: who may write into it, and which of its files belong to the run.
#include "io/run_summary.hpp"

#include <optional>
#include <string>

namespace vug {

/// Default folder for the results of a case or a study: "runs/" and the name of its file.
std::string results_directory(const std::string& file);

/// Whether the lock of a folder is held by a process. `unknown`: the file system has no locks, run.lock cannot be
/// opened, or the lock was that of another machine, whose locks are not visible everywhere.
enum class InUse { no, yes, unknown };

/// Whether a process holds the folder and writes into it; where that is unknown, `why` gets the reason.
InUse is_in_use(const std::string& directory, std::string* why = nullptr);

/// A folder into which one process at a time writes results. The lock is one of the operating system, on the file
/// run.lock, and ends with the process in any case; the file itself stays and has no meaning after that.
class RunFolder {
 public:
  enum class Use {
    fresh,      ///< the folder must not contain a run
    resume,     ///< the run in the folder is continued
    overwrite,  ///< the run in the folder is replaced
  };
  /// Checks the folder and writes nothing. Throws InputError when another process holds the folder, or when it contains
  /// results that `use` must not replace; `offer` then says what can be done, for instance "--overwrite replaces it".
  RunFolder(std::string path, Use use, std::string offer);
  RunFolder(const RunFolder&) = delete;
  RunFolder& operator=(const RunFolder&) = delete;

  /// Makes the folder, locks it, and checks it again for what has been written in the meantime. To overwrite, it
  /// removes the old run, its error bars and the runs that were made for them. Throws InputError and FileError.
  void take();
  /// Whether the folder of that name is still the one that was taken; false when it or its run.lock was removed or
  /// replaced, because another run may then be in it.
  bool is_ours() const;
  /// Checks that a run which was to be continued may begin anew without a loss, because it ended before its first
  /// checkpoint. Throws InputError where it has had one, and where results are there without a run.json.
  void require_dispensable() const;
  /// Removes the files that a run has written, recognised by their names. Other files stay, and so does run.json until
  /// it is replaced.
  void clear() const;

  const std::string& path() const { return path_; }
  /// The run that is in the folder.
  const std::optional<RunSummary>& held() const { return held_; }
  /// Why the folder could not be locked, on file systems without locks; otherwise empty.
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
  /// Closed with the folder, also when its constructor throws.
  struct Descriptor {
    int value = -1;
    ~Descriptor();
  } lock_;
};

}  // namespace vug
