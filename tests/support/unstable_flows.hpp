#pragma once
// Two flows that ask for more than a lattice of their size resolves: where do the collisions break?
#include "kernels/flow/guards.hpp"
#include "support/dress_one.hpp"
#include "support/flow_setup.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace vug::test {

/// A run is lost when its state is not finite or far beyond anything physical.
template <class T>
bool alive(const Flow<T>& flow) {
  return flow_extremes(flow.exec, flow.nodes, flow.fields, 0.8, 3).bad < 0;
}

/// True when the doubly periodic shear layer of Minion and Brown (thickness 1/80, perturbed by 5 %) on 48 x 48 nodes
/// with largest speed `speed` lives for 3000 steps.
inline bool shear_layer_survives(Collision collision, double tau, double speed) {
  constexpr int n = 48;
  Flow<double> flow(n, n, {true, true}, collision, tau);
  flow.set([&](int i, int j) {
    const double x = (i + 0.5) / n, y = (j + 0.5) / n;
    const double u = std::tanh(80 * (y <= 0.5 ? y - 0.25 : 0.75 - y));
    return Macroscopic<double>{0, speed * u, 0.05 * speed * std::sin(2 * std::numbers::pi * (x + 0.25))};
  });
  for (int t = 0; t < 3000; ++t) {
    flow.sweep();
    if (t % 250 == 249 && !alive(flow)) return false;
  }
  return true;
}

/// Outcome of a pressure-driven flow through staircase obstacles.
struct Percolation {
  bool survives = true;
  double largest_speed = 0;  ///< when it survives
  double limited = 0;        ///< uses of the speed limiter
};

/// 100 x 60 nodes with staircase discs, pressure `difference` (in lattice density units, rho' = 3 p) between left and
/// right, ramped over `ramp` steps; 8000 steps in all. A limit of 0 leaves the speed alone.
inline Percolation percolate(Collision collision, double tau, double difference, int ramp, double speed_limit) {
  const Lattice lattice(100, 60);
  constexpr double discs[][3] = {{15, 12, 7}, {14, 40, 9}, {35, 27, 8}, {38, 52, 7}, {52, 8, 7},
                                 {58, 38, 8}, {75, 20, 9}, {80, 50, 8}, {92, 8, 5}};
  const auto type = shape(lattice, [&](int x, int y) {
    return std::any_of(std::begin(discs), std::end(discs),
                       [&](const auto& d) { return std::hypot(x - d[0], y - d[1]) < d[2]; });
  });
  Flow<double> flow(lattice, type, {false, false}, collision, tau);
  flow.step.speed_limit = speed_limit;
  const BoundaryLinks left = flow.side(Side::left), right = flow.side(Side::right);
  const IndexList left_mirror = flow.mirror(left), right_mirror = flow.mirror(right);
  for (int t = 0; t < 8000; ++t) {
    const double rise = ramp > 0 ? std::min(1.0, t / double(ramp)) : 1.0;
    dress_pressure(flow.exec, flow.nodes, left, left_mirror, rise * difference / 3, flow.fields, flow.gain);
    dress_pressure(flow.exec, flow.nodes, right, right_mirror, 0, flow.fields, flow.gain);
    flow.sweep();
    if (t % 250 == 249 && !alive(flow)) return {false, 0, sum_in_order(flow.step.limited)};
  }
  return {true, flow_extremes(flow.exec, flow.nodes, flow.fields, 1, 3).speed, sum_in_order(flow.step.limited)};
}

}  // namespace vug::test
