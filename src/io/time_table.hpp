#pragma once
// A number in a case that may change in time.
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace vug {

/// A number, or a table of numbers over time: linear between its points, constant before the first and after the last.
class TimeTable {
 public:
  TimeTable(double value = 0) : value_{value}, lowest_(value), highest_(value), peak_(value) {}
  /// `time` (s) ascends; `value` has the same length.
  TimeTable(std::vector<double> time, std::vector<double> value)
      : time_(std::move(time)),
        value_(std::move(value)),
        lowest_(*std::min_element(value_.begin(), value_.end())),
        highest_(*std::max_element(value_.begin(), value_.end())),
        peak_(*std::max_element(value_.begin(), value_.end(),
                                [](double a, double b) { return std::abs(a) < std::abs(b); })) {}

  bool constant() const { return value_.size() == 1; }
  /// Value at a time (s).
  double at(double time) const {
    const auto next = std::upper_bound(time_.begin(), time_.end(), time) - time_.begin();
    if (constant() || next == 0) return value_.front();
    if (next == static_cast<std::ptrdiff_t>(time_.size())) return value_.back();
    const double share = (time - time_[next - 1]) / (time_[next] - time_[next - 1]);
    return value_[next - 1] + share * (value_[next] - value_[next - 1]);
  }
  /// Times of its points, s; empty for a number.
  const std::vector<double>& moments() const { return time_; }
  double lowest() const { return lowest_; }
  double highest() const { return highest_; }
  /// The value farthest from zero, with its sign.
  double peak() const { return peak_; }
  /// Largest |value - rest| up to a time (s), and at the point that follows it.
  double farthest(double rest, double until) const {
    double distance = 0;
    for (std::size_t k = 0; k < value_.size(); ++k) {
      distance = std::max(distance, std::abs(value_[k] - rest));
      if (!constant() && time_[k] > until) break;
    }
    return distance;
  }
  /// Time after which the value is constant, s.
  double settled() const { return constant() ? 0 : time_.back(); }
  /// The shortest time between two points of different values, s; infinity for a number.
  double quickest() const {
    double shortest = std::numeric_limits<double>::infinity();
    for (std::size_t k = 1; k < time_.size(); ++k)
      if (value_[k] != value_[k - 1]) shortest = std::min(shortest, time_[k] - time_[k - 1]);
    return shortest;
  }

 private:
  std::vector<double> time_;  ///< empty for a number
  std::vector<double> value_;
  double lowest_, highest_, peak_;  ///< found once: tables may be long, and many ask
};

}  // namespace vug
