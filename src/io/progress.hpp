#pragma once
// Shows how far the run is: a bar on a terminal, plain lines in a log.
#include "host/this_process.hpp"

#include <cstdint>
#include <deque>
#include <functional>
#include <ostream>
#include <string>
#include <string_view>

namespace vug {

/// A duration for people: "42 s", "3 min 20 s", "5 h 07 min", "2 d 3 h"; "unknown" where there is none.
std::string duration_text(double seconds);

/// Columns of the terminal at the standard error stream; none where that is no terminal.
int terminal_columns();

/// Reports time, steps per second, MLUPS and the time left, from the speed of the last half minute. On a terminal one
/// line, no longer than it is wide, is redrawn five times a second. In a log a line is added every 5 %, but at most
/// every two seconds; where 5 % take longer, also after 5, 10, 20, 40 and then every 60 seconds.
class Progress {
 public:
  struct Run {
    std::int64_t first_step = 0, last_step = 0;
    double time_step = 0;         ///< s
    double updates_per_step = 0;  ///< lattice-node updates of all fields together
    bool quiet = false;           ///< warnings only
    double ahead = 0;             ///< s, at the first step, as for update()
  };
  Progress(std::ostream& out, bool terminal, const Run& run, std::function<double()> clock = steady_seconds,
           std::function<int()> columns = terminal_columns);

  /// Cheap enough to be called in every step of a small lattice. `updates_per_step` may change, because the fluid
  /// grows. `ahead` (s): how much further the time is than the steps alone make it.
  void update(std::int64_t step, double updates_per_step, double ahead = 0);
  void update(std::int64_t step) { update(step, run_.updates_per_step); }
  /// Writes a line of its own: a physical event or a warning ("warning: ..." at its start, or after the step).
  void note(std::string_view line);
  /// Writes the last line, with the averages of the whole run.
  void finish(std::string_view reason);

  double steps_per_second() const;
  /// Averages over the whole run.
  double wall_time() const { return clock_() - start_; }
  double mlups() const;

 private:
  struct Sample {
    double time;
    std::int64_t step;
    double simulated;
  };
  bool due(double now) const;
  std::string line() const;
  std::string bar() const;
  std::string fitted() const;
  double simulated() const { return static_cast<double>(step_) * run_.time_step + ahead_; }
  double end() const { return static_cast<double>(run_.last_step) * run_.time_step; }
  double fraction() const;

  std::ostream& out_;
  bool terminal_;
  Run run_;
  std::function<double()> clock_;
  std::function<int()> columns_;
  double start_, shown_, interval_ = 5;
  std::int64_t step_;
  double ahead_, shown_fraction_ = 0;
  double updates_ = 0;  // so far
  std::deque<Sample> window_;
};

}  // namespace vug
