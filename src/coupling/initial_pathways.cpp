#include "coupling/initial_pathways.hpp"

#include "dem/heterogeneity.hpp"

#include <algorithm>
#include <map>
#include <numeric>

namespace vug {

namespace {

/// Disjoint sets of vertices with path halving.
struct Forest {
  std::vector<int> parent;
  explicit Forest(int n) : parent(n) { std::iota(parent.begin(), parent.end(), 0); }
  int root(int v) {
    while (parent[v] != v) v = parent[v] = parent[parent[v]];
    return v;
  }
  bool join(int a, int b) {
    a = root(a);
    b = root(b);
    if (a == b) return false;
    parent[a] = b;
    return true;
  }
};

}  // namespace

std::vector<bool> choose_pathways(const std::vector<std::array<int, 2>>& edges,
                                  const std::vector<std::vector<int>>& strips, const std::vector<bool>& fixed,
                                  int vertices, int target_nodes, std::uint64_t seed) {
  constexpr int pathway_property = 100;  // apart from the strengths drawn from the same names
  const int count = static_cast<int>(edges.size());
  std::vector<double> draw(count);
  for (int e = 0; e < count; ++e) draw[e] = uniform_of(seed, edges[e][0], edges[e][1], pathway_property);
  std::vector<int> order(count);
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&](int a, int b) { return draw[a] != draw[b] ? draw[a] < draw[b] : a < b; });

  std::vector<bool> chosen(count, false);
  std::vector<int> degree(vertices, 0);
  Forest forest(vertices);
  std::map<int, int> covers;  // open edges over each open node
  const auto opened = [&] { return static_cast<int>(covers.size()); };
  const auto add = [&](int e) {
    chosen[e] = true;
    for (const int n : strips[e]) ++covers[n];
    ++degree[edges[e][0]];
    ++degree[edges[e][1]];
    forest.join(edges[e][0], edges[e][1]);
  };
  for (int e = 0; e < count; ++e)
    if (fixed[e]) add(e);
  if (target_nodes <= opened()) return chosen;
  for (const int e : order)
    if (!chosen[e] && forest.root(edges[e][0]) != forest.root(edges[e][1])) add(e);
  // Too many: prune free leaves of the tree, last drawn first, until the target is met.
  for (bool pruned = true; pruned && opened() > target_nodes;) {
    pruned = false;
    for (auto e = order.rbegin(); e != order.rend() && opened() > target_nodes; ++e) {
      const bool leaf = chosen[*e] && !fixed[*e] && (degree[edges[*e][0]] == 1 || degree[edges[*e][1]] == 1);
      if (!leaf) continue;
      chosen[*e] = false;
      for (const int n : strips[*e])
        if (--covers[n] == 0) covers.erase(n);
      --degree[edges[*e][0]];
      --degree[edges[*e][1]];
      pruned = true;
    }
  }
  // Too few: close loops, first drawn first.
  for (const int e : order) {
    if (opened() >= target_nodes) break;
    if (!chosen[e]) add(e);
  }
  return chosen;
}

}  // namespace vug
