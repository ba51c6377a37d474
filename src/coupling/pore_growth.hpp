#pragma once
// Solid nodes that become fluid: pixels that have dissolved, pathways that damage opens.
#include "coupling/geometry.hpp"
#include "coupling/module.hpp"
#include "coupling/pathways.hpp"
#include "coupling/slits.hpp"
#include "kernels/reaction/dissolution.hpp"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace vug {

/// Finds new fluid nodes between steps, at a small interval, and reports them to every module. Writes the geometry.
class PoreGrowth {
 public:
  /// Volume that dissolving pixels were overdrawn by and no node took; empty without dissolution.
  struct Losses {
    ScalarField<double> all;
    MineralLosses of_minerals;
    std::vector<std::string> names;  ///< names of the minerals in the ledger; "" for one that does not occur
  };
  /// `opener` is null and `d_m` empty without damage.
  PoreGrowth(Geometry& geometry, std::unique_ptr<PathwayOpener> opener, ScalarField<double> d_m, Losses lost);

  /// Opens the nodes that are due and returns their number. Waits for the device.
  int grow(const Exec& exec, const std::vector<std::unique_ptr<Module>>& modules);

  /// Adds the solid of opened nodes that found no room to the balance of solid volume.
  void ledger(Ledger& ledger, double pixel_volume) const;
  void state(StateList& list);
  void restored(const Exec& exec) {
    if (slits_) slits_->restored(exec, geometry_);
  }

  std::int64_t dissolved_nodes() const { return dissolved_nodes_; }
  std::int64_t opened_nodes() const { return opened_nodes_; }
  /// Number of nodes in cracks narrower than a cell; -1 where pathways are rows of nodes.
  int slit_nodes() const { return below_a_cell() ? geometry_.slits.count : -1; }

 private:
  /// Whether pathways may be narrower than a cell.
  bool below_a_cell() const { return opener_ && (opener_->follows_cracks() || opener_->nodes().cubic); }

  Geometry& geometry_;
  std::unique_ptr<PathwayOpener> opener_;
  std::optional<Slits> slits_;
  ScalarField<double> d_m_;
  Losses lost_;
  std::int64_t dissolved_nodes_ = 0, opened_nodes_ = 0;
};

}  // namespace vug
