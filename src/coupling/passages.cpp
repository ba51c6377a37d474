#include "coupling/passages.hpp"

#include <algorithm>
#include <cmath>

namespace vug {

namespace {

/// The passages of one front after the other.
class Passages {
 public:
  explicit Passages(const FluidPicture& picture) : picture_(picture), in_front_(picture.size(), false) {}

  /// How many nodes each passage has.
  std::vector<int> of(const std::vector<std::size_t>& front) {
    std::vector<int> nodes;
    std::vector<std::size_t> joined;
    for (const std::size_t n : front) in_front_[n] = true;
    for (const std::size_t n : front) {
      if (!in_front_[n]) continue;
      in_front_[n] = false;
      joined.assign(1, n);
      for (std::size_t k = 0; k < joined.size(); ++k)
        picture_.for_each_neighbour(joined[k], [&](std::size_t m) {
          if (!in_front_[m]) return;
          in_front_[m] = false;
          joined.push_back(m);
        });
      nodes.push_back(static_cast<int>(joined.size()));
    }
    return nodes;
  }

 private:
  const FluidPicture& picture_;
  std::vector<bool> in_front_;  ///< (node) and not in a passage yet
};

}  // namespace

double peak_of_passages(const std::vector<int>& nodes) {
  double widest = 0, carried = 0;
  for (const int n : nodes) {
    widest = std::max(widest, static_cast<double>(n));
    carried += std::pow(n, 3);
  }
  return carried > 0 ? 2 * widest * widest / carried : 0;
}

Passage find_passage(const NoSlipWalls& walls, const FluidPicture& picture, const Mouth& mouth,
                     const std::vector<bool>& outlet) {
  Passages passages(picture);
  Passage passed{mouth.nodes.size()};
  double stored = 0;
  bool let_out = false;
  picture.for_each_front(mouth.nodes, [&](const std::vector<std::size_t>& front, const std::vector<bool>&) {
    const auto nodes = static_cast<double>(front.size());
    const auto held = std::count_if(front.begin(), front.end(), [&](std::size_t n) { return walls.hold(n); });
    const double drag = (held > 1 ? 12 : 3 * static_cast<double>(held)) / std::pow(nodes, 3);
    stored += 3 * nodes;
    passed.least = std::min(passed.least, front.size());
    passed.peak = std::max(passed.peak, held > 0 ? peak_of_passages(passages.of(front)) : 1 / nodes);
    passed.drag += drag;
    passed.delay += drag * stored;
    let_out = std::any_of(front.begin(), front.end(), [&](std::size_t n) { return outlet[n]; });
    return !let_out;
  });
  return let_out ? passed : Passage{};
}

}  // namespace vug
