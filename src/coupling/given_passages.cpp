#include "coupling/given_passages.hpp"

#include "coupling/passages.hpp"
#include "coupling/temperature_range.hpp"

#include <algorithm>
#include <map>
#include <numbers>

namespace vug {

namespace {

using Nodes = std::vector<std::size_t>;

/// What touches one piece of pore space.
struct Piece {
  std::vector<Nodes> given;                                               ///< nodes of each mouth with a given inflow
  std::vector<Nodes> pressing;                                            ///< nodes of each with a given pressure
  Nodes push, draw, yield;                                                ///< nodes of all that do
  double pushed = 0, drawn = 0, steadily_pushed = 0, steadily_drawn = 0;  ///< volumes per step, cells
};

/// Whether what a mouth gives is the same at all times.
bool is_steady(const FlowBoundary& flow) {
  if (const TimeTable* rate = flow.given_rate()) return rate->constant();
  return flow.speed.constant() && flow.velocity[0].constant() && flow.velocity[1].constant();
}

/// The pieces that mouths touch, by their numbers, and what is given and yields at the nodes of all. What is given by
/// mouths of the other sign opposes it only where it does so at all times.
struct Mouths {
  std::map<int, Piece> pieces;
  Ways pushing, drawing;

  Mouths(const std::vector<Mouth>& mouths, const std::vector<int>& piece)
      : pushing{std::vector<double>(piece.size(), 0.0), std::vector<bool>(piece.size(), false)}, drawing(pushing) {
    for (const Mouth& mouth : mouths)
      if (mouth.lets_fluid_through()) add(mouth, piece);
  }

 private:
  void add(const Mouth& mouth, const std::vector<int>& piece) {
    std::map<int, Nodes> own;
    for (std::size_t k = 0; k < mouth.nodes.size(); ++k) {
      const std::size_t n = mouth.nodes[k];
      own[piece[n]].push_back(n);
      if (mouth.yields()) pushing.yields[n] = drawing.yields[n] = true;
      if (mouth.inflow == 0) continue;
      const double volume = mouth.inflow * mouth.length[k];
      const bool steady = is_steady(mouth.conditions->flow);
      Piece& of_node = pieces[piece[n]];
      if (volume > 0 || steady) pushing.given[n] += volume;
      if (volume < 0 || steady) drawing.given[n] += volume;
      (volume > 0 ? of_node.pushed : of_node.drawn) += volume;
      if (steady) (volume > 0 ? of_node.steadily_pushed : of_node.steadily_drawn) += volume;
    }
    for (const auto& [number, nodes] : own) {
      Piece& touched = pieces[number];
      const auto join = [&](Nodes& all) { all.insert(all.end(), nodes.begin(), nodes.end()); };
      if (mouth.yields()) join(touched.yield);
      if (mouth.conditions->flow.kind == FlowBoundaryKind::pressure) touched.pressing.push_back(nodes);
      if (mouth.inflow == 0) continue;
      touched.given.push_back(nodes);
      join(mouth.inflow > 0 ? touched.push : touched.draw);
    }
  }
};

}  // namespace

void look_for_passages(const Scene& scene, const NoSlipWalls& walls, const FluidPicture& picture,
                       const std::vector<Mouth>& mouths, const std::vector<int>& piece, const LatticeUnits& units,
                       FlowPaths& found) {
  // decay time of the slowest mode of a channel over viscosity * delay, with a pressure at one end or at both
  constexpr double one_end = 8 / (std::numbers::pi * std::numbers::pi), both_ends = one_end / 4;
  const double viscosity = scene.flow->viscosity / units.diffusivity();
  const double highest = highest_viscosity(scene) / units.diffusivity();
  Mouths all(mouths, piece);
  const auto look = [&](const Nodes& begin, const Ways& ways, double beyond) {
    const Passage passed = find_passage(walls, picture, begin, ways, beyond);
    found.passage_speed = std::max(found.passage_speed, passed.speed);
    found.passage_peak = std::max(found.passage_peak, passed.peak);
    found.passage_pressure = std::max(found.passage_pressure, highest * passed.pressure);
    if (beyond == 0) found.settling_steps = std::max(found.settling_steps, one_end * viscosity * passed.delay);
  };
  for (const auto& [number, here] : all.pieces) {
    if (here.yield.empty() && (here.push.empty() || here.draw.empty())) continue;  // nothing gets through
    for (const Nodes& mouth : here.given) {
      const bool pushes = std::find(here.push.begin(), here.push.end(), mouth[0]) != here.push.end();
      look(mouth, pushes ? all.pushing : all.drawing, 0);
    }
    if (!here.push.empty()) look(here.push, all.pushing, 0);
    if (!here.draw.empty()) look(here.draw, all.drawing, 0);
    // what yields may be narrower than the mouths
    if (!here.yield.empty() && !here.push.empty()) look(here.yield, all.pushing, here.pushed + here.steadily_drawn);
    if (!here.yield.empty() && !here.draw.empty()) look(here.yield, all.drawing, here.drawn + here.steadily_pushed);
    for (const Nodes& mouth : here.pressing) {
      for (const std::size_t n : mouth) all.pushing.yields[n] = false;
      const Passage passed = find_passage(walls, picture, mouth, all.pushing);
      found.settling_steps = std::max(found.settling_steps, both_ends * viscosity * passed.delay);
      for (const std::size_t n : mouth) all.pushing.yields[n] = true;
    }
  }
}

}  // namespace vug
