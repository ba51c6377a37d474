#include "coupling/force_speed.hpp"

#include "coupling/driving_pressure.hpp"
#include "coupling/temperature_range.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace vug {

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

/// A picture seen along one axis: `k` counts along it, `line` across it.
struct View {
  const FluidPicture& picture;
  int axis;
  int length() const { return axis == 0 ? picture.nx : picture.ny; }
  int lines() const { return axis == 0 ? picture.ny : picture.nx; }
  std::size_t node(int line, int k) const { return axis == 0 ? picture.number(k, line) : picture.number(line, k); }
  bool is_fluid(int line, int k) const { return picture.is_fluid(node(line, k)); }
};

/// What bounds the fluid at the ends of an axis.
struct Ends {
  bool joined = false;
  std::array<bool, 2> open{false, false};
};

Ends ends_of(const Scene& scene, int axis) {
  const BoundarySection& low = axis == 0 ? scene.left : scene.bottom;
  const BoundarySection& high = axis == 0 ? scene.right : scene.top;
  return {periodic_sides(scene)[axis], {is_open(low.flow), is_open(high.flow)}};
}

/// (node) Width of the channel between walls in which fluid would flow as in its run of fluid nodes along an axis:
/// twice the run where one end of it is at an open side, infinite where nothing holds the fluid.
std::vector<double> widths(const View& view, const Ends& ends) {
  std::vector<double> width(view.picture.size(), 0);
  const int n = view.length();
  for (int line = 0; line < view.lines(); ++line) {
    int rock = -1;
    for (int k = 0; k < n && rock < 0; ++k)
      if (!view.is_fluid(line, k)) rock = k;
    const int start = ends.joined && rock >= 0 ? rock : 0;  // where lines are joined, no run begins in the middle
    for (int k = start; k < start + n;) {
      int end = k;
      while (end < start + n && view.is_fluid(line, end % n)) ++end;
      const bool first = !ends.joined && k == 0 && ends.open[0], last = !ends.joined && end == n && ends.open[1];
      const bool free = ends.joined ? rock < 0 : first && last;
      for (int m = k; m < end; ++m)
        width[view.node(line, m % n)] = free ? infinite : (first || last ? 2.0 : 1.0) * (end - k);
      k = std::max(end, k + 1);
    }
  }
  return width;
}

/// Whether a piece of fluid connects two sides of the lattice at which the flow follows from the pressure.
bool is_open_through(const View& view, const std::vector<Mouth>& mouths, const std::vector<int>& piece) {
  std::array<std::vector<int>, 2> at;
  for (const Mouth& mouth : mouths) {
    if (!mouth.yields() || mouth.key.starts_with("boundary.shape.")) continue;
    for (const std::size_t n : mouth.nodes) {
      const int k = static_cast<int>(view.axis == 0 ? n % view.picture.nx : n / view.picture.nx);
      if (k == 0) at[0].push_back(piece[n]);
      if (k == view.length() - 1) at[1].push_back(piece[n]);
    }
  }
  return std::any_of(at[0].begin(), at[0].end(),
                     [&](int p) { return std::find(at[1].begin(), at[1].end(), p) != at[1].end(); });
}

/// Largest acceleration along an axis between open sides, lattice units: that of the body force f and, where both ends
/// have given pressures, of their difference, |f + (p_0 - p_1)/L|. A fluid at rest under its weight has none.
double acceleration_between_sides(const View& view, const std::vector<Mouth>& mouths, double f,
                                  const LatticeUnits& units) {
  std::array<std::optional<Span>, 2> at;
  for (const Mouth& mouth : mouths) {
    if (!mouth.side || is_upright(*mouth.side) != (view.axis == 0) || !mouth.yields() || mouth.nodes.empty()) continue;
    const FlowBoundary& flow = mouth.conditions->flow;
    if (flow.kind != FlowBoundaryKind::pressure) return std::abs(f);  // an outflow adapts its pressure
    std::optional<Span>& end = at[*mouth.side == Side::left || *mouth.side == Side::bottom ? 0 : 1];
    end = end ? end->with(pressures_of(flow, units)) : pressures_of(flow, units);
  }
  if (!at[0] || !at[1]) return std::abs(f);
  const double length = view.length();
  return std::max(std::abs(f + (at[0]->low - at[1]->high) / length), std::abs(f + (at[0]->high - at[1]->low) / length));
}

/// Largest speed times viscosity over acceleration, of one line of pores after the other in series; 0: blocked. Pores
/// of width w across the flow conduct w^3/12 each.
double speed_in_series(const View& view, const std::vector<double>& across) {
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

double body_force_speed(const Scene& scene, const FluidPicture& picture, const std::vector<Mouth>& mouths,
                        const std::vector<int>& piece, const LatticeUnits& units) {
  const double viscosity = lowest_viscosity(scene) / units.diffusivity();
  const double steps = scene.time.steps ? static_cast<double>(*scene.time.steps)
                       : scene.time.end ? *scene.time.end / units.time_step
                                        : infinite;
  double most = 0;
  for (int axis = 0; axis < 2; ++axis) {
    const double f = scene.flow->body_force[axis] / (units.acceleration() * units.pressure_scale);
    if (f == 0) continue;
    const View along{picture, axis}, over{picture, 1 - axis};
    const Ends ends = ends_of(scene, axis);
    if (!ends.joined && !is_open_through(along, mouths, piece)) continue;
    const double g = ends.joined ? std::abs(f) : acceleration_between_sides(along, mouths, f, units);
    const std::vector<double> length = widths(along, ends), across = widths(over, ends_of(scene, 1 - axis));
    double widest = 0;
    for (std::size_t n = 0; n < length.size(); ++n) widest = std::max(widest, std::min(length[n], across[n]));
    double speed = g / viscosity * std::min(widest * widest / 8, speed_in_series(along, across));
    speed = std::min(speed, g * steps);
    if (!ends.joined) speed = std::min(speed, std::sqrt(2 * g * along.length()));
    most = std::max(most, speed);
  }
  return most;
}

}  // namespace vug
