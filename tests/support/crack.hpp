#pragma once
// A crack that closes on itself on a periodic lattice, and what it conducts.
#include "base/splitmix64.hpp"
#include "coupling/strip.hpp"
#include "kernels/flow/slit_drag.hpp"
#include "support/flow_setup.hpp"
#include "support/host_copy.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <vector>

namespace vug::test {

struct Direction {
  int degrees;
  std::array<int, 2> over;
  /// Across the axis that it follows more closely.
  double slope() const { return static_cast<double>(std::min(over[0], over[1])) / std::max(over[0], over[1]); }
};

/// Directions to 0.01 degrees.
inline const std::vector<Direction> directions{{0, {101, 0}},  {5, {103, 9}},  {10, {97, 17}}, {15, {97, 26}},
                                               {20, {91, 33}}, {25, {90, 42}}, {30, {71, 41}}, {37, {73, 55}},
                                               {45, {71, 71}}, {60, {41, 71}}, {75, {26, 97}}, {90, {0, 101}}};

/// On a lattice of `columns` x `rows`: `bonds` bonds from (0, start) to (over[0], start + over[1]), both of which are
/// the same place or lie one lattice apart.
struct Crack {
  int columns, rows;
  std::array<int, 2> over;
  int bonds = 4;
  double start = 0.13;
  std::vector<double> ends;  ///< (bond) where it ends, as a share of the way; equal bonds where empty

  /// Once around a lattice that is no wider than needed.
  explicit Crack(const Direction& direction)
      : columns(direction.over[0] > 0 ? direction.over[0] : 20),
        rows(direction.over[1] > 0 ? direction.over[1] : 20),
        over(direction.over) {}
  Crack(int wide, int high, std::array<int, 2> way, int parts = 4, double from = 0.13)
      : columns(wide), rows(high), over(way), bonds(parts), start(from) {}

  /// A crack as generated rock has them: at a random place, its bonds 0.6 to 1.4 times as long as their mean.
  static Crack at_random(const Direction& direction, int bonds, std::uint64_t seed) {
    CounterRandom random{splitmix64(seed)};
    Crack crack(direction);
    crack.bonds = bonds;
    crack.start = random.uniform();
    double sum = 0;
    for (int bond = 0; bond < bonds; ++bond) crack.ends.push_back(sum += 0.6 + 0.8 * random.uniform());
    for (double& end : crack.ends) end /= sum;
    return crack;
  }

  double length() const { return std::hypot(over[0], over[1]); }

  std::vector<char> open(double aperture) const {
    constexpr int margin = 20;
    const Lattice wide(columns + 2 * margin, 2 * rows + 2 * margin);
    std::vector<char> open(static_cast<std::size_t>(columns) * rows, 0);
    const auto at = [&](int bond) {
      const double share = bond > 0 && !ends.empty() ? ends[bond - 1] : static_cast<double>(bond) / bonds;
      return std::array{margin + share * over[0], margin + start + share * over[1]};
    };
    for (int bond = 0; bond < bonds; ++bond)
      for (const StripNode& entry : strip_nodes(at(bond), at(bond + 1), aperture, wide, 1)) {
        const int x = (entry.node % wide.nx - margin + columns) % columns;
        const int y = (entry.node / wide.nx - margin + rows) % rows;
        open[static_cast<std::size_t>(y) * columns + x] = 1;
      }
    return open;
  }

  /// Viscosity times flow rate over the pressure gradient along the crack, cells^3, of the strip of `aperture` with the
  /// given resistance in every node.
  double conductivity(double aperture, double resistance = 0, Collision collision = Collision::trt) const {
    const auto fluid = open(aperture);
    const double tau = resistance > 100 ? 0.53 : 1.5, viscosity = (tau - 0.5) / 3,
                 gradient = 1e-8;  // so slow that it is Stokes flow
    const Lattice lattice(columns, rows);
    Flow<double> flow(lattice,
                      shape(lattice, [&](int x, int y) { return !fluid[static_cast<std::size_t>(y) * columns + x]; }),
                      {true, true}, collision, tau);
    for (int axis = 0; axis < 2; ++axis) flow.step.body_force[axis] = gradient * over[axis] / length();
    const SlitNodes slits = all_nodes(flow.nodes, resistance);
    // The sum of the velocities is the flow rate times the way once along the crack.
    double rate = 0;
    for (int sweep = 0; sweep < 100000; sweep += 100) {
      double sum = 0;
      for (int k = 0; k < 100; ++k) {
        flow.sweep();
        if (resistance > 0) drag_in_slits(flow.exec, flow.nodes, slits, viscosity, flow.step, flow.fields);
        if (k < 98) continue;  // of two sweeps: what drag holds back swings to and fro
        const auto u = host_copy(flow.fields.u);
        for (int i = 0; i < flow.nodes.count; ++i) sum += (u(i, 0) * over[0] + u(i, 1) * over[1]) / length();
      }
      const double now = sum / (2 * length());
      if (std::abs(now - rate) < 1e-8 * std::abs(now)) return viscosity * now / gradient;
      rate = now;
    }
    ADD_FAILURE() << "the flow did not become steady";
    return 0;
  }

  static SlitNodes all_nodes(const FluidNodes& nodes, double resistance) {
    std::vector<int> fluid(nodes.count);
    std::iota(fluid.begin(), fluid.end(), 0);
    return {nodes.count, to_device<IndexList>("fluid", fluid),
            to_device<ScalarField<double>>("resistance", std::vector<double>(nodes.count, resistance)),
            to_device<IndexList>("first", {0, nodes.count}), ScalarField<double>()};
  }
};

}  // namespace vug::test
