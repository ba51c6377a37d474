#pragma once
// What dissolution takes from triangles and bonds.
#include "coupling/wet_nodes.hpp"

namespace vug {

/// Shares of the solid volume of triangles and bonds that have dissolved: dissolved volume of the nodes over their
/// initial solid volume, between 0 and 1; 0 where there was no solid. For bonds this is d_c = 1 - m_c / m_c0 (Eq. 25):
/// solid that an opening crack hands to other nodes is not dissolved and does not count.
///
/// Rock dissolves at wet nodes only, and a node stays wet until it turns fluid. So an update sums over the wet nodes
/// and keeps one number for all that have turned fluid: it costs the surface, not the lattice.
class DissolvedShares {
 public:
  /// volume: (dense node) initial, pixels. sectors_of_bond: (bond, end) the sectors on both sides of its edge.
  DissolvedShares(const Exec& exec, const NodeGroups& nodes_of_sector, const SectorPairs& sectors_of_bond,
                  const ScalarField<double>& volume);

  /// solid_fraction (triangle) = what remains; d_c (bond). dissolved: (dense node), pixels.
  void update(const Exec& exec, const WetNodes& wet, const ScalarField<double>& dissolved,
              const ScalarField<double>& solid_fraction, const ScalarField<double>& d_c) const;
  /// To be called when nodes have turned fluid, before the wet nodes are found anew.
  void settle(const Exec& exec, const WetNodes& wet, const Kokkos::View<NodeType*>& type,
              const ScalarField<double>& dissolved) const;

  /// (sector) dissolved volume of the nodes that have turned fluid, pixels: belongs in a checkpoint.
  const ScalarField<double>& settled() const { return settled_; }

 private:
  SectorPairs sectors_of_bond_;
  ScalarField<double> triangle_volume_, bond_volume_;  ///< initial, pixels
  ScalarField<double> settled_;
  ScalarField<double> sum_;  ///< (sector) of the present update
};

}  // namespace vug
