#pragma once
// What goes between this rank and the others, and how long it waits for them, by phase of a run.
#include "ranks/ranks.hpp"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace vug {

/// Of one rank in one phase.
struct Traffic {
  std::string phase;
  std::int64_t messages = 0;     ///< that came from neighbours
  std::int64_t bytes = 0;        ///< that these held
  std::int64_t collectives = 0;  ///< that all ranks took part in
  std::int64_t collected = 0;    ///< bytes that came from others with them
  double waited = 0;             ///< s of wall time within MPI: for others and for what travels
  double passed = 0;             ///< s of wall time of the phase, waiting included
};

/// What is exchanged and passes until the end of its scope is counted for this phase, and not for the one around it.
/// Two looks at the clock; nothing where there is one rank.
class Phase {
 public:
  Phase(const Ranks& ranks, std::string_view name);
  ~Phase();
  Phase(const Phase&) = delete;
  Phase& operator=(const Phase&) = delete;

 private:
  int outer_ = -1;  ///< number of the phase around it; -1: nothing is counted
};

/// An exchange, from its making to its end, for the phase of now.
class Exchange {
 public:
  static Exchange of_neighbours(std::int64_t messages, std::int64_t bytes) { return {messages, bytes, 0, 0}; }
  static Exchange of_all(std::int64_t bytes) { return {0, 0, 1, bytes}; }
  ~Exchange();
  Exchange(const Exchange&) = delete;
  Exchange& operator=(const Exchange&) = delete;

 private:
  Exchange(std::int64_t messages, std::int64_t bytes, std::int64_t collectives, std::int64_t collected);
  double begun_;
};

/// Of this rank since its start, phases in the order of their first time; the first is what belongs to none.
const std::vector<Traffic>& traffic();

/// A table of it over `steps` steps, one line per phase in which something came from others: mean and largest of the
/// ranks. Called by all ranks; empty but on the first one.
std::vector<std::string> traffic_table(const Ranks& ranks, std::int64_t steps);

}  // namespace vug
