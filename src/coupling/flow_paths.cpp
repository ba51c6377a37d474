#include "coupling/flow_paths.hpp"

#include "coupling/fluid_picture.hpp"
#include "coupling/velocity_profile.hpp"
#include "kernels/base/require.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <utility>

namespace vug {

namespace {

/// A stretch or an opening with the fluid nodes beside it.
struct Mouth {
  std::string key;  ///< "boundary.left", "boundary.shape.well"
  const BoundarySection* conditions;
  std::vector<std::size_t> nodes;
  double inflow = 0;  ///< volume that it takes in per step, cells; of prescribed velocities only

  bool lets_fluid_through() const {
    const FlowBoundaryKind kind = conditions->flow.kind;
    return kind == FlowBoundaryKind::pressure || kind == FlowBoundaryKind::velocity ||
           kind == FlowBoundaryKind::outflow;
  }
  bool lets_solute_through() const {
    const SoluteBoundaryKind kind = conditions->solute.kind;
    return kind != SoluteBoundaryKind::no_flux && kind != SoluteBoundaryKind::periodic;
  }
  /// Takes in or gives away whatever the pressure asks for.
  bool yields() const { return lets_fluid_through() && conditions->flow.kind != FlowBoundaryKind::velocity; }
};

std::vector<std::size_t> nodes_of_side(const Stretch& stretch, const FluidPicture& picture) {
  std::vector<std::size_t> nodes;
  for (int i = stretch.first; i <= stretch.last; ++i) {
    const std::size_t n = stretch.side == Side::left     ? picture.number(0, i)
                          : stretch.side == Side::right  ? picture.number(picture.nx - 1, i)
                          : stretch.side == Side::bottom ? picture.number(i, 0)
                                                         : picture.number(i, picture.ny - 1);
    if (picture.is_fluid(n)) nodes.push_back(n);
  }
  return nodes;
}

/// Fluid nodes beside an opening.
std::vector<std::size_t> nodes_of_opening(const std::vector<int>& opening_of, int opening,
                                          const FluidPicture& picture) {
  std::set<std::size_t> nodes;
  for (std::size_t n = 0; n < opening_of.size(); ++n)
    if (opening_of[n] == opening)
      picture.for_each_neighbour(n, [&](std::size_t m) {
        if (picture.is_fluid(m)) nodes.insert(m);
      });
  return {nodes.begin(), nodes.end()};
}

/// Component of a velocity that points into the lattice.
double inward(Side side, const std::array<TimeTable, 2>& velocity) {
  switch (side) {
    case Side::left:
      return velocity[0].peak();
    case Side::right:
      return -velocity[0].peak();
    case Side::bottom:
      return velocity[1].peak();
    default:
      return -velocity[1].peak();
  }
}

/// Volume that a boundary of so many nodes takes in per step at most, cells.
double inflow_of(const FlowBoundary& flow, const Stretch& stretch, std::size_t nodes, double density,
                 const LatticeUnits& units) {
  if (flow.kind != FlowBoundaryKind::velocity) return 0;
  if (flow.has_rate()) return flow.peak_rate(density) / units.diffusivity();
  const double speed = stretch.opening ? flow.speed.peak() : inward(stretch.side, flow.velocity);
  const double length = (stretch.last + 1 - stretch.first) * units.spacing;
  return speed / units.velocity() * mean_share(flow, length) * static_cast<double>(nodes);
}

std::vector<Mouth> mouths_of(const Scene& scene, const Geometry& geometry, const LatticeUnits& units,
                             const FluidPicture& picture) {
  const std::vector<int> opening_of = opening_of_nodes(scene);
  std::vector<Mouth> mouths;
  int opening = 0;
  for (const Stretch& stretch : boundary_stretches(scene, geometry)) {
    const auto injection = std::find_if(scene.injections.begin(), scene.injections.end(),
                                        [&](const InjectionSection& own) { return own.name == stretch.name; });
    const bool injects = injection != scene.injections.end();
    Mouth mouth{stretch.opening ? "boundary.shape." + stretch.name.substr(6)
                : injects       ? injection->key
                                : "boundary." + stretch.name,
                nullptr,
                {},
                0};
    mouth.nodes = stretch.opening ? nodes_of_opening(opening_of, opening, picture) : nodes_of_side(stretch, picture);
    mouth.conditions = stretch.opening                ? &geometry.openings[opening++].conditions
                       : injects                      ? &injection->conditions
                       : stretch.side == Side::left   ? &scene.left
                       : stretch.side == Side::right  ? &scene.right
                       : stretch.side == Side::bottom ? &scene.bottom
                                                      : &scene.top;
    if (scene.flow)
      mouth.inflow = inflow_of(mouth.conditions->flow, stretch, mouth.nodes.size(), scene.flow->density, units);
    mouths.push_back(std::move(mouth));
  }
  return mouths;
}

/// The least number of nodes at one distance from `mouth`, up to the first that lies at another that lets fluid out:
/// all that comes in crosses each of them. 0 where there is no way out.
std::size_t narrowest_passage(const FluidPicture& picture, const Mouth& mouth, const std::vector<bool>& outlet) {
  std::vector<bool> seen(picture.size(), false);
  std::vector<std::size_t> front = mouth.nodes;
  for (const std::size_t n : front) seen[n] = true;
  std::size_t least = front.size();
  while (!front.empty()) {
    least = std::min(least, front.size());
    if (std::any_of(front.begin(), front.end(), [&](std::size_t n) { return outlet[n]; })) return least;
    std::vector<std::size_t> next;
    for (const std::size_t n : front)
      picture.for_each_neighbour(n, [&](std::size_t m) {
        if (seen[m] || !picture.is_fluid(m)) return;
        seen[m] = true;
        next.push_back(m);
      });
    front = std::move(next);
  }
  return 0;
}

/// Nothing moves by more than the scheme can follow.
void look_for_speeds(const Scene& scene, const std::vector<Mouth>& mouths, const LatticeUnits& units) {
  for (const Mouth& mouth : mouths) {
    const FlowBoundary& flow = mouth.conditions->flow;
    const double nodes = static_cast<double>(std::max<std::size_t>(mouth.nodes.size(), 1));
    const double given = flow.has_rate() ? std::abs(mouth.inflow) / nodes : flow.peak_speed() / units.velocity();
    const double speed = largest_share(flow) * given;
    if (speed <= speed_bound) continue;
    const char* const key = flow.flow_rate             ? "flow_rate"
                            : flow.mass_flow_rate      ? "mass_flow_rate"
                            : flow.speed.peak() != 0.0 ? "speed"
                                                       : "velocity";
    throw InputError(
        fmt::format("{}: {}.flow.{} is {:.3g} cells in a time step, and above {:g} no run holds; lower it "
                    "or lattice.time_step",
                    scene.path, mouth.key, key, speed, speed_bound));
  }
}

/// All mouths of one name reach no fluid.
void look_for_dry_mouths(const Scene& scene, const std::vector<Mouth>& mouths, bool rock_opens, FlowPaths& found) {
  for (const Mouth& mouth : mouths) {
    const bool flows = scene.flow && mouth.lets_fluid_through(), carries = scene.solute && mouth.lets_solute_through();
    const bool dry = std::all_of(mouths.begin(), mouths.end(),
                                 [&](const Mouth& other) { return other.key != mouth.key || other.nodes.empty(); });
    if ((!flows && !carries) || !dry) continue;
    const std::string line = fmt::format("{}.{} has no effect{}: no fluid touches it", mouth.key,
                                         flows ? "flow" : "solute", rock_opens ? " until rock opens" : "");
    if (mouth.key.starts_with("boundary.injection") && !rock_opens)
      throw InputError(fmt::format("{}: {}", scene.path, line));
    if (std::find(found.warnings.begin(), found.warnings.end(), line) == found.warnings.end())
      found.warnings.push_back(line);
  }
}

/// What is pressed into a piece of fluid must find a way out of it.
void look_for_ways_out(const Scene& scene, const std::vector<Mouth>& mouths, const std::vector<int>& piece,
                       bool rock_opens, FlowPaths& found) {
  const int pieces = 1 + *std::max_element(piece.begin(), piece.end());
  std::vector<double> net(pieces, 0), gross(pieces, 0);
  std::vector<bool> yields(pieces, false), curved(pieces, false);
  std::vector<std::string> driven_by(pieces);
  for (const Mouth& mouth : mouths)
    for (const std::size_t n : mouth.nodes) {
      const double flow = mouth.inflow / static_cast<double>(mouth.nodes.size());
      net[piece[n]] += flow;
      gross[piece[n]] += std::abs(flow);
      if (flow != 0) driven_by[piece[n]] = mouth.key;
      if (mouth.yields()) yields[piece[n]] = true;
      if (mouth.key.starts_with("boundary.shape.")) curved[piece[n]] = true;
    }
  // velocities given to three digits may leave the first, the nodes counted for the outline of a shape the second
  constexpr double balanced = 1e-3, balanced_outline = 0.3;
  for (int p = 0; p < pieces; ++p) {
    if (yields[p] || std::abs(net[p]) <= (curved[p] ? balanced_outline : balanced) * gross[p]) continue;
    const std::string line = fmt::format("{}.flow {} fluid {} a space that has no other opening", driven_by[p],
                                         net[p] > 0 ? "presses" : "draws", net[p] > 0 ? "into" : "out of");
    if (!rock_opens) throw InputError(fmt::format("{}: {}", scene.path, line));
    found.warnings.push_back(line + " until rock opens");
    return;
  }
}

/// The highest pressure should reach another mouth.
void look_for_paths(const std::vector<Mouth>& mouths, const std::vector<int>& piece, bool rock_opens,
                    FlowPaths& found) {
  const Mouth* inlet = nullptr;
  for (const Mouth& mouth : mouths)
    if (!mouth.nodes.empty() && mouth.conditions->flow.kind == FlowBoundaryKind::pressure &&
        (!inlet || mouth.conditions->flow.pressure.peak() > inlet->conditions->flow.pressure.peak()))
      inlet = &mouth;
  if (!inlet) return;
  std::set<int> own;
  for (const Mouth& mouth : mouths)
    if (mouth.key == inlet->key)
      for (const std::size_t n : mouth.nodes) own.insert(piece[n]);
  bool others = false;
  for (const Mouth& mouth : mouths) {
    if (mouth.key == inlet->key || !mouth.lets_fluid_through() || mouth.nodes.empty()) continue;
    others = true;
    if (std::any_of(mouth.nodes.begin(), mouth.nodes.end(), [&](std::size_t n) { return own.count(piece[n]) > 0; }))
      return;
  }
  if (others)
    found.warnings.push_back(
        fmt::format("no path of fluid leads from {} to another open side or shape: nothing flows{}", inlet->key,
                    rock_opens ? " until rock opens" : ""));
}

void look_for_passages(const FluidPicture& picture, const std::vector<Mouth>& mouths, FlowPaths& found) {
  for (const Mouth& mouth : mouths) {
    if (mouth.inflow == 0 || mouth.nodes.empty()) continue;
    std::vector<bool> outlet(picture.size(), false);
    for (const Mouth& other : mouths)
      if (other.lets_fluid_through() && other.key != mouth.key)
        for (const std::size_t n : other.nodes) outlet[n] = true;
    const std::size_t least = narrowest_passage(picture, mouth, outlet);
    if (least > 0)
      found.passage_speed = std::max(found.passage_speed, std::abs(mouth.inflow) / static_cast<double>(least));
  }
}

}  // namespace

FlowPaths find_flow_paths(const Scene& scene, const Geometry& geometry, const LatticeUnits& units) {
  FlowPaths found;
  if (!scene.flow && !scene.solute) return found;
  const FluidPicture picture(scene, geometry);
  if (picture.fluid_nodes() == 0)
    throw InputError(fmt::format("{}: the geometry has no fluid node, and {} is only in fluid", scene.path,
                                 scene.flow ? "[flow]" : "[solute]"));
  const bool rock_opens = scene.damage || rock_dissolves(scene);
  const std::vector<Mouth> mouths = mouths_of(scene, geometry, units, picture);
  if (scene.flow) look_for_speeds(scene, mouths, units);
  look_for_dry_mouths(scene, mouths, rock_opens, found);
  if (!scene.flow) return found;
  const std::vector<int> piece = pieces_of(picture);
  look_for_ways_out(scene, mouths, piece, rock_opens, found);
  look_for_paths(mouths, piece, rock_opens, found);
  look_for_passages(picture, mouths, found);
  return found;
}

}  // namespace vug
