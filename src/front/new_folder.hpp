#pragma once
// A folder of results that is either complete or absent.
#include "base/require.hpp"
#include "io/detail/files.hpp"

#include <filesystem>
#include <string>
#include <system_error>

namespace vug {

/// A folder that appears under its name when it is complete. If it is dropped before commit(), nothing of it remains.
class NewFolder {
 public:
  explicit NewFolder(const std::filesystem::path& path)
      : path_(without_slash(path.lexically_normal())), temporary_(path_.string() + ".tmp") {
    if (std::filesystem::exists(path_))
      throw InputError(path_.string() + ": is there already; -o DIR writes elsewhere");
    if (!temporary_.parent_path().empty()) std::filesystem::create_directories(temporary_.parent_path());
    if (!std::filesystem::create_directory(temporary_))
      throw InputError(temporary_.string() + ": is in the way; remove it, or -o DIR writes elsewhere");
    made_ = true;
  }
  NewFolder(const NewFolder&) = delete;
  NewFolder& operator=(const NewFolder&) = delete;
  ~NewFolder() {
    std::error_code none;
    if (made_) std::filesystem::remove_all(temporary_, none);
  }
  std::filesystem::path place(const std::filesystem::path& inside) const {
    const std::filesystem::path path = temporary_ / inside;
    std::filesystem::create_directories(path.parent_path());
    return path;
  }
  void write(const std::filesystem::path& inside, const std::string& text) const {
    detail::replace_file(place(inside).string(), text, false);
  }
  void commit() {
    std::filesystem::rename(temporary_, path_);
    made_ = false;
  }

 private:
  static std::filesystem::path without_slash(const std::filesystem::path& path) {
    return path.has_filename() ? path : path.parent_path();
  }

  std::filesystem::path path_, temporary_;
  bool made_ = false;
};

}  // namespace vug
