#include "coupling/initial_pathways.hpp"

#include "dem/edges.hpp"
#include "dem/heterogeneity.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <queue>

namespace vug {

namespace {

/// A graph as lists of neighbours.
struct Graph {
  struct Way {
    int to, bond;
    double length;
  };
  std::vector<std::vector<Way>> ways;
  explicit Graph(std::size_t count) : ways(count) {}
  void join(int a, int b, int bond, double length) {
    ways[a].push_back({b, bond, length});
    ways[b].push_back({a, bond, length});
  }
};

constexpr int nobody = -1;

/// For every place the nearest start along the edges of the graph, and the bond crossed last on the way from there.
struct Nearest {
  std::vector<int> start;
  std::vector<int> from;  ///< previous place on the way, or nobody
  std::vector<int> bond;
  std::vector<double> distance;
};

/// Dijkstra's algorithm from several places at once. The order of the places decides ties, so that the result is the
/// same on every machine.
Nearest nearest_start(const Graph& graph, const std::vector<int>& starts) {
  const std::size_t count = graph.ways.size();
  Nearest found{std::vector<int>(count, nobody), std::vector<int>(count, nobody), std::vector<int>(count, nobody),
                std::vector<double>(count, std::numeric_limits<double>::infinity())};
  using Reached = std::pair<double, int>;
  std::priority_queue<Reached, std::vector<Reached>, std::greater<>> front;
  for (const int s : starts) {
    found.start[s] = s;
    found.distance[s] = 0;
    front.emplace(0, s);
  }
  while (!front.empty()) {
    const auto [distance, place] = front.top();
    front.pop();
    if (distance > found.distance[place]) continue;
    for (const Graph::Way& way : graph.ways[place]) {
      if (distance + way.length >= found.distance[way.to]) continue;
      found.distance[way.to] = distance + way.length;
      found.start[way.to] = found.start[place];
      found.from[way.to] = place;
      found.bond[way.to] = way.bond;
      front.emplace(found.distance[way.to], way.to);
    }
  }
  return found;
}

/// The rock as graphs: triangles that touch, and corners joined by bonds or by the walls of holes.
class Blocks {
 public:
  Blocks(const Assembly& assembly, const std::vector<bool>& fixed, std::uint64_t seed)
      : touching_(assembly.triangles.size()), along_(assembly.vertices.size()), fixed_(fixed) {
    std::vector<std::array<double, 2>> centroid;
    for (const auto& t : assembly.triangles) {
      std::array<double, 2> sum{0, 0};
      for (const int v : t)
        for (int axis = 0; axis < 2; ++axis) sum[axis] += assembly.vertices[v][axis] / 3;
      centroid.push_back(sum);
    }
    const auto apart = [](const std::array<double, 2>& a, const std::array<double, 2>& b) {
      return std::hypot(a[0] - b[0], a[1] - b[1]);
    };
    std::array<double, 2> lower = assembly.vertices.front(), upper = lower;
    for (const auto& v : assembly.vertices)
      for (int axis = 0; axis < 2; ++axis) {
        lower[axis] = std::min(lower[axis], v[axis]);
        upper[axis] = std::max(upper[axis], v[axis]);
      }
    const auto on_a_side = [&](int p, int q) {
      for (int axis = 0; axis < 2; ++axis)
        for (const double side : {lower[axis], upper[axis]})
          if (assembly.vertices[p][axis] == side && assembly.vertices[q][axis] == side) return true;
      return false;
    };
    for (const Edge& edge : find_edges(assembly)) {
      const auto [p, q] = edge.vertex;
      const double length = apart(assembly.vertices[p], assembly.vertices[q]);
      if (edge.triangle[1] >= 0) {
        const auto [a, b] = edge.triangle;
        touching_.join(a, b, static_cast<int>(ends_.size()), apart(centroid[a], centroid[b]));
        along_.join(p, q, static_cast<int>(ends_.size()), length);
        ends_.push_back(edge.vertex);
        sides_.push_back(edge.triangle);
      } else if (!on_a_side(p, q)) {
        walls_.push_back(edge.vertex);
      }
    }
    constexpr std::uint64_t pathway_property = 100;  // unlike the strengths drawn from the same names
    std::vector<double> draw;
    for (const auto& t : assembly.triangles)
      draw.push_back(uniform_of(seed, t[0], t[1], pathway_property + static_cast<std::uint64_t>(t[2])));
    order_.resize(draw.size());
    std::iota(order_.begin(), order_.end(), 0);
    std::stable_sort(order_.begin(), order_.end(), [&](int a, int b) { return draw[a] < draw[b]; });
  }

