#pragma once
// What a node of a small flow has sent out.
#include "kernels/nodes/streaming.hpp"
#include "support/flow_setup.hpp"

#include <array>

namespace vug::test {

/// Populations of node i on the host.
template <class T>
std::array<T, 9> populations(Flow<T>& flow, int i) {
  settle<D2Q9>(flow.exec, flow.nodes, flow.nodes.count, flow.fields.f, flow.fields.turned);
  const auto f = host_copy(flow.fields.f);
  std::array<T, 9> values;
  for (int q = 0; q < 9; ++q) values[q] = f(q * flow.nodes.capacity + i);
  return values;
}

}  // namespace vug::test
