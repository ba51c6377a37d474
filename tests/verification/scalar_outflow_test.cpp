// Heat and solutes at a side that they leave without gradient: where nothing flows it is insulated, whatever the
// relaxation time.
#include "../reference/reactive_box.hpp"
#include "support/heat_box.hpp"
#include "support/host_copy.hpp"
#include "support/record.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace vug {
namespace {

using reference::ReactiveBox;
using test::HeatBox;
using test::record;

constexpr int n = 40;          // cells
constexpr double Fo = 0.3;     // diffusion times of the slab
constexpr double most = 1e-3;  // taking over the inward population as it is leaves 1e-2 to 4e-2

/// A slab from 0, one face held at 1, nothing through the other: the series.
double insulated_slab(double x, double time) {
  double theta = 1;
  for (int term = 0; term < 40; ++term) {
    const double k = (term + 0.5) * std::numbers::pi;
    theta -= 2 / k * std::sin(k * x / n) * std::exp(-k * k * time);
  }
  return theta;
}

/// A slab of one matter between a face at 1 and an outflow, against the series.
void expect_insulated(bool rock, double D, ScalarVelocitySet set, Side side) {
  const bool upright = side == Side::right;
  HeatBox<double> box(
      upright ? n : 3, upright ? 3 : n, {D, D, 2, set}, [&](int, int) { return rock; }, [](int, int) { return 0.0; },
      {!upright, upright});
  box.side(upright ? Side::left : Side::bottom, HeatCondition::temperature, 1);
  box.side(side, HeatCondition::outflow, 0);
  const int steps = static_cast<int>(std::lround(Fo * n * n / D));
  box.run(steps);
  const std::vector<double> theta = box.theta();
  double off = 0;
  for (int i = 0; i < n; ++i)
    off = std::max(off, std::abs(theta[upright ? i : 3 * i] - insulated_slab(i + 0.5, steps * D / (n * n))));
  record("outflow_insulated", {{"matter", rock ? "rock" : "fluid"},
                               {"D", D},
                               {"directions", set == ScalarVelocitySet::d2q5 ? 5 : 9},
                               {"off", off}});
  EXPECT_LT(off, most) << (rock ? "rock" : "fluid") << ", D " << D << ' ' << test::name_of(set);
}

TEST(ScalarOutflow, ConductsNothing) {
  for (const ScalarVelocitySet set : test::velocity_sets)
    for (const Side side : {Side::right, Side::top})
      for (const double D : {0.02, 1.0 / 6, 0.8}) {
        expect_insulated(true, D, set, side);
        expect_insulated(false, D, set, side);
      }
}

TEST(ScalarOutflow, LetsNothingDiffuseOut) {
  for (const double D : {0.01, 1.0 / 6, 0.8}) {
    ReactiveBox<D2Q5, double> box(n, 3, [](int, int) { return false; }, solute_parameters(D), 0, {false, true});
    box.give_concentration(Side::left, [](int) { return 1.0; });
    const BoundaryLinks out = find_boundary_links(box.exec, box.nodes, Side::right, 0, 2, D2Q5::Q);
    const ScalarField<double> gain("gain", out.count);
    const int steps = static_cast<int>(std::lround(Fo * n * n / D));
    for (int s = 0; s < steps; ++s) {
      dress_outflow<D2Q5>(box.exec, box.nodes, out, box.parameters, box.acid, gain);
      box.step();
    }
    const auto C = test::host_copy(box.acid.C);
    const auto node = test::host_copy(box.nodes.node);
    double off = 0;
    for (int i = 0; i < box.nodes.count; ++i)
      off = std::max(off, std::abs(C(i) - insulated_slab(box.lattice.x(node(i)) + 0.5, steps * D / (n * n))));
    record("solute_outflow_insulated", {{"D", D}, {"off", off}});
    EXPECT_LT(off, most) << "D " << D;
  }
}

/// A wave that is uniform neither along the side nor across it, nothing where x = 0 and insulated where x = n.
constexpr int across = 24;
double wave(int x, int y) {
  return std::sin(0.5 * std::numbers::pi * (x + 0.5) / n) * std::cos(2 * std::numbers::pi * (y + 0.5) / across);
}
/// How far a field, a function of (x, y), is from the wave with the amplitude that it has in the middle, over that.
template <class Field>
double off_wave(const Field& field) {
  constexpr int x0 = n / 2, y0 = 0;
  const double amplitude = field(x0, y0) / wave(x0, y0);
  double off = 0;
  for (int y = 0; y < across; ++y)
    for (int x = 0; x < n; ++x) off = std::max(off, std::abs(field(x, y) / amplitude - wave(x, y)));
  return off;
}

/// What flows along the side is not what is taken back. Looked at beside the wave in the middle, which knows nothing of
/// the side yet. In fluid D2Q9 loses what its diagonals conduct along the side in the nodes beside it (docs/model.md).
TEST(ScalarOutflow, LeavesConductionAlongTheSide) {
  for (const ScalarVelocitySet set : test::velocity_sets)
    for (const bool rock : {false, true})
      for (const double D : {0.02, 1.0 / 6, 0.8}) {
        HeatBox<double> box(n, across, {D, D, 2, set}, [&](int, int) { return rock; }, wave, {false, true});
        box.side(Side::left, HeatCondition::temperature, 0);
        box.side(Side::right, HeatCondition::outflow, 0);
        const int steps = static_cast<int>(std::lround(14 / D));
        box.run(steps);
        const std::vector<double> theta = box.theta();
        const double off = off_wave([&](int x, int y) { return theta[y * n + x]; });
        record("outflow_wave", {{"matter", rock ? "rock" : "fluid"},
                                {"D", D},
                                {"directions", set == ScalarVelocitySet::d2q5 ? 5 : 9},
                                {"off", off}});
        EXPECT_LT(off, set == ScalarVelocitySet::d2q9 && !rock ? 0.055 : most)
            << (rock ? "rock" : "fluid") << ", D " << D << ' ' << test::name_of(set);
      }
}

/// In rock, where nothing flows, an outflow is an insulated side at any diffusivity.
TEST(ScalarOutflow, OfRockIsAnInsulatedSide) {
  for (const ScalarVelocitySet set : test::velocity_sets)
    for (const double D : {0.02, 2.0, 1e3}) {
      const auto after = [&](HeatCondition condition) {
        HeatBox<double> box(
            n, across, {0.1, D, 2, set}, [](int, int) { return true; }, wave);
        box.side(Side::right, condition, 0);
        box.run(50);
        return box.theta();
      };
      EXPECT_EQ(after(HeatCondition::outflow), after(HeatCondition::adiabatic)) << "D " << D << test::name_of(set);
    }
}

void expect_wave_of_solute(double D) {
  using Set = D2Q5;
  ReactiveBox<Set, double> box(n, across, [](int, int) { return false; }, solute_parameters(D), 0, {false, true});
  const auto node = test::host_copy(box.nodes.node);
  const auto h = Kokkos::create_mirror_view(box.acid.h);
  const auto C = Kokkos::create_mirror_view(box.acid.C);
  for (int i = 0; i < box.nodes.count; ++i) {
    C(i) = wave(box.lattice.x(node(i)), box.lattice.y(node(i)));
    for (int q = 0; q < Set::Q; ++q) h(q * box.nodes.capacity + i) = Set::w(q) * C(i);
  }
  Kokkos::deep_copy(box.acid.h, h);
  Kokkos::deep_copy(box.acid.C, C);
  box.give_concentration(Side::left, [](int) { return 0.0; });
  const BoundaryLinks out = find_boundary_links(box.exec, box.nodes, Side::right, 0, across - 1, Set::Q);
  const ScalarField<double> gain("gain", out.count);
  const int steps = static_cast<int>(std::lround(14 / D));
  for (int s = 0; s < steps; ++s) {
    dress_outflow<Set>(box.exec, box.nodes, out, box.parameters, box.acid, gain);
    box.step();
  }
  const auto found = test::host_copy(box.acid.C);
  const auto index = test::host_copy(box.nodes.index);
  const double off = off_wave([&](int x, int y) { return found(index(box.lattice.node(x, y))); });
  record("solute_outflow_wave", {{"D", D}, {"off", off}});
  EXPECT_LT(off, most) << "D " << D;
}

TEST(ScalarOutflow, OfSolutesLeavesDiffusionAlongTheSide) {
  for (const double D : {0.02, 1.0 / 6, 0.8}) expect_wave_of_solute(D);
}

}  // namespace
}  // namespace vug
