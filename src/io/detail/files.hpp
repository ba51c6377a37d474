#pragma once
// Writing files so that a reader finds either the old one or the new one, never a part of one.
#include <string>
#include <string_view>
#include <system_error>

namespace vug::detail {

/// Throws FileError: `path: cannot <action>: <reason>`, or MemoryError where the reason is too little memory.
[[noreturn]] void throw_file_error(const std::string& path, const std::string& action, std::error_code reason);
/// The same with the reason of errno.
[[noreturn]] void throw_file_error(const std::string& path, const std::string& action);

/// A file that is written under a temporary name beside its own and renamed when it is complete. If it is destroyed
/// before that, it leaves nothing behind. Throws FileError.
class NewFile {
 public:
  explicit NewFile(const std::string& path);
  NewFile(const NewFile&) = delete;
  NewFile& operator=(const NewFile&) = delete;
  ~NewFile();
  void write(std::string_view data);
  /// The name until then, for a library that writes the file itself.
  const std::string& temporary() const { return temporary_; }
  /// Renames the file. With `sync` the data and the new name have reached the disk before it returns.
  void commit(bool sync);

 private:
  std::string path_, temporary_;
  int descriptor_;
};

/// Writes a whole new file.
void replace_file(const std::string& path, std::string_view text, bool sync);

/// Whether `path` still names the file that is open as `descriptor`; false after it was removed or replaced.
bool names_open_file(const std::string& path, int descriptor);

/// Returns the whole file.
std::string read_file(const std::string& path);

}  // namespace vug::detail
