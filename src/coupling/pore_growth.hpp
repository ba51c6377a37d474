#pragma once
// Solid that turns into fluid: pixels that have dissolved, pathways that damage opens.
#include "coupling/geometry.hpp"
#include "coupling/module.hpp"
#include "coupling/pathways.hpp"

#include <functional>
#include <memory>
#include <optional>

namespace vug {

/// Looks for new fluid nodes at a fixed small interval, between steps, and tells every module. Writes the geometry.
class PoreGrowth {
 public:
  /// `d_m` is empty without damage; `lost` is empty without dissolution; `after` runs at every call, grown or not.
  PoreGrowth(Geometry& geometry, std::unique_ptr<PathwayOpener> opener, ScalarField<double> d_m,
             ScalarField<double> lost, std::function<void(const Exec&)> after);

  /// Opens what is due and returns how many nodes turned fluid. Waits for the device.
  int grow(const Exec& exec, const std::vector<std::unique_ptr<Module>>& modules);

  /// What every call of grow ends with: renews what depends on the solid volume (also after a restart).
  void refresh(const Exec& exec) { after_(exec); }

  /// Adds what pathways could not hand on to the balance of solid volume.
  void ledger(Ledger& ledger, double pixel_volume) const;
  void state(StateList& list);

  std::int64_t dissolved_nodes() const { return dissolved_nodes_; }
  std::int64_t opened_nodes() const { return opened_nodes_; }

 private:
  Geometry& geometry_;
  std::unique_ptr<PathwayOpener> opener_;
  ScalarField<double> d_m_, lost_;
  std::function<void(const Exec&)> after_;
  std::int64_t dissolved_nodes_ = 0, opened_nodes_ = 0;
};

}  // namespace vug
