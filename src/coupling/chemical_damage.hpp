#pragma once
// What dissolution takes from triangles and bonds.
#include "coupling/wet_nodes.hpp"

namespace vug {

/// What dissolution leaves of triangles and bonds: dissolved volume of the nodes over their initial solid volume, by
/// sectors; nothing is missing where there was no solid. A bond carries by its two sectors in series
/// (dem/dissolved_rock.hpp), for which Eq. 25 takes their sum. Solid that an opening crack hands to other nodes is not
/// dissolved and does not count.
///
/// Rock dissolves at wet nodes only, and a node stays wet until it turns fluid. So an update sums over the wet nodes
/// and keeps one number for all that have turned fluid: it costs the surface, not the lattice.
class DissolvedShares {
 public:
  /// volume: (dense node) initial, pixels. sectors_of_bond: (bond, end) the sectors on both sides of its edge.
  DissolvedShares(const Exec& exec, const NodeGroups& nodes_of_sector, const SectorPairs& sectors_of_bond,
                  const ScalarField<double>& volume);

  /// dissolved: (dense node), pixels.
  void update(const Exec& exec, const WetNodes& wet, const ScalarField<double>& dissolved) const;
  /// To be called when nodes have turned fluid, before the wet nodes are found anew.
  void settle(const Exec& exec, const WetNodes& wet, const Kokkos::View<NodeType*>& type,
              const ScalarField<double>& dissolved) const;

  /// (triangle) share of the solid that remained at the last update.
  const ScalarField<double>& solid_fraction() const { return solid_fraction_; }
  /// (bond) chemical damage then.
  const ScalarField<double>& d_c() const { return d_c_; }
  /// (sector) dissolved volume of the nodes that have turned fluid, pixels: belongs in a checkpoint.
  const ScalarField<double>& settled() const { return settled_; }

 private:
  SectorPairs sectors_of_bond_;
  ScalarField<double> initial_;  ///< (sector) solid volume, pixels
  ScalarField<double> settled_;
  ScalarField<double> sum_;  ///< (sector) dissolved volume at the last update, pixels
  ScalarField<double> solid_fraction_, d_c_;
};

}  // namespace vug
