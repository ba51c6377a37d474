#include "coupling/given_passages.hpp"

#include "coupling/passages.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <string>

namespace vug {

namespace {

/// Mouths from which fluid is followed to an outlet together.
struct Source {
  std::vector<std::size_t> nodes;
  std::set<std::string> keys;  ///< of its mouths: no outlets of its own
  double volume = 0;           ///< that enters per step, cells
  bool presses = false;

  void add(const Mouth& mouth) {
    nodes.insert(nodes.end(), mouth.nodes.begin(), mouth.nodes.end());
    keys.insert(mouth.key);
    volume += std::abs(mouth.inflow) * mouth.total_length();
  }
};

/// Each mouth that drives fluid, and all with a given inflow into the same piece of pore space.
std::vector<Source> sources_of(const std::vector<Mouth>& mouths, const std::vector<int>& piece) {
  std::vector<Source> sources;
  std::map<int, Source> joint;  // (piece)
  for (const Mouth& mouth : mouths) {
    const bool presses = mouth.conditions->flow.kind == FlowBoundaryKind::pressure;
    if ((mouth.inflow == 0 && !presses) || mouth.nodes.empty()) continue;
    sources.emplace_back().add(mouth);
    sources.back().presses = presses;
    if (mouth.inflow <= 0) continue;
    std::set<int> pieces;
    for (const std::size_t n : mouth.nodes) pieces.insert(piece[n]);
    for (const int own : pieces) joint[own].add(mouth);
  }
  for (auto& [own, source] : joint)
    if (source.keys.size() > 1) sources.push_back(std::move(source));
  return sources;
}

bool takes_fluid(const Mouth& mouth) {
  return mouth.yields() || (mouth.lets_fluid_through() && draws(mouth.conditions->flow, mouth.side));
}

}  // namespace

void look_for_passages(const Scene& scene, const NoSlipWalls& walls, const FluidPicture& picture,
                       const std::vector<Mouth>& mouths, const std::vector<int>& piece, const LatticeUnits& units,
                       FlowPaths& found) {
  // decay time of the slowest mode of a channel over viscosity * delay, with a pressure at one end or at both
  constexpr double one_end = 8 / (std::numbers::pi * std::numbers::pi), both_ends = one_end / 4;
  const double viscosity = scene.flow->viscosity / units.diffusivity();
  for (const Source& source : sources_of(mouths, piece)) {
    std::vector<bool> inlet(picture.size(), false), outlet(picture.size(), false);
    std::vector<std::size_t> outlets;
    for (const std::size_t n : source.nodes) inlet[n] = true;
    for (const Mouth& other : mouths) {
      if (!takes_fluid(other) || source.keys.contains(other.key)) continue;
      for (const std::size_t n : other.nodes) outlet[n] = true;
      outlets.insert(outlets.end(), other.nodes.begin(), other.nodes.end());
    }
    Passage passed = find_passage(walls, picture, source.nodes, outlet);
    if (passed.least == 0) continue;
    const Passage back = find_passage(walls, picture, outlets, inlet);  // outlets may be narrower than the mouth
    passed.least = std::min(passed.least, back.least);
    passed.peak = std::max(passed.peak, back.peak);
    passed.drag = std::max(passed.drag, back.drag);
    found.settling_steps =
        std::max(found.settling_steps, (source.presses ? both_ends : one_end) * viscosity * passed.delay);
    found.passage_speed = std::max(found.passage_speed, source.volume / static_cast<double>(passed.least));
    found.passage_peak = std::max(found.passage_peak, source.volume * passed.peak);
    found.passage_pressure = std::max(found.passage_pressure, viscosity * passed.drag * source.volume);
  }
}

}  // namespace vug
