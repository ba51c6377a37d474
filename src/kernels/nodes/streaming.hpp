#pragma once
// Where a sweep finds the population that arrives in direction q at fluid node i, and where it stores the one that
// leaves in direction q. Every slot is read and written by one node only, which reads all of its slots before it
// writes.
//
// Two kinds of steps alternate and so work in place (after Bailey et al. 2009). A population *at home* is in slot q *
// capacity + i of the node that it leaves. After an odd number of steps, one that is about to move to a fluid neighbour
// has changed places with the one that moves the other way (*turned*). One that leaves the fluid is always at home, so
// the conditions at walls and openings need not know of this.
#include "base/unroll.hpp"
#include "kernels/launch/launch.hpp"
#include "kernels/nodes/fluid_nodes.hpp"

#include <string>

namespace vug {

/// In place, populations at home: a node takes them from its neighbours and stores its own in the slots that it has
/// read.
template <class Set>
struct InPlaceFromHome {
  Kokkos::View<const int*> source;
  int capacity;
  KOKKOS_FORCEINLINE_FUNCTION int arriving(int q, int i) const { return source(q * capacity + i); }
  KOKKOS_FORCEINLINE_FUNCTION int leaving(int q, int i) const { return source(Set::opposite(q) * capacity + i); }
};

/// In place, populations turned: all are at the node that they go to already, and are stored at home.
template <class Set>
struct InPlaceFromTurned {
  int capacity;
  KOKKOS_FORCEINLINE_FUNCTION int arriving(int q, int i) const { return Set::opposite(q) * capacity + i; }
  KOKKOS_FORCEINLINE_FUNCTION int leaving(int q, int i) const { return q * capacity + i; }
};

/// Calls visit(slots) with the slots in which a sweep finds and leaves populations.
template <class Set, class Visit>
void visit_slots(const FluidNodes& nodes, bool turned, const Visit& visit) {
  if (turned)
    visit(InPlaceFromTurned<Set>{nodes.capacity});
  else
    visit(InPlaceFromHome<Set>{nodes.source, nodes.capacity});
}

/// As SourcePacks, for populations that are turned.
template <class T, class Set>
struct PacksFromTurned {
  int capacity;

  static constexpr bool runs_overlap = false;

  KOKKOS_FORCEINLINE_FUNCTION void pull(const T* f, int i, Pack<T> (&g)[Set::Q]) const {
    VUG_UNROLL
    for (int q = 0; q < Set::Q; ++q) g[q] = PackOf<T>::load(f + Set::opposite(q) * capacity + i);
  }
  KOKKOS_FORCEINLINE_FUNCTION void push(T* f, int i, const Pack<T> (&g)[Set::Q]) const {
    VUG_UNROLL
    for (int q = 0; q < Set::Q; ++q) PackOf<T>::store(f + q * capacity + i, g[q]);
  }
};

template <class T, class Set>
SourcePacks<T, Set> packs_of(const InPlaceFromHome<Set>& slots, const FluidNodes& nodes) {
  return {nodes.windows.data(), slots.source.data(), slots.capacity};
}
template <class T, class Set>
PacksFromTurned<T, Set> packs_of(const InPlaceFromTurned<Set>& slots, const FluidNodes&) {
  return {slots.capacity};
}

/// Sum of the slots of node i in double: what the node has sent out or, turned, what is about to arrive there.
template <class T, class Set>
struct SumOfSlots {
  Kokkos::View<const T*> f;
  int capacity;
  KOKKOS_FUNCTION double operator()(int i) const { return sum_of_populations<Set, double>(&f(i), capacity); }
};

/// Exchanges the two populations of every link between fluid nodes; each pair is handled once, from one end.
template <class T, class Set>
struct TurnBack {
  ScalarField<T> f;
  Kokkos::View<const int*> source;
  int count, capacity;
  KOKKOS_FUNCTION void operator()(int i) const {
    for (int q = 1; q < Set::Q; ++q) {
      const int opposite = Set::opposite(q);
      if (opposite < q) continue;
      const int other = source(q * capacity + i);  // of the neighbour along -q, when that is fluid
      const int neighbour = other - q * capacity;
      if (neighbour < 0 || neighbour >= count) continue;
      const T mine = f(opposite * capacity + i);
      f(opposite * capacity + i) = f(other);
      f(other) = mine;
    }
  }
};

/// Brings the populations f of the first `count` nodes home if they are `turned`, and clears `turned`. Where processes
/// share the list, this is done for the nodes of this process and those beside them.
template <class Set, class T>
void settle(const Exec& exec, const FluidNodes& nodes, int count, const ScalarField<T>& f, int& turned) {
  if (!turned) return;
  turned = 0;
  for_each_node(exec, "vug::streaming::settle", nodes.near(count),
                TurnBack<T, Set>{f, nodes.source, count, nodes.capacity});
}

}  // namespace vug
