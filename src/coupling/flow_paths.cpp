#include "coupling/flow_paths.hpp"

#include "coupling/mouths.hpp"
#include "kernels/base/require.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

namespace vug {

namespace {

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
void look_for_speeds(const Scene& scene, const std::vector<Mouth>& mouths) {
  for (const Mouth& mouth : mouths) {
    const FlowBoundary& flow = mouth.conditions->flow;
    if (mouth.peak_speed <= speed_bound) continue;
    const char* const key = flow.flow_rate             ? "flow_rate"
                            : flow.mass_flow_rate      ? "mass_flow_rate"
                            : flow.speed.peak() != 0.0 ? "speed"
                                                       : "velocity";
    if (std::isinf(mouth.peak_speed))
      throw InputError(
          fmt::format("{}: the shares of {}.flow.profile_table beside fluid have no positive sum, and {} is spread by "
                      "them",
                      scene.path, mouth.key, key));
    throw InputError(
        fmt::format("{}: {}.flow.{} is {:.3g} cells in a time step, and above {:g} no run is stable; lower it "
                    "or lattice.time_step",
                    scene.path, mouth.key, key, mouth.peak_speed, speed_bound));
  }
}

/// All mouths of one name reach no fluid: of a side a remark, of what stands in the case for this alone a mistake.
void look_for_dry_mouths(const Scene& scene, const std::vector<Mouth>& mouths, bool rock_opens, FlowPaths& found) {
  for (const Mouth& mouth : mouths) {
    const bool flows = scene.flow && mouth.lets_fluid_through(), carries = scene.solute && mouth.lets_solute_through();
    const bool dry = std::all_of(mouths.begin(), mouths.end(),
                                 [&](const Mouth& other) { return other.key != mouth.key || other.nodes.empty(); });
    if ((!flows && !carries) || !dry) continue;
    const std::string line = fmt::format("{}.{} has no effect{}: no fluid touches it", mouth.key,
                                         flows ? "flow" : "solute", rock_opens ? " until rock opens" : "");
    const bool on_purpose = mouth.key.starts_with("boundary.injection") || mouth.key.starts_with("boundary.shape.");
    if (on_purpose && !rock_opens) throw InputError(fmt::format("{}: {}", scene.path, line));
    if (std::find(found.warnings.begin(), found.warnings.end(), line) == found.warnings.end())
      found.warnings.push_back(line);
  }
}

/// What is pressed into a piece of fluid must find a way out of it.
void look_for_ways_out(const Scene& scene, const std::vector<Mouth>& mouths, const std::vector<int>& piece,
                       bool rock_opens, FlowPaths& found) {
  const int pieces = 1 + *std::max_element(piece.begin(), piece.end());
  std::vector<double> net(pieces, 0), gross(pieces, 0);
  std::vector<bool> yields(pieces, false);
  std::vector<std::string> driven_by(pieces);
  for (const Mouth& mouth : mouths)
    for (std::size_t k = 0; k < mouth.nodes.size(); ++k) {
      const int p = piece[mouth.nodes[k]];
      const double flow = mouth.inflow * mouth.length[k];
      net[p] += flow;
      gross[p] += std::abs(flow);
      if (flow != 0) driven_by[p] = mouth.key;
      if (mouth.yields()) yields[p] = true;
    }
  constexpr double balanced = 1e-3;  // velocities given to three digits may leave as much
  for (int p = 0; p < pieces; ++p) {
    if (yields[p] || std::abs(net[p]) <= balanced * gross[p]) continue;
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
      found.passage_speed =
          std::max(found.passage_speed, std::abs(mouth.inflow) * mouth.total_length() / static_cast<double>(least));
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
  if (scene.flow) look_for_speeds(scene, mouths);
  look_for_dry_mouths(scene, mouths, rock_opens, found);
  if (!scene.flow) return found;
  const std::vector<int> piece = pieces_of(picture);
  look_for_ways_out(scene, mouths, piece, rock_opens, found);
  look_for_paths(mouths, piece, rock_opens, found);
  look_for_passages(picture, mouths, found);
  return found;
}

}  // namespace vug
