#pragma once
// The effect of dissolution on triangles and bonds.
#include "coupling/wet_nodes.hpp"
#include "dem/bonds.hpp"

#include <string>

namespace vug {

/// State when solid last moved between nodes (at first, at the start), for each triangle or sector.
struct SolidMoved {
  ScalarField<double> left;       ///< share of the solid that remained then
  ScalarField<double> dissolved;  ///< volume dissolved in the nodes until then, pixels
  ScalarField<double> held;       ///< solid volume of the nodes then, pixels
  explicit SolidMoved(std::size_t count);
  template <class Visit>
  void visit_state(const std::string& of, const Visit& visit) {
    visit(of + "/left", left);
    visit(of + "/dissolved", dissolved);
    visit(of + "/held", held);
  }
};

/// What dissolution leaves of triangles and bonds, from the solid of their sectors; where there was none at the start,
/// nothing counts as lost. The two sectors of a bond act in series (dem/dissolved_rock.hpp); Eq. 25 takes their sum.
///
/// Without pathways the share that is left is 1 less the dissolved volume of the nodes over their initial solid volume.
/// An opening pathway moves solid from node to node without dissolving it: the share stays, and from then on
///
///     share = share until then * (1 - (dissolved since)/(volume held then)).
///
/// A sector whose nodes have all been opened has from then on the share of its triangle, if that is less.
///
/// Rock dissolves at wet nodes only, and a node stays wet until it turns fluid. An update therefore sums over the wet
/// nodes and keeps one number for all that have turned fluid, so that its cost is that of the surface, not of the
/// lattice.
class DissolvedShares {
 public:
  /// Takes the solid volume of every node (dense node, pixels) as the initial one.
  DissolvedShares(const Exec& exec, const NodeGroups& nodes_of_sector, const SectorPairs& sectors_of_bond,
                  const ScalarField<double>& volume);

  /// dissolved: (dense node), pixels.
  void update(const Exec& exec, const WetNodes& wet, const ScalarField<double>& dissolved) const;
  /// Must be called when opened pathways have moved solid from node to node, before settle.
  void solid_moved(const Exec& exec, const WetNodes& wet, const ScalarField<double>& dissolved,
                   const ScalarField<double>& volume) const;
  /// Must be called when nodes have turned fluid, before the wet nodes are found again.
  void settle(const Exec& exec, const WetNodes& wet, const Kokkos::View<NodeType*>& type,
              const ScalarField<double>& dissolved) const;

  /// Allows calls of `let_go`.
  void follow_fragments();
  /// Lets fragments go that the fluid carries off: whole pieces that nothing holds (dem/pieces.hpp), once a triangle of
  /// theirs has moved farther than half its size from its place on the lattice (dem/out_of_place.hpp). From the next
  /// update on their triangles have no share left, but their solid stays where it is drawn. Does nothing without
  /// follow_fragments. Waits for the device; pieces are found on the host, where bonds have failed since the last call.
  void let_go(const Exec& exec, const Particles& particles, const Bonds& bonds);
  /// Number of triangles let go so far; waits for the device.
  int let_go_count() const;

  /// (triangle) share of the solid that remained at the last update.
  const ScalarField<double>& solid_fraction() const { return solid_fraction_; }
  /// (bond) chemical damage at the last update.
  const ScalarField<double>& d_c() const { return d_c_; }
  /// Calls visit(name, view) for everything that belongs in a checkpoint.
  template <class Visit>
  void visit_state(const Visit& visit) {
    visit("settled", settled_);
    if (let_go_.extent(0) > 0) visit("let_go", let_go_);
    triangles_.visit_state("triangles", visit);
    sectors_.visit_state("sectors", visit);
  }

 private:
  /// sum_ = dissolved volume of each sector.
  void sum_dissolved(const Exec& exec, const WetNodes& wet, const ScalarField<double>& dissolved) const;
  /// held_ = volume that the nodes of each sector hold.
  void sum_held(const Exec& exec, const ScalarField<double>& volume) const;
  void store_moved(const Exec& exec) const;

  NodeGroups nodes_of_sector_;
  SectorPairs sectors_of_bond_;
  SolidMoved triangles_, sectors_;
  ScalarField<double> initial_;     ///< (sector) solid volume, pixels
  ScalarField<double> settled_;     ///< (sector) dissolved volume of the nodes that have turned fluid, pixels
  ScalarField<double> let_go_;      ///< (triangle) 1 for one that was let go; empty without follow_fragments
  IndexList leaving_;               ///< (triangle) 1 at the lowest one of a piece that goes now; empty likewise
  ScalarField<double> sum_, held_;  ///< (sector) work space of an update
  ScalarField<double> solid_fraction_, d_c_;
};

}  // namespace vug
