#pragma once
// The flow sweep over the fluid list written by hand with raw pointers, without stored moments: what the layout itself
// can do, as a yardstick for the kernel of the library.
#include "kernels/flow/two_relaxation_times.hpp"
#include "kernels/launch/launch.hpp"

namespace vug::perf {

/// In place: one kind of step pulls from and pushes to the neighbours, the other stays on the node.
template <class T, bool at_home>
struct HandWrittenInPlace {
  T* f;
  const int* source;
  int capacity;
  TwoRelaxationTimes<T> relax;
  KOKKOS_FORCEINLINE_FUNCTION void operator()(int i) const {
    T v[9];
    v[0] = f[i];
    for (int q = 1; q < 9; ++q) v[q] = f[at_home ? source[q * capacity + i] : D2Q9::opposite(q) * capacity + i];
    relax(v, macroscopic(v), NoForce<T>{});
    f[i] = v[0];
    for (int q = 1; q < 9; ++q) f[at_home ? source[D2Q9::opposite(q) * capacity + i] : q * capacity + i] = v[q];
  }
};

}  // namespace vug::perf
