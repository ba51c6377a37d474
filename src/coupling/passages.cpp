#include "coupling/passages.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace vug {

namespace {

/// Nodes of one front that are neighbours.
struct Part {
  std::size_t front = 0;  ///< its number
  int nodes = 0, held = 0;
  double given = 0;   ///< volume that enters per step
  bool open = false;  ///< something is given at a node, or it yields
  bool yields = false;
  bool dead = false;        ///< nothing flows through it
  std::vector<int> beside;  ///< parts of the fronts before and after it that have neighbours of its nodes
};

/// All fronts from some nodes on, in parts.
class Parts {
 public:
  Parts(const FluidPicture& picture, const NoSlipWalls& walls, const std::vector<std::size_t>& begin, const Ways& ways)
      : picture_(picture), walls_(walls), ways_(ways), part_(picture.size(), unknown) {
    picture.for_each_front(begin, [&](const std::vector<std::size_t>& front, const std::vector<bool>&) {
      add(front);
      return true;
    });
    leave_out_dead_ends();
  }
  /// In the order of fronts.
  const std::vector<Part>& all() const { return parts_; }

 private:
  void add(const std::vector<std::size_t>& front) {
    for (const std::size_t n : front) part_[n] = in_front;
    for (const std::size_t n : front)
      if (part_[n] == in_front) add_part(n);
    ++fronts_;
  }
  void add_part(std::size_t first) {
    const int number = static_cast<int>(parts_.size());
    Part part;
    part.front = fronts_;
    std::vector<std::size_t> joined{first};
    part_[first] = number;
    for (std::size_t k = 0; k < joined.size(); ++k) {
      part.held += walls_.hold(joined[k]);
      const double given = ways_.given[joined[k]];
      part.given += given;
      part.yields = part.yields || ways_.yields[joined[k]];
      part.open = part.open || part.yields || given != 0;
      picture_.for_each_neighbour(joined[k], [&](std::size_t m) {
        const int other = part_[m];
        if (other == in_front) {
          part_[m] = number;
          joined.push_back(m);
        } else if (other >= 0 && other < number && parts_[other].front + 1 == fronts_ &&
                   std::find(part.beside.begin(), part.beside.end(), other) == part.beside.end()) {
          part.beside.push_back(other);
        }
      });
    }
    part.nodes = static_cast<int>(joined.size());
    for (const int before : part.beside) parts_[before].beside.push_back(number);
    parts_.push_back(std::move(part));
  }
  /// A part with one other beside it, where fluid neither enters nor leaves, lets nothing through; and then the next.
  void leave_out_dead_ends() {
    std::vector<std::size_t> left(parts_.size());
    for (std::size_t k = 0; k < parts_.size(); ++k) left[k] = parts_[k].beside.size();
    for (std::size_t k = 0; k < parts_.size(); ++k)
      for (int at = static_cast<int>(k); at >= 0;) {
        Part& part = parts_[at];
        if (part.dead || part.open || left[at] > (part.front == 0 ? 0u : 1u)) break;
        part.dead = true;
        at = -1;
        for (const int next : part.beside)
          if (!parts_[next].dead) {
            --left[next];
            at = next;
          }
      }
  }

  static constexpr int unknown = -1, in_front = -2;
  const FluidPicture& picture_;
  const NoSlipWalls& walls_;
  const Ways& ways_;
  std::vector<int> part_;  ///< (node)
  std::vector<Part> parts_;
  std::size_t fronts_ = 0;
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

Passage find_passage(const NoSlipWalls& walls, const FluidPicture& picture, const std::vector<std::size_t>& begin,
                     const Ways& ways, double beyond) {
  const Parts parts(picture, walls, begin, ways);
  const std::vector<Part>& all = parts.all();
  const bool backwards = beyond != 0;
  const auto ends = [&](const Part& part) { return part.yields && !backwards; };
  const auto first = std::find_if(all.begin(), all.end(), ends);
  const auto last = std::find_if(all.rbegin(), all.rend(), [](const Part& part) { return part.given != 0; });
  if (first == all.end() && last == all.rend()) return {};
  const std::size_t end = first != all.end() ? first->front : last->front;
  Passage passed;
  double stored = 0, within = -beyond;
  bool spreads = true;
  for (auto part = all.begin(); part != all.end() && part->front <= end;) {
    const std::size_t front = part->front;
    std::vector<int> passages;
    int held = 0, nodes = 0;
    double given = 0, carried = 0;  // carried: volume per step, pressure gradient and 1/viscosity
    for (; part != all.end() && part->front == front; ++part) {
      stored += 3.0 * part->nodes;
      if (part->dead) continue;
      passages.push_back(part->nodes);
      held += part->held;
      nodes += part->nodes;
      carried += std::pow(part->nodes, 3) / (part->held > 1 ? 12.0 : 3.0 * part->held);  // infinite without walls
      given += part->given;
    }
    // what is given at nodes of the front crosses it or does not; at the mouth itself it does
    const double before = std::abs(within), after = std::abs(within + given);
    const double crossing = front > 0 ? std::min(before, after) : std::max(before, after);
    within += given;
    const double drag = carried > 0 ? 1 / carried : 0;
    passed.speed = std::max(passed.speed, crossing / nodes);
    passed.peak = std::max(passed.peak, crossing * (held > 0 ? peak_of_passages(passages) : 1.0 / nodes));
    passed.pressure += crossing * drag;
    spreads = spreads && (front == 0 || after >= before);
    if (spreads) passed.delay += drag * stored;
  }
  return passed;
}

}  // namespace vug
