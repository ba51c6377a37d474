#pragma once
// What is wrong with the state of a run although it goes on: for the log and for run.json.
#include "base/base.hpp"
#include "io/time_table.hpp"

#include <string>
#include <vector>

namespace vug {

/// `what` names it and is reported once in a run, followed by `detail`: numbers, cause, advice.
struct Concern {
  std::string what, detail;
};

/// A module whose state may be impossible while the run goes on.
class Concerned {
 public:
  virtual ~Concerned() = default;
  /// What is wrong at present. Called by all ranks after each guard; may wait for the device.
  virtual std::vector<Concern> concerns(const Exec& exec) const = 0;
};

/// Boundaries whose given flux draws or puts in: the key of the first of each, else empty.
struct GivenFluxes {
  std::string draws, puts_in;
  void add(const std::string& key, const TimeTable& flux);
};

}  // namespace vug
