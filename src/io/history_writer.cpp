#include "io/history_writer.hpp"

#include "io/detail/files.hpp"
#include "kernels/base/require.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <sstream>

namespace vug {

namespace {

// The header and the whole rows up to `time`.
std::string kept_rows(const std::string& path, const std::string& header, double time) {
  std::istringstream in(detail::read_file(path));
  std::string line;
  if (!std::getline(in, line) || line != header)
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
  kept_ = std::count(text.begin(), text.end(), '\n') - 1;
  detail::replace_file(path, text, false);
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
}

}  // namespace vug
