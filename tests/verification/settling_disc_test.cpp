// Terminal velocity of a disc that settles in a channel, from the force by momentum exchange.
//
// vug draws the rock on the lattice once, so the disc keeps its place and the channel moves: seen from the disc the
// walls slide upwards and the fluid comes from below, both at the speed at which the disc sinks.
#include "support/dress_one.hpp"
#include "support/node_force.hpp"
#include "support/record.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <optional>

namespace vug {
namespace {

/// A disc of diameter d nodes in a channel eight diameters wide, lattice units.
struct SettlingDisc {
  int d;
  test::Flow<double> flow;
  BoundaryLinks below, above, left, right;
  IndexList above_mirror;
  Surface surface;
  std::optional<test::NodeForce<double>> force;
  double speed = 0;

  SettlingDisc(int diameter, double nu)
      : d(diameter),
        flow(Lattice(8 * d, 15 * d), disc(d), {false, false}, Collision::trt, 0.5 + 3 * nu),
        below(flow.side(Side::bottom)),
        above(flow.side(Side::top)),
        left(flow.side(Side::left)),
        right(flow.side(Side::right)),
        above_mirror(flow.mirror(above)) {
    find_surface(flow.exec, flow.nodes, flow.type, surface);
    force.emplace(flow, surface);
  }
  static Kokkos::View<NodeType*> disc(int d) {
    return test::shape(Lattice(8 * d, 15 * d),
                       [d](int x, int y) { return std::hypot(x + 0.5 - 4 * d, y + 0.5 - 5 * d) < d / 2.0; });
  }
  /// One step of the flow at the present speed; returns the drag.
  double step() {
    for (const BoundaryLinks* moving : {&below, &left, &right})
      dress_velocity(flow.exec, flow.nodes, *moving, {0, speed}, flow.fields, flow.gain);
    dress_pressure(flow.exec, flow.nodes, above, above_mirror, 0, flow.fields, flow.gain);
    flow.sweep();
    const auto parts = (*force)(flow);
    double drag = 0;
    for (int s = 0; s < surface.count; ++s) drag += parts(s, 1);
    return drag;
  }
};

/// Reynolds number U d/nu at which drag and weight balance, for the Galileo number (rho_s/rho - 1) g d^3/nu^2.
double terminal_reynolds(int d, double galileo, double nu) {
  const double weight = std::numbers::pi / 4 * galileo * nu * nu / d;  // (rho_s - rho) g pi d^2/4
  SettlingDisc disc(d, nu);
  // twice the fluid's density: only the way to the terminal speed depends on it
  const double mass = 2 * std::numbers::pi / 4 * d * d;
  const int steps = static_cast<int>(3 * d * d / nu);  // 50 times the way through the channel
  for (int t = 0; t < steps; ++t) {
    const double acceleration = (weight - disc.step()) / mass;
    disc.speed += acceleration;
    disc.flow.step.body_force = {0, acceleration};  // the disc's frame of reference accelerates
  }
  return disc.speed * d / nu;
}

/// The disc of 2.5 mm and 1.25 g/cm3 in a channel of 2 cm, fluid of 1 g/cm3 and 0.1 g/(cm s), of R. Glowinski et al.,
/// J. Comput. Phys. 169 (2001) 363, and D. Wan and S. Turek, Int. J. Numer. Meth. Fluids 51 (2006) 531: largest
/// Reynolds numbers of 17.15 to 17.31, formed with the density of the disc.
TEST(SettlingDisc, SinksAtThePublishedSpeed) {
  const double density_ratio = 1.25, galileo = (density_ratio - 1) * 980 * std::pow(0.25, 3) / (0.1 * 0.1);
  for (const int d : {12, 16}) {
    const double reynolds = density_ratio * terminal_reynolds(d, galileo, 0.05);
    EXPECT_NEAR(reynolds, 17.27, 0.01 * 17.27) << d << " nodes";
    test::record("settling_disc", {{"nodes", d}, {"reynolds", reynolds}});
  }
}

}  // namespace
}  // namespace vug
