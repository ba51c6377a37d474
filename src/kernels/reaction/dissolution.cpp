#include "kernels/reaction/dissolution.hpp"

#include "kernels/launch/launch.hpp"
#include "kernels/launch/prefetch.hpp"
#include "kernels/nodes/fluid_nodes.hpp"
#include "kernels/nodes/streaming.hpp"

namespace vug {

/// Marks one dissolved surface node as fluid and counts it.
struct MarkDissolved {
  IndexList node;
  Kokkos::View<NodeType*> type;
  ScalarField<double> V;
  int size;
  /// Prefetches for a later surface node, because these are scattered over the lattice.
  KOKKOS_FORCEINLINE_FUNCTION void announce(int s) const {
    constexpr int ahead = 128;
    prefetch(&V(node(s + ahead < size ? s + ahead : size - 1)));
  }
  KOKKOS_FUNCTION void operator()(int s, int& count) const {
    announce(s);
    if (V(node(s)) > 0 || type(node(s)) == NodeType::fluid) return;
    type(node(s)) = NodeType::fluid;
    ++count;
  }
};

/// Hands the overdrafts of dissolved nodes to their heirs, the solid nodes around them, in equal shares. The shares of
/// an heir are summed in the order of the directions by its overdrawn neighbour of lowest number, so that nothing is
/// added twice or in another order.
struct BequeathOverdraft {
  Kokkos::View<const std::uint8_t*> mineral;  ///< (dense node) only nodes of the same mineral are heirs; empty: all
  DenseNeighbour lattice;
  IndexList node;
  Kokkos::View<const NodeType*> type;
  ScalarField<double> V;

  KOKKOS_FORCEINLINE_FUNCTION bool overdrawn(int n) const { return type(n) == NodeType::fluid && V(n) < 0; }
  KOKKOS_FORCEINLINE_FUNCTION bool kin(int n, int m) const {
    return mineral.extent(0) == 0 || mineral(n) == mineral(m);
  }

  /// The neighbour of n along q; -1 outside, and where a direction before q leads to the same node (on a periodic
  /// lattice one or two nodes wide).
  KOKKOS_FUNCTION int neighbour(int n, int q) const {
    const int m = lattice.along(n, q);
    for (int p = 1; p < q; ++p)
      if (lattice.along(n, p) == m) return -1;
    return m;
  }
  KOKKOS_FUNCTION int heir(int n, int q) const {
    const int m = neighbour(n, q);
    return m >= 0 && type(m) == NodeType::solid && kin(n, m) ? m : -1;
  }
  KOKKOS_FUNCTION int count_heirs(int n) const {
    int heirs = 0;
    for (int q = 1; q < D2Q9::Q; ++q) heirs += heir(n, q) >= 0;
    return heirs;
  }
  /// Adds to V(to) the shares of node `to`, if n is the node that has to do it.
  KOKKOS_FUNCTION void gather(int to, int n) const {
    double sum = 0;
    for (int q = 1; q < D2Q9::Q; ++q) {
      const int from = neighbour(to, q);
      if (from < 0 || !overdrawn(from) || !kin(from, to)) continue;
      if (from < n) return;
      sum += V(from) / count_heirs(from);
    }
    V(to) += sum;
  }

  KOKKOS_FUNCTION double operator()(int s) const {
    const int n = node(s);
    if (!overdrawn(n)) return 0;
    if (count_heirs(n) == 0) return V(n);
    for (int q = 1; q < D2Q9::Q; ++q)
      if (const int to = heir(n, q); to >= 0) gather(to, n);
    return 0;
  }
};

/// The overdraft of a node of one mineral that has no heir.
struct LostOfMineral {
  BequeathOverdraft bequest;
  int mineral;
  KOKKOS_FUNCTION double operator()(int s) const {
    const int n = bequest.node(s);
    const bool lost = bequest.overdrawn(n) && bequest.mineral(n) == mineral && bequest.count_heirs(n) == 0;
    return lost ? bequest.V(n) : 0.0;
  }
};

struct EmptyDissolved {
  IndexList node;
  Kokkos::View<const NodeType*> type;
  ScalarField<double> V;
  KOKKOS_FUNCTION void operator()(int s) const {
    if (type(node(s)) == NodeType::fluid) V(node(s)) = 0;
  }
};

int mark_dissolved(const Exec& exec, const FluidNodes& nodes, const Surface& surface,
                   const Kokkos::View<NodeType*>& type, const ScalarField<double>& V, const ScalarField<double>& lost,
                   const MineralLosses& minerals) {
  int count = 0;
  Kokkos::parallel_reduce("vug::dissolution::mark", Kokkos::RangePolicy<Exec>(exec, 0, surface.count),
                          MarkDissolved{surface.node, type, V, surface.count}, count);
  if (count == 0) return 0;
  const BequeathOverdraft bequest{minerals.of_node, nodes.around(), surface.node, type, V};
  if (minerals.of_node.extent(0) > 0)
    for (std::size_t m = 0; m < minerals.lost.size(); ++m)
      add_per_block(exec, "vug::dissolution::lost_of_mineral", surface.count,
                    LostOfMineral{bequest, static_cast<int>(m)}, minerals.lost[m]);
  add_per_block(exec, "vug::dissolution::bequeath", surface.count, bequest, lost);
  for_each_node(exec, "vug::dissolution::empty", surface.count, EmptyDissolved{surface.node, type, V});
  return count;
}

/// The fluid neighbours of a fluid node, by the table of sources.
template <class T, class Set>
struct BirthNeighbours {
  Kokkos::View<const int*> source;
  ScalarField<T> h;
  int capacity, first, last;

