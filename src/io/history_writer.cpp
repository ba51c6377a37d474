#include "io/history_writer.hpp"

#include "base/require.hpp"
#include "io/detail/files.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <sstream>
#include <unistd.h>

namespace vug {

namespace {

// The header and the complete rows up to `time`.
std::string kept_rows(const std::string& path, const std::string& header, double time) {
  std::istringstream in(detail::read_file(path));
  std::string line;
  std::getline(in, line);
  const bool torn = in.eof() && header.starts_with(line);  // cut off in the header
  if (!torn && line != header)
    throw FileError(path + ": the columns differ from those of this run, so it cannot be continued");
  const auto commas = std::count(header.begin(), header.end(), ',');
  std::string kept = header + "\n";
  while (std::getline(in, line)) {
    const bool whole = !in.eof() && std::count(line.begin(), line.end(), ',') == commas;
    if (whole && std::strtod(line.c_str(), nullptr) <= time) kept += line + "\n";
  }
  return kept;
}

}  // namespace

HistoryWriter::HistoryWriter(const std::string& path, const std::vector<std::string>& columns,
                             std::optional<double> resume_time)
    : path_(path), columns_(columns.size()) {
  const auto header = fmt::format("{}", fmt::join(columns, ","));
  const bool resume = resume_time && std::filesystem::exists(path);
  const std::string text = resume ? kept_rows(path, header, *resume_time) : header + "\n";
  rows_ = std::count(text.begin(), text.end(), '\n') - 1;
  detail::replace_file(path, text, true);
  file_.reset(std::fopen(path.c_str(), "a"));
  if (!file_) detail::throw_file_error(path, "open");
}

void HistoryWriter::write(std::span<const double> row) {
  if (row.size() != columns_)
    throw FileError(fmt::format("{}: a row of {} numbers for {} columns", path_, row.size(), columns_));
  std::string line;
  for (std::size_t c = 0; c < row.size(); ++c) {
    if (c > 0) line += ',';
    if (!empty_ || !std::isnan(row[c])) line += fmt::format("{:.17g}", row[c]);
  }
  line += '\n';
  if (std::fwrite(line.data(), 1, line.size(), file_.get()) != line.size() || std::fflush(file_.get()) != 0)
    detail::throw_file_error(path_, "write");
  ++rows_;
}

void HistoryWriter::sync() {
  const int descriptor = ::fileno(file_.get());
  if (!detail::names_open_file(path_, descriptor))
    throw FileError(path_ + ": was removed or replaced while the run wrote there");
  if (::fdatasync(descriptor) != 0 && errno != EINVAL && errno != EROFS) detail::throw_file_error(path_, "write");
}

}  // namespace vug
