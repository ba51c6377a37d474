#include "io/history_reader.hpp"

#include "base/require.hpp"
#include "io/detail/nearest_name.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <fstream>
#include <iterator>
#include <limits>
#include <string_view>

namespace vug {

namespace {

std::vector<std::string_view> cells_of(std::string_view line) {
  std::vector<std::string_view> cells;
  for (std::size_t from = 0; from <= line.size();) {
    const std::size_t to = std::min(line.find(',', from), line.size());
    cells.push_back(line.substr(from, to - from));
    from = to + 1;
  }
  return cells;
}

}  // namespace

int History::find(const std::string& name) const {
  const auto at = std::find(names.begin(), names.end(), name);
  return at == names.end() ? -1 : static_cast<int>(at - names.begin());
}

std::vector<int> History::find_all(const std::vector<std::string>& wanted, const std::string& where) const {
  std::vector<int> columns;
  for (const std::string& name : wanted) {
    columns.push_back(find(name));
    if (columns.back() < 0)
      throw InputError(fmt::format("{}\"{}\" is no column of the history{}", where, name, suggestion(name, names)));
  }
  return columns;
}

History read_history(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  if (!file) throw FileError(path + ": cannot be read");
  History history;
  std::size_t line_number = 0;
  for (std::size_t from = 0, to; (to = text.find('\n', from)) != std::string::npos; from = to + 1) {
    const auto cells = cells_of(std::string_view(text).substr(from, to - from));
    if (++line_number == 1) {
      history.names.assign(cells.begin(), cells.end());
      history.values.resize(cells.size());
      continue;
    }
    if (cells.size() != history.names.size())
      throw FileError(
          fmt::format("{}:{}: has {} cells, the header has {}", path, line_number, cells.size(), history.names.size()));
    for (std::size_t c = 0; c < cells.size(); ++c) {
      double value = 0;
      if (cells[c].empty() && history.names[c].starts_with("bar_of_")) {  // of error_bars.csv: unknown
        history.values[c].push_back(std::numeric_limits<double>::quiet_NaN());
        continue;
      }
      const char* end = cells[c].data() + cells[c].size();
      if (cells[c].empty() || std::from_chars(cells[c].data(), end, value).ptr != end)
        throw FileError(fmt::format("{}:{}: {} is not a number", path, line_number, history.names[c]));
      history.values[c].push_back(value);
    }
  }
  return history;
}

}  // namespace vug
