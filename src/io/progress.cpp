#include "io/progress.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <sys/ioctl.h>
#include <unistd.h>

namespace vug {

namespace {

constexpr double window_seconds = 30;

}  // namespace

std::string duration_text(double seconds) {
  if (!std::isfinite(seconds) || seconds > 1e8) return "unknown";
  const auto s = static_cast<std::int64_t>(std::llround(seconds));
  if (s < 60) return fmt::format("{} s", s);
  if (s < 3600) return fmt::format("{} min {:02d} s", s / 60, s % 60);
  if (s < 86400) return fmt::format("{} h {:02d} min", s / 3600, s / 60 % 60);
  return fmt::format("{} d {} h", s / 86400, s / 3600 % 24);
}

int terminal_columns() {
  winsize window{};
  return ioctl(STDERR_FILENO, TIOCGWINSZ, &window) == 0 ? window.ws_col : 0;
}

Progress::Progress(std::ostream& out, bool terminal, const Run& run, std::function<double()> clock,
                   std::function<int()> columns)
    : out_(out),
      terminal_(terminal),
      run_(run),
      clock_(std::move(clock)),
      columns_(std::move(columns)),
      start_(clock_()),
      shown_(start_),
      step_(run.first_step),
      ahead_(run.ahead),
      window_{{start_, run.first_step, simulated()}} {
  shown_fraction_ = fraction();
}

double Progress::fraction() const {
  if (run_.last_step <= 0) return 1;
  const double ahead = run_.time_step > 0 ? ahead_ / run_.time_step : 0;  // added in steps, which stay exact
  return std::clamp((static_cast<double>(step_) + ahead) / static_cast<double>(run_.last_step), 0.0, 1.0);
}

bool Progress::due(double now) const {
  if (terminal_) return now - shown_ >= 0.2;
  const bool far = std::floor(20 * fraction()) > std::floor(20 * shown_fraction_);
  return now - shown_ >= interval_ || (far && now - shown_ >= 2);
}

void Progress::update(std::int64_t step, double updates_per_step, double ahead) {
  run_.updates_per_step = updates_per_step;
  updates_ += static_cast<double>(step - step_) * updates_per_step;
  step_ = step;
  ahead_ = ahead;
  const double now = clock_();
  if (now - window_.back().time >= 0.1 || window_.size() < 2) window_.push_back({now, step, simulated()});
  while (window_.size() > 2 && now - window_.front().time > window_seconds) window_.pop_front();
  if (run_.quiet || !due(now)) return;
  if (now - shown_ >= interval_) interval_ = std::min(60.0, 2 * interval_);
  shown_ = now;
  shown_fraction_ = fraction();
  if (terminal_)
    out_ << "\r\x1b[K" << fitted() << std::flush;
  else
    out_ << line() << '\n' << std::flush;
}

void Progress::note(std::string_view text) {
  if (run_.quiet && text.find("warning: ") == std::string_view::npos) return;
  if (terminal_) out_ << "\r\x1b[K";
  out_ << text << '\n' << std::flush;
}

void Progress::finish(std::string_view reason) {
  if (run_.quiet) return;
  if (terminal_) out_ << "\r\x1b[K";
  const double wall = wall_time();
  out_ << fmt::format("{} at t = {:.4g} s, step {}: {} steps in {}, {:.1f} MLUPS", reason, simulated(), step_,
                      step_ - run_.first_step, duration_text(wall), mlups())
       << '\n'
       << std::flush;
}

double Progress::steps_per_second() const {
  const double seconds = window_.back().time - window_.front().time;
  return seconds > 0 ? static_cast<double>(window_.back().step - window_.front().step) / seconds : 0;
}

double Progress::mlups() const {
  const double wall = wall_time();
  return wall > 0 ? 1e-6 * updates_ / wall : 0;
}

std::string Progress::line() const {
  const double speed = steps_per_second();
  const Sample &first = window_.front(), &last = window_.back();
  const double pace = (last.simulated - first.simulated) / (last.time - first.time);  // simulated time over real time
  return fmt::format("{:3.0f} %  t = {:.4g} of {:.4g} s  step {}  {:.4g} steps/s  {:.1f} MLUPS  ETA {}",
                     std::floor(100 * fraction()), simulated(), end(), step_, speed,
                     1e-6 * speed * run_.updates_per_step,
                     duration_text(pace > 0 ? (end() - simulated()) / pace : INFINITY));
}

std::string Progress::fitted() const {
  const int columns = columns_();
  const std::string text = line();
  if (columns <= 0) return bar() + text;
  const auto room = static_cast<std::size_t>(columns - 1);  // what reaches into the last column may wrap
  return (bar() + text).size() <= room ? bar() + text : text.substr(0, room);
}

std::string Progress::bar() const {
  constexpr int width = 20;
  const int full = static_cast<int>(width * fraction());
  return fmt::format("[{}{}] ", std::string(full, '#'), std::string(width - full, '.'));
}

}  // namespace vug
