#include "dem/edges.hpp"

#include "base/require.hpp"

#include <algorithm>
#include <cstdint>
#include <string>
#include <unordered_map>

namespace vug {

namespace {

std::uint64_t key_of(int p, int q) {
  return static_cast<std::uint64_t>(std::min(p, q)) << 32 | static_cast<std::uint64_t>(std::max(p, q));
}

[[noreturn]] void refuse(const Edge& edge, int triangle, const char* why) {
  throw InputError("rock assembly: triangle " + std::to_string(triangle) + " at edge " +
                   std::to_string(edge.vertex[0]) + "-" + std::to_string(edge.vertex[1]) + " " + why);
}

}  // namespace

std::vector<Edge> find_edges(const Assembly& assembly) {
  std::vector<Edge> edges;
  std::unordered_map<std::uint64_t, std::size_t> known;
  for (int k = 0; k < static_cast<int>(assembly.triangles.size()); ++k) {
    const auto& corners = assembly.triangles[k];
    for (std::size_t c = 0; c < 3; ++c) {
      const int p = corners[c], q = corners[(c + 1) % 3];
      const auto [place, is_new] = known.try_emplace(key_of(p, q), edges.size());
      if (is_new) {
        edges.push_back({{p, q}, {k, -1}});
        continue;
      }
      Edge& edge = edges[place->second];
      if (edge.triangle[1] >= 0) refuse(edge, k, "is the third one there, expected at most two");
      if (edge.vertex[0] == p) refuse(edge, k, "overlaps its neighbour, expected one on each side");
      edge.triangle[1] = k;
    }
  }
  return edges;
}

}  // namespace vug
