#include "ranks/traffic.hpp"

#include "host/this_process.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#ifdef VUG_MPI
#include <mpi.h>
#endif

namespace vug {

namespace {

/// Counts of this process.
struct Counts {
  std::vector<Traffic> phases{{.phase = "elsewhere"}};
  int current = 0;
  double since = steady_seconds();

  /// Ends the current phase and begins another.
  void turn_to(int phase) {
    const double time = steady_seconds();
    phases[current].passed += time - since;
    since = time;
    current = phase;
  }
  int number_of(std::string_view name) {
    for (std::size_t k = 0; k < phases.size(); ++k)
      if (phases[k].phase == name) return static_cast<int>(k);
    phases.push_back({.phase = std::string(name)});
    return static_cast<int>(phases.size()) - 1;
  }
};

Counts& counts() {
  static Counts all;
  return all;
}

/// Sum and largest value over the ranks, on the first one.
struct OverRanks {
  double sum = 0, most = 0;
};

OverRanks over_ranks([[maybe_unused]] const Ranks& ranks, double value) {
  OverRanks sum_and_most{value, value};
#ifdef VUG_MPI
  if (!ranks.alone()) {
    MPI_Reduce(&value, &sum_and_most.sum, 1, MPI_DOUBLE, MPI_SUM, 0, MPI_COMM_WORLD);
    MPI_Reduce(&value, &sum_and_most.most, 1, MPI_DOUBLE, MPI_MAX, 0, MPI_COMM_WORLD);
  }
#endif
  return sum_and_most;
}

}  // namespace

Phase::Phase(const Ranks& ranks, std::string_view name) {
  if (ranks.alone()) return;
  outer_ = counts().current;
  counts().turn_to(counts().number_of(name));
}

Phase::~Phase() {
  if (outer_ >= 0) counts().turn_to(outer_);
}

Exchange::Exchange(std::int64_t messages, std::int64_t bytes, std::int64_t collectives, std::int64_t collected)
    : begun_(steady_seconds()) {
  Traffic& phase = counts().phases[counts().current];
  phase.messages += messages;
  phase.bytes += bytes;
  phase.collectives += collectives;
  phase.collected += collected;
}

Exchange::~Exchange() {
  counts().phases[counts().current].waited += steady_seconds() - begun_;
}

const std::vector<Traffic>& traffic() {
  return counts().phases;
}

std::vector<std::string> traffic_table(const Ranks& ranks, std::int64_t steps) {
  std::string names;
  for (const Traffic& phase : traffic()) names += phase.phase + "\n";
  names = ranks.told(names);
  std::vector<std::string> table{fmt::format("{:12} {:>9} {:>11} {:>11} {:>11} {:>11} {:>11} {:>9} {:>9}", "per step",
                                             "messages", "bytes", "of most", "collectives", "bytes", "ms passed",
                                             "ms waited", "of most")};
  const double per_step = 1.0 / static_cast<double>(std::max<std::int64_t>(steps, 1)), mean = per_step / ranks.size();
  for (std::size_t first = 0, last; first < names.size(); first = last + 1) {
    last = names.find('\n', first);
    const std::string name = names.substr(first, last - first);
    const auto found =
        std::find_if(traffic().begin(), traffic().end(), [&](const Traffic& t) { return t.phase == name; });
    const Traffic ours = found == traffic().end() ? Traffic{} : *found;
    const auto all = [&](auto value) { return over_ranks(ranks, static_cast<double>(value)); };
    const OverRanks messages = all(ours.messages), bytes = all(ours.bytes), collectives = all(ours.collectives);
    const OverRanks collected = all(ours.collected), waited = all(ours.waited), passed = all(ours.passed);
    if (messages.sum + collectives.sum == 0) continue;
    table.push_back(fmt::format("{:12} {:9.3f} {:11.0f} {:11.0f} {:11.3f} {:11.0f} {:11.4f} {:9.4f} {:9.4f}", name,
                                mean * messages.sum, mean * bytes.sum, per_step * bytes.most, mean * collectives.sum,
                                mean * collected.sum, 1e3 * mean * passed.sum, 1e3 * mean * waited.sum,
                                1e3 * per_step * waited.most));
  }
  return ranks.first() ? table : std::vector<std::string>{};
}

}  // namespace vug
