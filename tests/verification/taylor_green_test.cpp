// The decay of Taylor and Green's vortices on a periodic square: order and error of the flow without walls.
#include "support/flow_setup.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace vug {
namespace {

using test::Flow;

struct Vortices {
  double k, speed;
  /// Exact state at the centre of node (x, y): u = -U cos kx sin ky, v = U sin kx cos ky, rho' = 3 p.
  Macroscopic<double> operator()(int x, int y) const {
    const double a = k * (x + 0.5), b = k * (y + 0.5);
    return {-0.75 * speed * speed * (std::cos(2 * a) + std::cos(2 * b)), -speed * std::cos(a) * std::sin(b),
            speed * std::sin(a) * std::cos(b)};
  }
};

/// Adds to the populations the part that belongs to the velocity gradient, as they are after collision:
/// (1 - 1/tau) (-3 tau w c c : grad u). Without it the error would be that of the start.
void add_gradient_part(Flow<double>& flow, const Vortices& v, double tau) {
  const auto f = Kokkos::create_mirror_view(flow.fields.f);
  Kokkos::deep_copy(f, flow.fields.f);
  const auto node = test::on_host(flow.nodes.node);
  for (int i = 0; i < flow.nodes.count; ++i) {
    const double a = v.k * (flow.lattice.x(node(i)) + 0.5), b = v.k * (flow.lattice.y(node(i)) + 0.5);
    const double xx = v.speed * v.k * std::sin(a) * std::sin(b);  // du/dx = -dv/dy; du/dy + dv/dx = 0
    for (int q = 0; q < 9; ++q) {
      const int cx = D2Q9::c(q, 0), cy = D2Q9::c(q, 1);
      f(q * flow.nodes.capacity + i) += (1 - tau) * 3 * D2Q9::w(q) * (cx * cx - cy * cy) * xx;
    }
  }
  Kokkos::deep_copy(flow.fields.f, f);
}

/// Relative L2 error of the velocity after the speed has halved, at Reynolds number U N/nu = 100.
double error_after_half_life(Collision collision, int n) {
  const double tau = 0.6, nu = (tau - 0.5) / 3;
  const Vortices start{2 * std::numbers::pi / n, 100 * nu / n};
  Flow<double> flow(n, n, {true, true}, collision, tau);
  flow.set(start);
  add_gradient_part(flow, start, tau);
  const int steps = static_cast<int>(std::round(std::log(2) / (2 * nu * start.k * start.k)));
  for (int t = 0; t < steps; ++t) flow.sweep();
  const Vortices end{start.k, start.speed * std::exp(-2 * nu * start.k * start.k * steps)};
  const auto u = test::on_host(flow.fields.u);
  const auto node = test::on_host(flow.nodes.node);
  double error2 = 0, size2 = 0;
  for (int i = 0; i < flow.nodes.count; ++i) {
    const Macroscopic<double> exact = end(flow.lattice.x(node(i)), flow.lattice.y(node(i)));
    error2 += std::pow(u(i, 0) - exact.ux, 2) + std::pow(u(i, 1) - exact.uy, 2);
    size2 += exact.ux * exact.ux + exact.uy * exact.uy;
  }
  return std::sqrt(error2 / size2);
}

TEST(TaylorGreen, SecondOrderInEveryCollision) {
  for (const Collision c : {Collision::trt, Collision::lallemand_luo, Collision::bgk, Collision::regularised}) {
    const double coarse = error_after_half_life(c, 32), fine = error_after_half_life(c, 64);
    EXPECT_GT(std::log2(coarse / fine), 1.9) << int(c);
    EXPECT_LT(fine, 2e-3) << int(c);  // (k dx)^2 = 0.01 times a coefficient of order 0.1
  }
}

}  // namespace
}  // namespace vug
