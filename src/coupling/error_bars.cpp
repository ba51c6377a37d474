#include "coupling/error_bars.hpp"

#include "base/require.hpp"
#include "coupling/history_difference.hpp"
#include "coupling/recorded_run.hpp"
#include "host/interruption.hpp"
#include "io/history_writer.hpp"
#include "io/time_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <ostream>
#include <span>
#include <string_view>

namespace vug {

namespace {

/// Whether a column is an amount that has an error: not a count, a step, the error of a balance or an initial value.
bool has_a_bar(std::string_view name) {
  return !name.ends_with("_1") && name != "time_s" && name.find("_initial_") == std::string_view::npos;
}

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

ErrorBar bar_of(double value, std::span<const double> twins, double ratio, bool staircase) {
  // halved intervals: errors are of first order, so that e = 2 (value - finer); a quarter is added as for lattices
  if (ratio == 0) return {2.5 * std::abs(value - twins[0]), std::nullopt, Convergence::unknown};
  return error_bar(value, twins[0], twins.size() > 1 ? std::optional(twins[1]) : std::nullopt, ratio, staircase);
}

/// Forgets the bars where the only twin agrees to the last bit: this says that what the twin varies does not change the
/// amount, not that the amount is right. The first row keeps its bar of 0, because both start with what the case gives,
/// unless no row differs at all, as for the elastic energy after a preload.
void forget_agreement(const std::vector<double>& value, const TimeTable& twin, const std::vector<double>& time,
                      std::vector<double>& bar) {
  bool any = false;
  for (std::size_t k = bar.size(); k-- > 0;) {
    const bool differs = value[k] != twin.at(time[k]);
    any = any || differs;
    if (!differs && (k > 0 || !any)) bar[k] = unknown;
  }
}

/// (row) Whether rock has dissolved while no wall of the coarser lattice has moved. A wall moves when a node is used
/// up: until then all lattices have the walls of the start, and what they differ by does not show how far these are
/// behind. `spacing` of `run`, m; 0: the walls are the same on all lattices.
std::vector<bool> where_walls_stand(const History& run, const History& coarser, double spacing) {
  constexpr double notable = 1e-3;  // of a cell, in the mean over the walls
  std::vector<bool> stand(run.rows(), false);
  const int volume = run.find("dissolved_volume_m3_per_m"), area = run.find("reactive_area_m2_per_m"),
            moved = coarser.find("nodes_dissolved_1");
  if (spacing == 0 || volume < 0 || area < 0 || moved < 0) return stand;
  const TimeTable nodes{coarser.time(), coarser.values[static_cast<std::size_t>(moved)]};
  for (std::size_t k = 0; k < stand.size(); ++k)
    stand[k] = run.values[volume][k] > notable * run.values[area][k] * spacing && nodes.at(run.time()[k]) == 0;
  return stand;
}

/// X of the columns X_initial, X_stored and X_gain_<what> of a balance; empty for other columns.
std::string_view balance_of(std::string_view name) {
  for (const char* part : {"_initial_", "_stored_", "_gain_"})
    if (const std::size_t at = name.find(part); at != std::string_view::npos) return name.substr(0, at);
  return {};
}

/// The largest amount in any column of a balance, in any row.
double largest_of_balance(const History& run, std::string_view balance) {
  double largest = 0;
  for (std::size_t c = 0; c < run.names.size(); ++c)
    if (!run.names[c].ends_with("_1") && balance_of(run.names[c]) == balance)
      for (const double value : run.values[c]) largest = std::max(largest, std::abs(value));
  return largest;
}

const char* remark(const ErrorBar& error) {
  if (error.convergence == Convergence::walls_stand)
    return "no bar: rock dissolves, but no wall of the coarser lattices has moved yet";
  if (std::isnan(error.bar)) return "no bar: the one comparison agrees, nothing it varies changes this";
  switch (error.convergence) {
    case Convergence::monotone:
      return "";
    case Convergence::by_chance:
      return "warning: order by chance, walls are staircases; use a finer lattice";
    case Convergence::oscillating:
      return "warning: oscillates from lattice to lattice";
    case Convergence::none:
      return "warning: does not converge; use a finer lattice";
    case Convergence::rounding:
      return "rounding of larger amounts: 0";
    case Convergence::walls_stand:
    case Convergence::unknown:
      return "one comparison only: no order";
  }
  return "";
}

std::string report(const ErrorBars& bars) {
  std::string text = fmt::format("{:<52} {:>12} {:>9} {:>8} {:>6}\n", "at the end", "value", "+-", "", "order");
  for (const BarOfColumn& column : bars.last) {
    const bool known = !std::isnan(column.error.bar);
    const std::string bar = known ? fmt::format("{:.2g}", column.error.bar) : "-";
    const std::string percent =
        known && column.value != 0 ? fmt::format("{:.2g} %", 100 * column.error.bar / std::abs(column.value)) : "";
    const std::string order = column.error.order ? fmt::format("{:.1f}", *column.error.order) : "";
    text += fmt::format("{:<52} {:>12.5g} {:>9} {:>8} {:>6}  {}\n", column.name, column.value, bar, percent, order,
                        remark(column.error));
  }
  return text;
}

void write(const ErrorBars& bars, const std::string& path) {
  std::vector<std::string> header{"time_s"};
  for (const std::string& name : bars.names) {
    header.push_back(name);
    header.push_back("bar_of_" + name);
  }
  HistoryWriter file(path, header);
  file.leave_unknown_empty();
  std::vector<double> row(header.size());
  for (std::size_t k = 0; k < bars.time.size(); ++k) {
    row[0] = bars.time[k];
    for (std::size_t c = 0; c < bars.names.size(); ++c) {
      row[1 + 2 * c] = bars.value[c][k];
      row[2 + 2 * c] = bars.bar[c][k];
    }
    file.write(row);
  }
}

}  // namespace

bool has_staircases(const Scene& scene) {
  const std::vector<Shape>& shapes = scene.geometry.shapes;
  return scene.geometry.kind == GeometryKind::image ||
         std::any_of(shapes.begin(), shapes.end(),
                     [](const Shape& shape) { return !std::holds_alternative<Rectangle>(shape.form); });
}

ErrorBars find_error_bars(const History& run, const std::vector<History>& twins, double ratio, double rounding,
                          double sound, double spacing, bool staircase) {
  ErrorBars bars;
  const std::vector<bool> walls_stand = where_walls_stand(run, twins.front(), spacing);
  bars.time = run.time();
  std::vector<double> others(twins.size());
  for (std::size_t c = 0; c < run.names.size(); ++c) {
    const std::string& name = run.names[c];
    if (!has_a_bar(name)) continue;
    std::vector<TimeTable> of_twins;
    for (const History& twin : twins)
      if (const int column = twin.find(name); column >= 0)
        of_twins.push_back({twin.time(), twin.values[static_cast<std::size_t>(column)]});
    if (of_twins.size() < twins.size()) continue;
    std::vector<double> bar;
    ErrorBar last;
    for (std::size_t k = 0; k < run.rows(); ++k) {
      for (std::size_t t = 0; t < twins.size(); ++t) others[t] = of_twins[t].at(bars.time[k]);
      last = bar_of(run.values[c][k], others, ratio, staircase);
      bar.push_back(last.bar);
    }
    if (twins.size() == 1) forget_agreement(run.values[c], of_twins[0], bars.time, bar);
    if (!bar.empty()) last.bar = bar.back();
    if (const std::string_view balance = balance_of(name); !balance.empty() && !bar.empty()) {
      double size = std::abs(run.values[c].back());
      for (const double other : others) size = std::max(size, std::abs(other));
      if (size > 0 && size <= rounding * largest_of_balance(run, balance))
        last = {last.bar, std::nullopt, Convergence::rounding};
    }
    if (is_rounding_of_velocity(run, static_cast<int>(c), sound, std::max(rounding, rounding_share)))
      last = {last.bar, std::nullopt, Convergence::rounding};
    for (std::size_t k = 0; k < bar.size(); ++k)
      if (walls_stand[k]) bar[k] = unknown;
    if (!bar.empty() && walls_stand.back()) last = {unknown, std::nullopt, Convergence::walls_stand};
    bars.names.push_back(name);
    bars.value.push_back(run.values[c]);
    bars.bar.push_back(std::move(bar));
    bars.last.push_back({name, bars.value.back().back(), last});
  }
  return bars;
}

std::string run_with_error_bars(const Scene& scene, const RunOptions& options) {
  Twins found = find_twins(scene);  // throws before anything runs
  RunOptions own = options;
  own.directory = run_directory(scene, options.directory);
  own.words_when_done = "interrupted; the run itself is done, --resume goes on with its error bars";
  run_case(scene, own);
  const History history = read_history(own.directory + "/history.csv");
  std::vector<History> histories;
  std::string left_out;
  for (const Twin& twin : found.twins) {
    if (stop_requested())  // requested in the last step of the run before
      throw Interrupted(stop_reason() + "; the run itself is done, --resume goes on with its error bars");
    RunOptions of_twin = own;
    of_twin.directory = own.directory + "/" + twin.folder;
    if (options.steps && found.ratio > 0)
      of_twin.steps = steps_over(*options.steps, twin.scene.lattice.spacing / scene.lattice.spacing);
    if (options.progress) *options.progress << "error bars: " << of_twin.directory << '\n';
    try {
      run_case(twin.scene, of_twin);
      histories.push_back(read_history(of_twin.directory + "/history.csv"));
    } catch (const StabilityError& error) {
      left_out = fmt::format("left out, {}: {}\n", of_twin.directory, error.what());
    } catch (const InputError& error) {  // too fast for a coarser lattice, or a folder that is not vug's
      left_out = fmt::format("left out, {}: {}\n", of_twin.directory, error.what());
    }
    if (!left_out.empty()) break;  // an even coarser lattice would fail as well
  }
  if (histories.empty()) return left_out + "no error bars: there is nothing to compare with\n";
  const bool coarse = scene.accuracy.precision == Precision::single_precision;
  const ErrorBars bars =
      find_error_bars(history, histories, found.ratio, coarse ? 1e-5 : 1e-12, speed_of_sound(scene.lattice),
                      found.ratio > 0 ? scene.lattice.spacing : 0, has_staircases(scene));
  write(bars, own.directory + "/error_bars.csv");
  return report(bars) + left_out;
}

}  // namespace vug
