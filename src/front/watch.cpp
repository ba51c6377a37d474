#include "front/watch.hpp"

#include "base/require.hpp"
#include "io/progress.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <thread>

namespace vug {

namespace {

bool ends_in_balance_error(const std::string& name) {
  return name.ends_with("_balance_error_1");
}

/// Whether a column is a part of a balance, or is shown in the first line already.
bool is_secondary(const std::string& name) {
  if (name == "time_s" || name == "step_1" || ends_in_balance_error(name)) return true;
  return name.find("_initial_") != std::string::npos || name.find("_stored_") != std::string::npos ||
         name.find("_gain_") != std::string::npos;
}

bool changes(const std::vector<double>& values) {
  return std::any_of(values.begin(), values.end(), [&](double value) { return value != values.front(); });
}

/// Indices of the columns to draw.
std::vector<int> chosen_columns(const History& history, const WatchView& view) {
  std::vector<int> chosen = history.find_all(view.columns);
  if (!chosen.empty()) return chosen;
  constexpr int other_lines = 5;
  for (std::size_t c = 0; c < history.names.size(); ++c)
    if (!is_secondary(history.names[c]) && changes(history.values[c])) chosen.push_back(static_cast<int>(c));
  const auto room = static_cast<std::size_t>(std::max(1, view.height - other_lines));
  if (chosen.size() > room) chosen.resize(room);
  return chosen;
}

double number(const std::string& text) {
  return text.empty() ? 0 : std::strtod(text.c_str(), nullptr);
}

/// State of a run: "done", "running", ..., or the possible ones where it cannot be determined.
std::string status_of(const WatchedRun& run) {
  if (run.summary.status != "running" || run.in_use == InUse::yes) return run.summary.status;
  if (run.in_use == InUse::no) return "ended without a word (killed?)";
  const std::string row =
      run.since_last_row < 0 ? "no row yet" : "last row " + duration_text(run.since_last_row) + " ago";
  return fmt::format("running, or ended without a word: {}; {}", run.doubt, row);
}

/// Such as "running, step 1200 of 4000 (30 %), 0.012 s of physical time, 3 min 20 s left".
std::string state_of(const WatchedRun& run) {
  const RunSummary& summary = run.summary;
  const bool running = summary.status == "running";
  const int steps = run.history.find("step_1");
  const bool begun = run.history.rows() > 0 && steps >= 0;
  const double step = running && begun ? run.history.values[steps].back() : number(summary.steps);
  const double last = number(summary.last_step), first = number(summary.first_step);
  std::string text = status_of(run);
  text += last > 0 ? fmt::format(", step {:.0f} of {:.0f} ({:.0f} %)", step, last, 100 * step / last)
                   : fmt::format(", step {:.0f}", step);
  if (begun) text += fmt::format(", {:.4g} s of physical time", run.history.time().back());
  if (running && run.in_use == InUse::yes && step > first && last > step)
    text += ", " + duration_text(run.seconds * (last - step) / (step - first)) + " left";
  if (!summary.exit_reason.empty()) text += "\n" + summary.exit_reason;
  return text;
}

/// The balance with the largest error in the last row.
std::string worst_balance(const History& history) {
  int worst = -1;
  for (std::size_t c = 0; c < history.names.size(); ++c)
    if (ends_in_balance_error(history.names[c]) &&
        (worst < 0 || std::abs(history.values[c].back()) > std::abs(history.values[worst].back())))
      worst = static_cast<int>(c);
  if (worst < 0) return "";
  const std::string& name = history.names[worst];
  return fmt::format("largest error of a balance: {:.1e} ({})\n", std::abs(history.values[worst].back()),
                     name.substr(0, name.size() - std::string_view("_balance_error_1").size()));
}

/// Seconds since a time in UTC, ISO 8601; 0 if it is not a time.
double seconds_since(const std::string& started) {
  std::tm parts{};
  if (::strptime(started.c_str(), "%Y-%m-%dT%H:%M:%SZ", &parts) == nullptr) return 0;
  return std::max(0.0, std::difftime(std::time(nullptr), ::timegm(&parts)));
}

WatchedRun look(const std::string& directory) {
  const std::optional<RunSummary> summary = read_run_summary(directory);
  if (!summary) throw InputError(directory + ": holds no run (it has no run.json)");
  WatchedRun run;
  run.summary = *summary;
  run.seconds = seconds_since(summary->started);
  run.in_use = is_in_use(directory, &run.doubt);
  const std::string path = directory + "/history.csv";
  if (!std::filesystem::exists(path)) return run;
  run.history = read_history(path);
  std::error_code none;
  const auto written = std::filesystem::last_write_time(path, none);
  if (const auto age = std::filesystem::file_time_type::clock::now() - written; !none && run.history.rows() > 0)
    run.since_last_row = std::max(0.0, std::chrono::duration<double>(age).count());
  return run;
}

}  // namespace

std::string sparkline(const std::vector<double>& time, const std::vector<double>& values, int width) {
  constexpr const char* blocks[] = {"▁", "▂", "▃", "▄", "▅", "▆", "▇", "█"};
  if (values.empty()) return "";
  double low = INFINITY, high = -INFINITY;
  for (const double value : values)
    if (std::isfinite(value)) {
      low = std::min(low, value);
      high = std::max(high, value);
    }
  std::string line;
  std::size_t row = 0;
  for (int i = 0; i < width; ++i) {
    const double moment = time.front() + (time.back() - time.front()) * (i + 1) / width;
    while (row + 1 < time.size() && time[row + 1] <= moment) ++row;
    const double share = high > low ? (values[row] - low) / (high - low) : 0.0;
    line += std::isfinite(values[row]) ? blocks[std::clamp(static_cast<int>(8 * share), 0, 7)] : "!";
  }
  return line;
}

std::string watch_text(const WatchedRun& run, const WatchView& view) {
  std::string text = state_of(run) + "\n\n";
  const History& history = run.history;
  if (history.rows() == 0) return text + "no row of history.csv yet\n";
  const std::vector<int> columns = chosen_columns(history, view);
  std::size_t longest = 0;
  for (const int c : columns) longest = std::max(longest, history.names[c].size());
  const int names = std::min<int>(static_cast<int>(longest), view.width / 2);
  constexpr int of_value = 12;
  for (const int c : columns)
    text += fmt::format("{:<{}} {} {:>{}.4g}\n", history.names[c].substr(0, static_cast<std::size_t>(names)), names,
                        sparkline(history.time(), history.values[c], std::max(8, view.width - names - of_value - 2)),
                        history.values[c].back(), of_value);
  return text + worst_balance(history);
}

bool watch(const std::string& directory, const WatchView& view, bool once,
           const std::function<void(const std::string&)>& show) {
  while (true) {
    const WatchedRun run = look(directory);
    show(watch_text(run, view));
    if (once || !run.under_way()) return run.under_way() || run.summary.status == "done";
    std::this_thread::sleep_for(std::chrono::seconds(1));
  }
}

}  // namespace vug
