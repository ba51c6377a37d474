#pragma once
// How the ranks share the work of a case. All of them hold the same lattice and the same list of fluid nodes. Of both
// each computes its own nodes, and gets from others the values that these pull or are carried with (docs/scaling.md).
#include "kernels/launch/long_sum.hpp"
#include "kernels/launch/row_launch.hpp"
#include "kernels/nodes/fluid_nodes.hpp"
#include "ranks/halo.hpp"
#include "ranks/partition.hpp"

#include <array>
#include <optional>
#include <vector>

namespace vug {

/// Both components, for an exchange.
template <class T>
std::array<ScalarField<T>, 2> components(const VectorField<T>& u) {
  return {Kokkos::subview(u, Kokkos::ALL, 0), Kokkos::subview(u, Kokkos::ALL, 1)};
}

/// Dense nodes belong to the rank that has their row. Fluid nodes belong, in blocks of the list, to the rank that has
/// the row of their block's first node. All functions are called by all ranks.
class Split {
 public:
  Split() = default;  ///< one rank has all
  /// Divides the rows of the lattice, with the given weights, among the ranks.
  Split(const Ranks& ranks, const std::vector<double>& weight_of_row);

  bool alone() const { return ranks_.alone(); }
  const Ranks& ranks() const { return ranks_; }
  const Partition& rows() const { return rows_; }
  int first_row() const { return rows_.first(ranks_.rank()); }
  int own_rows() const { return rows_.last(ranks_.rank()) - first_row(); }
  bool has_row(int row) const { return row >= first_row() && row < first_row() + own_rows(); }
  /// Rows of this rank; nothing where one rank has all.
  std::optional<Rows> share_of_rows() const {
    return alone() ? std::nullopt : std::optional(Rows{first_row(), own_rows()});
  }
  /// The rank that has a fluid node.
  int owner_of(int fluid) const { return owner_of_block_[fluid / nodes_per_block]; }

  /// Divides a list of fluid nodes that is new or has grown.
  void follow(FluidNodes& nodes);

  /// Sets which of `links` this rank dresses: those of its nodes and, with a `mirror` (find_mirror_links), their
  /// images.
  void share_out(BoundaryLinks& links, const IndexList& mirror = {}) const;

  /// The slots of other ranks' nodes from which our sweep with so many directions pulls. After the sweep they belong to
  /// the nodes that pulled.
  Halo populations(const FluidNodes& nodes, int directions) const;
  /// The slots among `slots` that belong to other ranks.
  Halo slots(const FluidNodes& nodes, const std::vector<int>& slots) const;
  /// The fluid nodes in our rows that other ranks sweep.
  Halo in_rows(const FluidNodes& nodes) const;
  /// These, the neighbours of our own nodes, and `more`.
  Halo around(const FluidNodes& nodes, const std::vector<int>& more) const;
  /// All populations of the neighbours of our own fluid nodes.
  Halo populations_around(const FluidNodes& nodes) const;
  /// Of dense populations: those that our rows pull from the rows of others, and all populations of `nodes`.
  Halo dense(const Lattice& lattice, int directions, bool periodic_y, const std::vector<int>& nodes) const;

  /// The dense nodes, or slots of populations at these, that are not in our rows.
  Halo beyond_rows(const Lattice& lattice, std::vector<int> slots) const;

  /// Owners of fluid nodes (by the list or by their rows), of links of these nodes, of blocks of the list, and of rows.
  /// Empty where one rank has all.
  Owners of_fluid(const FluidNodes& nodes) const;
  Owners of_fluid_by_row(const FluidNodes& nodes) const;
  /// Owners of items that are at these dense nodes: (item).
  Owners by_row(const Lattice& lattice, const std::vector<int>& nodes) const;
  Owners of_links(const BoundaryLinks& links) const;
  /// Owners of the older fluid nodes that are neighbours of the newborn nodes [first, last), and of some dense nodes.
  Owners of_neighbours(const FluidNodes& nodes, int first, int last) const;
  Owners of_dense_nodes(const Lattice& lattice, std::vector<int> nodes) const;
  Owners of_blocks() const { return of_blocks(owner_of_block_.size()); }
  Owners of_blocks(std::size_t most) const;  ///< of at most so many, for a field that has not grown yet
  Owners of_rows() const;

  Owners of_dense(const Lattice& lattice) const;  ///< with the halo beside them

  /// Brings what each rank has computed to all of them: (plane * stride + item).
  template <class T>
  void make_whole(const Owners& owners, const ScalarField<T>& values, int planes = 1, std::size_t stride = 0) const {
    KOKKOS_ASSERT(end_of(owners) + (planes - 1) * stride <= values.extent(0));
    for (int p = 0; p < planes; ++p) ranks_.make_whole(owners, values.data() + p * stride);
  }
  template <class T>
  void make_whole(const Owners& owners, const VectorField<T>& values) const {
    for (int axis = 0; axis < 2; ++axis) ranks_.make_whole(owners, values.data() + axis * values.stride(1));
  }
  void make_whole(const Owners& owners, const LongSum& sum) const;
  /// (plane, dense node)
  template <class T>
  void make_whole(const Lattice& lattice, const ScalarField<T>& values, int planes = 1) const {
    make_whole(of_dense(lattice), values, planes, lattice.size());
  }

 private:
  bool is_ours(int fluid) const { return owner_of(fluid) == ranks_.rank(); }
  Halo marked(const FluidNodes& nodes, const std::vector<bool>& needed) const;
  void mark_rows(const FluidNodes& nodes, std::vector<bool>& needed) const;
  void mark_neighbours(const FluidNodes& nodes, std::vector<bool>& needed) const;

  Ranks ranks_;
  Partition rows_;
  std::vector<int> owner_of_block_;
};

}  // namespace vug