  int largest_count() const { return static_cast<int>(order_.size()); }

  /// Bonds that are open when the rock is divided into `count` blocks.
  std::vector<bool> joints(int count) const {
    const Nearest block = nearest_start(touching_, {order_.begin(), order_.begin() + count});
    std::vector<bool> open = fixed_;
    for (std::size_t b = 0; b < open.size(); ++b)
      if (block.start[sides_[b][0]] != block.start[sides_[b][1]]) open[b] = true;
    while (connect(open)) {
    }
    return open;
  }

 private:
  /// Opens the shortest way from the piece with the first open corner to any other piece; false when there is one piece
  /// only or no way is left.
  bool connect(std::vector<bool>& open) const {
    Graph network(along_.ways.size());
    std::vector<bool> conducts(along_.ways.size(), false);
    const auto add = [&](const std::array<int, 2>& ends, int bond) {
      network.join(ends[0], ends[1], bond, 1);
      conducts[ends[0]] = conducts[ends[1]] = true;
    };
    for (std::size_t b = 0; b < open.size(); ++b)
      if (open[b]) add(ends_[b], static_cast<int>(b));
    for (const auto& wall : walls_) add(wall, nobody);
    const auto first = std::find(conducts.begin(), conducts.end(), true);
    if (first == conducts.end()) return false;
    const Nearest piece = nearest_start(network, {static_cast<int>(first - conducts.begin())});
    std::vector<int> starts;
    for (std::size_t v = 0; v < conducts.size(); ++v)
      if (piece.start[v] != nobody) starts.push_back(static_cast<int>(v));
    const Nearest way = nearest_start(along_, starts);
    int goal = nobody;
    for (std::size_t v = 0; v < conducts.size(); ++v)
      if (conducts[v] && piece.start[v] == nobody && way.start[v] != nobody &&
          (goal == nobody || way.distance[v] < way.distance[goal]))
        goal = static_cast<int>(v);
    if (goal == nobody) return false;
    for (int v = goal; way.from[v] != nobody; v = way.from[v]) open[way.bond[v]] = true;
    return true;
  }

  Graph touching_;                         ///< triangles that share a bond
  Graph along_;                            ///< corners that are joined by a bond
  std::vector<std::array<int, 2>> ends_;   ///< (bond) corners
  std::vector<std::array<int, 2>> sides_;  ///< (bond) triangles
  std::vector<std::array<int, 2>> walls_;  ///< edges of holes and notches: corners
  std::vector<int> order_;                 ///< triangles in the order in which they become blocks
  const std::vector<bool>& fixed_;
};

}  // namespace

int count_nodes(const std::vector<bool>& open, const std::vector<std::vector<int>>& strips) {
  std::vector<int> nodes;
  for (std::size_t b = 0; b < open.size(); ++b)
    if (open[b]) nodes.insert(nodes.end(), strips[b].begin(), strips[b].end());
  std::sort(nodes.begin(), nodes.end());
  return static_cast<int>(std::unique(nodes.begin(), nodes.end()) - nodes.begin());
}

std::vector<bool> choose_pathways(const Assembly& assembly, const std::vector<bool>& fixed, double target,
                                  std::uint64_t seed, const std::function<double(const std::vector<bool>&)>& taken) {
  if (taken(fixed) >= target) return fixed;
  const Blocks blocks(assembly, fixed, seed);
  const auto of_blocks = [&](int count) { return taken(blocks.joints(count)); };
  // The share taken grows with the number of blocks, up to small fluctuations: bisection finds the number within these.
  int few = 1, many = blocks.largest_count();
  while (many - few > 1) {
    const int middle = (few + many) / 2;
    (of_blocks(middle) < target ? few : many) = middle;
  }
  return blocks.joints(target - of_blocks(few) < of_blocks(many) - target ? few : many);
}

}  // namespace vug
