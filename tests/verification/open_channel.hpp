#pragma once
// A channel between open sides.
#include "kernels/flow/guards.hpp"
#include "support/dress_one.hpp"
#include "support/flow_setup.hpp"
#include "support/host_copy.hpp"

#include <gtest/gtest.h>

#include <array>
#include <numeric>
#include <vector>

namespace vug::test::open_channel {

inline constexpr Collision collisions[] = {Collision::trt, Collision::lallemand_luo, Collision::bgk,
                                           Collision::regularised};
inline constexpr const char* names[] = {"trt", "lallemand_luo", "bgk", "regularised"};
inline constexpr double tau = 0.764, nu = (tau - 0.5) / 3;

/// A channel of `width` cells between walls, `length` cells from its inlet to its outlet, which may be any side.
struct Channel {
  Side outlet;
  int length, width;
  Flow<double> flow;
  BoundaryLinks in, out;
  IndexList in_mirror, out_mirror;
  OutflowState outflow;

  Channel(Collision collision, Side outlet_side, int cells_along, int cells_across)
      : outlet(outlet_side),
        length(cells_along),
        width(cells_across),
        flow(upright() ? width : length, upright() ? length : width, {false, false}, collision, tau),
        in(side(inlet())),
        out(side(outlet)),
        in_mirror(flow.mirror(in)),
        out_mirror(flow.mirror(out)) {
    fit_to_links(flow.exec, flow.nodes, out, outflow);
  }
  Side inlet() const { return static_cast<Side>(D2Q9::opposite(static_cast<int>(outlet))); }
  /// The links out of corners belong to the walls, or to the inlet if it is `fed`: as in a case.
  BoundaryLinks side(Side which, bool fed = false) const {
    const Side wall = upright() ? Side::left : Side::bottom, other = upright() ? Side::right : Side::top;
    const SideOrder order = fed ? SideOrder{inlet(), wall, other, outlet} : SideOrder{wall, other, inlet(), outlet};
    const bool end = which == inlet() || which == outlet;
    return find_boundary_links(flow.exec, flow.nodes, which, 0, (end ? width : length) - 1, D2Q9::Q, order);
  }
  bool upright() const { return outlet == Side::top || outlet == Side::bottom; }
  bool backwards() const { return outlet == Side::left || outlet == Side::bottom; }
  /// Density, speed along and across the channel `along` cells from the inlet.
  Macroscopic<double> at(int along, int across) const {
    const int s = backwards() ? length - 1 - along : along;
    const Macroscopic<double> m = upright() ? flow.at(across, s) : flow.at(s, across);
    const double sign = backwards() ? -1 : 1;
    return {m.rho, sign * (upright() ? m.uy : m.ux), upright() ? m.ux : m.uy};
  }
  /// Everything at once: row `along` * width + across.
  std::vector<Macroscopic<double>> fields() const {
    const auto density = host_copy(densities(flow.exec, flow.nodes, flow.fields));
    const auto u = host_copy(flow.fields.u);
    const auto index = host_copy(flow.nodes.index);
    std::vector<Macroscopic<double>> all;
    for (int along = 0; along < length; ++along)
      for (int across = 0; across < width; ++across) {
        const int s = backwards() ? length - 1 - along : along, sign = backwards() ? -1 : 1;
        const int i = index(upright() ? flow.lattice.node(across, s) : flow.lattice.node(s, across));
        all.push_back({density(i), sign * u(i, upright() ? 1 : 0), u(i, upright() ? 0 : 1)});
      }
    return all;
  }
  std::array<double, 2> towards_outlet(double speed) const {
    const int q = static_cast<int>(outlet);
    return {speed * D2Q9::c(q, 0), speed * D2Q9::c(q, 1)};
  }
  /// Steps (with `dress` before each) until the largest change of velocity in 200 steps is `tolerance` of the largest.
  template <class Dress>
  void run_to_rest(double tolerance, const Dress& dress) {
    const VectorField<double> previous("previous", flow.nodes.capacity);
    for (int t = 0; t < 200'000; t += 200) {
      for (int k = 0; k < 200; ++k) {
        dress();
        flow.sweep();
      }
      const double largest = flow_extremes(flow.exec, flow.nodes, flow.fields, 1, 1).speed;
      if (velocity_change(flow.exec, flow.nodes, flow.fields.u, previous, {largest}) <= tolerance) return;
    }
    FAIL() << "the flow did not become steady";
  }
  void hold_pressure(const BoundaryLinks& side, const IndexList& mirror, double p) {
    dress_pressure(flow.exec, flow.nodes, side, mirror, p, flow.fields, flow.gain);
  }
  /// Every link through the open sides its own image: anti-bounce-back, which leaves the shear along them free.
  void forget_mirrors() {
    for (const IndexList& mirror : {in_mirror, out_mirror}) {
      const auto own = Kokkos::create_mirror_view(mirror);
      std::iota(own.data(), own.data() + own.extent(0), 0);
      Kokkos::deep_copy(mirror, own);
    }
  }
  void let_out() { dress_outflow(flow.exec, flow.nodes, out, out_mirror, outflow, flow.fields, flow.gain); }
};

/// What every node of the scheme has for a pressure gradient: the parabola and the slip of halfway bounce-back
/// (Ginzburg and d'Humieres), which is none with two relaxation times.
inline double node_speed(Collision collision, double gradient, int width, int across) {
  const RelaxationRates r = relaxation_rates(collision, tau);
  const double lambda = (1 / r.s_nu - 0.5) * (1 / r.s_q - 0.5), y = across + 0.5;
  return gradient / (2 * nu) * (y * (width - y) + 4 * lambda / 3 - 0.25);
}

}  // namespace vug::test::open_channel
