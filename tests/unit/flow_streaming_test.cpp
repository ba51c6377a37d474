// The sweep in place does what the textbook does with two lattices, node by node: at openings, through births, after
// even and odd numbers of steps.
#include "kernels/flow/two_relaxation_times.hpp"
#include "support/dress_one.hpp"
#include "support/flow_setup.hpp"
#include "support/host_copy.hpp"
#include "support/populations.hpp"

#include <gtest/gtest.h>

#include <array>

namespace vug {
namespace {

using test::draw;
using test::Flow;
using test::host_copy;
using test::populations;

/// Pulls all populations from one lattice, collides them and stores them at home in another.
void sweep_two_lattices(Flow<double>& flow) {
  const auto f = host_copy(flow.fields.f);
  const auto source = host_copy(flow.nodes.source);
  const auto next = Kokkos::create_mirror_view(flow.fields.f);
  const auto u = Kokkos::create_mirror_view(flow.fields.u);
  const int capacity = flow.nodes.capacity;
  const TwoRelaxationTimes<double> relax(flow.step.rates);
  std::vector<double> stored(f.extent(0));
  for (int i = 0; i < flow.nodes.count; ++i) {
    double g[9];
    for (int q = 0; q < 9; ++q) g[q] = f(q == 0 ? i : source(q * capacity + i));
    const Macroscopic<double> m = macroscopic(g);
    relax(g, m, NoForce<double>{});
    for (int q = 0; q < 9; ++q) stored[q * capacity + i] = g[q];
    u(i, 0) = m.ux;
    u(i, 1) = m.uy;
  }
  for (std::size_t k = 0; k < stored.size(); ++k) next(k) = stored[k];
  Kokkos::deep_copy(flow.fields.f, next);
  Kokkos::deep_copy(flow.fields.u, u);
}

TEST(Streaming, InPlaceIsTwoLatticesAfterAnyNumberOfSteps) {
  const Lattice lattice(7, 6);
  const auto type = draw(lattice, {"..#....", ".......", "#..##..", "...#...", ".......", "..#...."});
  const auto state = [](int x, int y) { return Macroscopic<double>{0.01 * x, 0.01 * y, -0.02 * x}; };
  Flow<double> in_place(lattice, type, {true, false}), two(lattice, type, {true, false});
  in_place.set(state);
  two.set(state);
  const BoundaryLinks top = in_place.side(Side::top), bottom = in_place.side(Side::bottom);
  const IndexList top_mirror = in_place.mirror(top);
  for (int t = 0; t < 7; ++t) {
    for (Flow<double>* flow : {&in_place, &two}) {
      dress_pressure(flow->exec, flow->nodes, top, top_mirror, 0.01, flow->fields, flow->gain);
      dress_velocity(flow->exec, flow->nodes, bottom, {0.01, 0.02}, flow->fields, flow->gain);
    }
    in_place.sweep();
    sweep_two_lattices(two);
    EXPECT_NEAR(in_place.mass(), two.mass(), 1e-14);
    EXPECT_EQ(sum_in_order(in_place.gain), sum_in_order(two.gain));
    const auto density = host_copy(densities(in_place.exec, in_place.nodes, in_place.fields));
    const auto expected = host_copy(densities(two.exec, two.nodes, two.fields));
    for (int i = 0; i < two.nodes.count; ++i) EXPECT_NEAR(density(i), expected(i), 1e-15) << "step " << t;
  }
  ASSERT_EQ(in_place.fields.turned, 1);
  for (int i = 0; i < two.nodes.count; ++i)
    for (int q = 0; q < 9; ++q) EXPECT_NEAR(populations(in_place, i)[q], populations(two, i)[q], 1e-16);
}

TEST(FlowBirths, InTheMiddleOfTwoStepsInPlaceAreThoseOfTwoLattices) {
  const Lattice lattice(6, 5);
  const auto before = draw(lattice, {"......", ".##...", ".##...", "......", "...#.."});
  const auto after = draw(lattice, {"......", "......", ".#....", "......", "......"});
  Flow<double> in_place(lattice, before, {true, true}), two(lattice, before, {true, true});
  for (Flow<double>* flow : {&in_place, &two}) {
    flow->set([](int x, int y) { return Macroscopic<double>{0.01 * x, 0.01 * y, -0.02 * x}; });
    const auto sweep_thrice = [&] {
      for (int t = 0; t < 3; ++t) flow == &two ? sweep_two_lattices(two) : in_place.sweep();
    };
    sweep_thrice();
    const int old = flow->nodes.count;
    ASSERT_GT(append_births(flow->exec, after, flow->nodes), 0);
    fit_to_capacity(flow->exec, flow->nodes, D2Q9::Q, old, flow->fields.f, flow->fields.u);
    initialise_births(flow->exec, flow->nodes, old, flow->nodes.count, flow->fields);
    sweep_thrice();
  }
  for (int i = 0; i < two.nodes.count; ++i)
    for (int q = 0; q < 9; ++q) EXPECT_NEAR(populations(in_place, i)[q], populations(two, i)[q], 1e-16);
}

}  // namespace
}  // namespace vug
