#pragma once
// Groups of nodes for the host to go through.
#include "base/base.hpp"
#include "coupling/rock_map.hpp"

#include <vector>

namespace vug::test {

/// The nodes of each group, in order.
inline std::vector<std::vector<int>> nodes_of_groups(const NodeGroups& groups) {
  const auto offset = on_host(groups.offset), first = on_host(groups.first), length = on_host(groups.length);
  std::vector<std::vector<int>> nodes(groups.count());
  for (int g = 0; g < groups.count(); ++g)
    for (int r = offset(g); r < offset(g + 1); ++r)
      for (int n = first(r); n < first(r) + length(r); ++n) nodes[g].push_back(n);
  return nodes;
}

}  // namespace vug::test
