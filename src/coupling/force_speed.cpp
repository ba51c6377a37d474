#include "coupling/force_speed.hpp"

#include "coupling/pore_runs.hpp"
#include "coupling/temperature_range.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace vug {

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

/// Whether a piece of fluid connects two sides of the lattice at which the flow follows from the pressure.
bool is_open_through(const AxisView& view, const std::vector<Mouth>& mouths, const std::vector<int>& piece) {
  std::array<std::vector<int>, 2> at;
  for (const Mouth& mouth : mouths) {
    if (!mouth.yields() || !mouth.side) continue;
    for (const std::size_t n : mouth.nodes) {
      const int k = view.along(n);
      if (k == 0) at[0].push_back(piece[n]);
      if (k == view.length() - 1) at[1].push_back(piece[n]);
    }
  }
  return std::any_of(at[0].begin(), at[0].end(),
                     [&](int p) { return std::find(at[1].begin(), at[1].end(), p) != at[1].end(); });
}

/// Largest acceleration along an axis between open sides, lattice units: that of a body force f within a span and,
/// where both ends have given pressures, of their difference, |f + (p_0 - p_1)/L|. A fluid at rest under its weight has
/// none.
double acceleration_between_sides(const AxisView& view, const std::vector<Mouth>& mouths, const Span& f,
                                  const LatticeUnits& units) {
  const double force = std::max(-f.low, f.high);
  std::array<std::optional<Span>, 2> at;
  for (const Mouth& mouth : mouths) {
    if (!mouth.side || is_upright(*mouth.side) != (view.axis == 0) || !mouth.yields() || mouth.nodes.empty()) continue;
    const FlowBoundary& flow = mouth.conditions->flow;
    if (flow.kind != FlowBoundaryKind::pressure) return force;  // an outflow adapts its pressure
    std::optional<Span>& end = at[*mouth.side == Side::left || *mouth.side == Side::bottom ? 0 : 1];
    end = end ? end->with(pressures_of(flow, units)) : pressures_of(flow, units);
  }
  if (!at[0] || !at[1]) return force;
  const double length = view.length();
  return std::max(std::abs(f.low + (at[0]->low - at[1]->high) / length),
                  std::abs(f.high + (at[0]->high - at[1]->low) / length));
}

/// Largest speed times viscosity over acceleration, of one line of pores after the other in series; 0: blocked. Pores
/// of width w across the flow conduct w^3/12 each.
double speed_in_series(const AxisView& view, const std::vector<double>& across) {
  double resistance = 0, largest = 0;
  for (int k = 0; k < view.length(); ++k) {
    double conductance = 0, widest = 0;
    for (int line = 0; line < view.lines(); ++line) {
      const double w = across[view.node(line, k)];
      conductance += w * w / 12;  // each node has a share 1/w of that of its run
      widest = std::max(widest, w);
    }
    if (conductance == 0) return 0;
    if (std::isinf(conductance)) continue;
    resistance += 1 / conductance;
    largest = std::max(largest, widest * widest / (8 * conductance));
  }
  return resistance > 0 ? largest * view.length() / resistance : infinite;
}

}  // namespace

ForceSpeed body_force_speed(const Scene& scene, const BodyForces& forces, const FluidPicture& picture,
                            const std::vector<double>& width, const std::vector<Mouth>& mouths,
                            const std::vector<int>& piece, const LatticeUnits& units) {
  const double viscosity = lowest_viscosity(scene) / units.diffusivity();
  const double steps = scene.time.steps ? static_cast<double>(*scene.time.steps)
                       : scene.time.end ? *scene.time.end / units.time_step
                                        : infinite;
  const double widest = *std::max_element(width.begin(), width.end());
  ForceSpeed most;
  for (int axis = 0; axis < 2; ++axis) {
    if (forces.largest(axis) == 0) continue;
    const AxisView along{picture, axis};
    const AxisEnds ends = ends_of(scene, axis);
    if (!ends.joined && !is_open_through(along, mouths, piece)) continue;
    const double g =
        ends.joined ? forces.largest(axis) : acceleration_between_sides(along, mouths, forces.range[axis], units);
    const std::vector<double> across = widths_along({picture, 1 - axis}, ends_of(scene, 1 - axis));
    double speed = g / viscosity * std::min(widest * widest / 8, speed_in_series(along, across));
    if (!ends.joined) speed = std::min(speed, std::sqrt(2 * g * along.length()));
    most.ever = std::max(most.ever, speed);
    most.by_the_end = std::max(most.by_the_end, std::min(speed, g * steps));
  }
  return most;
}

}  // namespace vug
