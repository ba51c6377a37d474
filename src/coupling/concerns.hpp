#pragma once
// What is wrong with the state of a run although it goes on: for the log and for run.json.
#include "io/time_table.hpp"

#include <string>

namespace vug {

/// `what` names it and is reported once in a run, followed by `detail`: numbers, cause, advice.
struct Concern {
  std::string what, detail;
};

/// Boundaries whose given flux draws or puts in: the key of the first of each, else empty.
struct GivenFluxes {
  std::string draws, puts_in;
  void add(const std::string& key, const TimeTable& flux);
};

}  // namespace vug
