#pragma once
// Traffic between this rank and the others, and the time that it waits for them, by phase of a run.
#include "ranks/ranks.hpp"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace vug {

/// Traffic of one rank in one phase.
struct Traffic {
  std::string phase;
  std::int64_t messages = 0;     ///< received from neighbours
  std::int64_t bytes = 0;        ///< received with them
  std::int64_t collectives = 0;  ///< that all ranks took part in
  std::int64_t collected = 0;    ///< bytes received from others with them
  double waited = 0;             ///< s of wall time within MPI, for other ranks and for the transfer
  double passed = 0;             ///< s of wall time of the phase, waiting included
};

/// Counts exchanges and time until the end of its scope for this phase, and not for the one around it. Costs two
/// readings of the clock; nothing where there is one rank.
class Phase {
 public:
  Phase(const Ranks& ranks, std::string_view name);
  ~Phase();
  Phase(const Phase&) = delete;
  Phase& operator=(const Phase&) = delete;

 private:
  int outer_ = -1;  ///< number of the phase around it; -1: nothing is counted
};

/// Counts an exchange for the current phase, from construction to destruction.
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

/// Traffic of this rank since its start, phases in the order of their first use; the first is for what belongs to none.
const std::vector<Traffic>& traffic();

/// Table of the traffic over `steps` steps, one line per phase in which something came from other ranks: mean and
/// largest over the ranks. Called by all ranks; empty except on the first one.
std::vector<std::string> traffic_table(const Ranks& ranks, std::int64_t steps);

}  // namespace vug
