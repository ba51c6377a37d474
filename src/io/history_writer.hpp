#pragma once
// history.csv: one row of numbers per output time.
#include <cstdint>
#include <cstdio>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace vug {

/// Appends rows to a CSV file, with 17 significant digits (which read back to the same bits). When `write` returns, the
/// row has been handed to the operating system. The first column is the time. Throws FileError.
class HistoryWriter {
 public:
  /// Names of columns include their units ("time_s"). With `resume_time` an existing file is continued: rows after that
  /// time and an incomplete last line are dropped; throws FileError when its header differs.
  HistoryWriter(const std::string& path, const std::vector<std::string>& columns,
                std::optional<double> resume_time = std::nullopt);
  void write(std::span<const double> row);
  /// Syncs the rows to the disk. Throws FileError also where the file was removed or replaced in the meantime, because
  /// its rows would then be lost.
  void sync();
  /// From now on cells with NaN are left empty.
  void leave_unknown_empty() { empty_ = true; }
  /// Number of rows in the file, with those that it had when it was continued.
  std::int64_t rows() const { return rows_; }

 private:
  struct Closer {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  std::string path_;
  std::size_t columns_;
  std::int64_t rows_ = 0;
  bool empty_ = false;
  std::unique_ptr<std::FILE, Closer> file_;
};

}  // namespace vug
