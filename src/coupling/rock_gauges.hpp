#pragma once
// The gauges of a case in the rock, as columns of history.csv.
#include "coupling/history_value.hpp"
#include "dem/gauges.hpp"
#include "dem/mechanics.hpp"
#include "io/scene.hpp"

#include <functional>
#include <vector>

namespace vug {

/// The quantities of [[output.gauges]]. Without gauges nothing is allocated or launched.
class RockGauges {
 public:
  /// Throws InputError where there is no rock at a gauge.
  RockGauges(const Scene& scene, const Assembly& assembly, const Mechanics& rock);
  void history(std::vector<HistoryValue>& row) const;

 private:
  using Read = std::function<void(const Exec&, std::vector<HistoryValue>&)>;
  std::vector<Read> gauges_;
};

}  // namespace vug
