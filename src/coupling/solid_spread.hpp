#pragma once
// Where the solid of an opened pathway goes. A pathway is a model of conductivity, several cells wide where the crack
// is far narrower than a cell: the rock is still there, and is "attached to other solid nodes" (paper section 3.3).
#include "coupling/rock_map.hpp"
#include "kernels/nodes/fluid_nodes.hpp"

#include <vector>

namespace vug {

/// (triangle, edge) the triangle beyond each edge, -1 where there is none.
using TriangleNeighbours = Kokkos::View<int* [3], Kokkos::LayoutLeft>;

/// A node is never given more than this many cells' worth of solid, because it would resist acid that many times as
/// long.
inline constexpr double most_solid = 2;

/// Solid that a node takes at most, in cells: up to most_solid, including what has dissolved of it, and no more than it
/// holds, so that a wall that is nearly gone does not grow back.
KOKKOS_FORCEINLINE_FUNCTION double room_for_solid(double V, double dissolved) {
  const double below_bound = most_solid - (V + dissolved), room = below_bound < V ? below_bound : V;
  return room > 0 ? room : 0.0;
}

/// The mineral of each node.
struct MineralNodes {
  Kokkos::View<const std::uint8_t*> of_node{};  ///< (dense node); empty: one mineral
  int count = 1;
};

/// Moves the solid of opened nodes to the solid nodes of their triangle, each in proportion to its room. What finds no
/// room goes in equal parts to the triangles beyond the edges, repeatedly, a few triangles far. What still
/// finds none waits in the triangle that it has reached for the next call. The total volume is kept to rounding. Each
/// of several minerals goes to nodes of its own only, so that none turns into another and the volume of each is kept.
class SolidSpread {
 public:
  SolidSpread(NodeGroups nodes_of_triangle, TriangleNeighbours neighbours, MineralNodes minerals = {});

  /// opening: (dense node) 1 where a node has just opened, 0 afterwards. type: dense. volume, dissolved: (dense node),
  /// cells.
  void operator()(const Exec& exec, const Kokkos::View<NodeType*>& type, const Kokkos::View<std::uint8_t*>& opening,
                  const ScalarField<double>& volume, const ScalarField<double>& dissolved);

  /// The same, but to nodes of any mineral: for nodes that never were rock of one. What finds no room waits as number
  /// 0.
  void among_all(const Exec& exec, const Kokkos::View<NodeType*>& type, const Kokkos::View<std::uint8_t*>& opening,
                 const ScalarField<double>& volume, const ScalarField<double>& dissolved);

  int parts() const { return static_cast<int>(waiting_.size()); }  ///< number of minerals, or 1
  /// (triangle) volume of a mineral that has found no room, cells.
  const ScalarField<double>& waiting(int mineral = 0) const { return waiting_[static_cast<std::size_t>(mineral)]; }

 private:
  template <class Part>
  void spread(const Exec& exec, const Part& part, const Kokkos::View<NodeType*>& type,
              const Kokkos::View<std::uint8_t*>& opening, const ScalarField<double>& volume,
              const ScalarField<double>& dissolved, const ScalarField<double>& waiting);

  NodeGroups nodes_;
  TriangleNeighbours neighbours_;
  Kokkos::View<const std::uint8_t*> mineral_;
  std::vector<ScalarField<double>> waiting_;
  ScalarField<double> arriving_;  ///< (triangle) work space of a round
};

}  // namespace vug
