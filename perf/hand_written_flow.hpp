#pragma once
// The flow sweep over the fluid list written by hand with raw pointers, without stored moments: what the layout itself
// can do, as a yardstick for the kernel of the library. Two lattices, and in place (two kinds of steps in turn).
#include "kernels/launch.hpp"
#include "kernels/mrt.hpp"

namespace vug::perf {

template <class T>
struct HandWrittenTwoLattices {
  const T* f;
  T* g;
  const int* source;
  int capacity;
  TwoRelaxationTimes<T> relax;
  KOKKOS_FORCEINLINE_FUNCTION void operator()(int i) const {
    T v[9];
    v[0] = f[i];
    for (int q = 1; q < 9; ++q) v[q] = f[source[q * capacity + i]];
    relax(v, macroscopic(v), NoForce<T>{});
    for (int q = 0; q < 9; ++q) g[q * capacity + i] = v[q];
  }
};

/// In place: even steps collide where the populations lie and leave them turned round; odd steps pull from and push to
/// the neighbours. `source` must name the turned slot.
template <class T, bool odd>
struct HandWrittenInPlace {
  T* f;
  const int* source;
  int capacity;
  TwoRelaxationTimes<T> relax;
  KOKKOS_FORCEINLINE_FUNCTION void operator()(int i) const {
    T v[9];
    v[0] = f[i];
    for (int q = 1; q < 9; ++q) v[q] = f[odd ? source[q * capacity + i] : q * capacity + i];
    relax(v, macroscopic(v), NoForce<T>{});
    f[i] = v[0];
    for (int q = 1; q < 9; ++q) {
      const int opposite = D2Q9::opposite(q);
      f[odd ? source[opposite * capacity + i] : opposite * capacity + i] = v[q];
    }
  }
};

/// The table of sources for the odd steps in place, where population q lies turned, in slot opposite(q).
struct TurnSources {
  IndexList source, turned;
  int capacity;
  KOKKOS_FUNCTION void operator()(int i) const {
    for (int q = 0; q < 9; ++q) {
      const int slot = source(q * capacity + i), direction = slot / capacity, node = slot % capacity;
      turned(q * capacity + i) = D2Q9::opposite(direction) * capacity + node;
    }
  }
};

}  // namespace vug::perf