  KOKKOS_FORCEINLINE_FUNCTION int upstream(int i, int q) const { return upstream_node(source, capacity, q, i); }
  KOKKOS_FORCEINLINE_FUNCTION bool is_old(int i) const { return i >= 0 && i < first; }
  KOKKOS_FORCEINLINE_FUNCTION bool is_newborn(int i) const { return i >= first && i < last; }
  KOKKOS_FUNCTION int count_old(int i) const {
    int m = 0;
    for (int q = 1; q < Set::Q; ++q) m += is_old(upstream(i, q));
    return m;
  }
  KOKKOS_FUNCTION int count_newborn(int i) const {
    int m = 0;
    for (int q = 1; q < Set::Q; ++q) m += is_newborn(upstream(i, q));
    return m;
  }
  KOKKOS_FUNCTION double content(int i) const {
    double sum = 0;
    for (int q = 0; q < Set::Q; ++q) sum += double(h(q * capacity + i));
    return sum;
  }
  /// Share of an old node's content that goes to one newborn beside it: 1/(old neighbours of the newborn + newborn
  /// neighbours of the old node). After a single birth all have nearly the same content; after many, none is empty.
  KOKKOS_FUNCTION double share(int old, int newborn) const { return 1.0 / (count_old(newborn) + count_newborn(old)); }
};

/// Gives one newborn its solute, at rest; returns what was created.
template <class T, class Set>
struct FillNewborn {
  BirthFill fill;
  BirthNeighbours<T, Set> around;
  ScalarField<T> C;
  KOKKOS_FUNCTION double operator()(int item) const {
    const int i = around.first + item;
    const int m = around.count_old(i);
    double c = 0;
    for (int q = 1; q < Set::Q; ++q) {
      const int old = around.upstream(i, q);
      if (!around.is_old(old)) continue;
      c += around.content(old) * (fill == BirthFill::mean ? 1.0 / m : around.share(old, i));
    }
    C(i) = T(c);
    for (int q = 0; q < Set::Q; ++q) around.h(q * around.capacity + i) = T(Set::w(q) * c);
    return fill == BirthFill::mean ? c : 0;
  }
};

/// Subtracts from the old neighbours of one newborn what they gave. An old node with several newborns is handled by the
/// newborn that its directions reach first.
template <class T, class Set>
struct ChargeOldNeighbours {
  BirthNeighbours<T, Set> around;
  KOKKOS_FUNCTION void operator()(int item) const {
    const int i = around.first + item;
    for (int q = 1; q < Set::Q; ++q) {
      const int old = around.upstream(i, q);
      if (around.is_old(old) && first_newborn_link(old) == Set::opposite(q)) charge(old);
    }
  }
  /// Direction q of the first link of `old` whose upstream node is a newborn.
  KOKKOS_FUNCTION int first_newborn_link(int old) const {
    for (int q = 1; q < Set::Q; ++q)
      if (around.is_newborn(around.upstream(old, q))) return q;
    return -1;
  }
  KOKKOS_FUNCTION void charge(int old) const {
    double given = 0;
    for (int q = 1; q < Set::Q; ++q) {
      const int newborn = around.upstream(old, q);
      if (around.is_newborn(newborn)) given += around.share(old, newborn);
    }
    for (int q = 0; q < Set::Q; ++q) around.h(q * around.capacity + old) *= T(1 - given);
  }
};

template <class Set, class T>
void initialise_births(const Exec& exec, const FluidNodes& nodes, int first, int last, BirthFill fill,
                       SoluteFields<T>& s, const ScalarField<double>& created) {
  // the links to newborns were walls until now: their populations are at home
  settle<Set>(exec, nodes, first, s.h, s.turned);
  const BirthNeighbours<T, Set> around{nodes.source, s.h, nodes.capacity, first, last};
  add_per_block(exec, "vug::dissolution::fill", last - first, FillNewborn<T, Set>{fill, around, s.C}, created);
  if (fill == BirthFill::split)
    for_each_node(exec, "vug::dissolution::charge_neighbours", last - first, ChargeOldNeighbours<T, Set>{around});
}

VUG_COMPILE_FOR_SETS(initialise_births)

}  // namespace vug
