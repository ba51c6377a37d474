// Heat at the sides of small lattices: what enters is booked, on any rows of them.
#include "base/require.hpp"
#include "support/heat_box.hpp"

#include <gtest/gtest.h>

#include <utility>

namespace vug {
namespace {

using test::HeatBox;
using test::velocity_sets;

TEST(HeatSides, BookWhatEnters) {
  const auto pillar = [](int x, int y) { return (x + y) % 3 == 0; };
  for (const ScalarVelocitySet set : velocity_sets) {
    HeatBox<double> box(8, 6, {0.05, 0.2, 3, set}, pillar, [](int x, int) { return 0.1 * x; });
    box.side(Side::left, HeatCondition::temperature, 1.5);
    box.side(Side::right, HeatCondition::outflow, 0);
    box.side(Side::top, HeatCondition::flux, 0.01);
    const double before = box.energy();
    box.run(200);
    EXPECT_NEAR(box.energy() - before, box.entered(), 1e-12);
    EXPECT_NEAR(sum_in_order(box.sides[2].energy_in), 200 * 8 * 0.01, 1e-13);
    EXPECT_EQ(sum_in_order(box.sides[3].energy_in), 0) << "adiabatic";
    EXPECT_GT(sum_in_order(box.sides[0].energy_in), 0.1);
  }
}

TEST(HeatSides, OfSomeRowsAreThoseOfAll) {
  const auto pillar = [](int x, int y) { return (x + y) % 3 == 0; };
  for (const ScalarVelocitySet set : velocity_sets) {
    HeatBox<double> box(9, 7, {0.05, 0.2, 3, set}, pillar, [](int x, int y) { return 0.1 * x + 0.03 * y * y; });
    box.side(Side::right, HeatCondition::outflow, 0);
    box.side(make_heat_side(Side::left, 1, 5, HeatCondition::temperature, 1.5));
    box.side(Side::top, HeatCondition::flux, 0.01);
    box.run(5);
    // populations after sides have been filled beside these rows, and what has entered at each of their nodes
    const auto fill = [&](int first, int rows) {
      HeatFields<double> fields = box.fields;
      fields.g = ScalarField<double>("g", box.fields.g.extent(0));
      Kokkos::deep_copy(fields.g, box.fields.g);
      fields.first_row = first;
      fields.rows = rows;
      std::vector<HeatSide> sides = box.sides;
      for (HeatSide& side : sides) side.energy_in = ScalarField<double>("entered", side.energy_in.extent(0));
      fill_heat_sides<double>(box.exec, fields, sides);
      std::vector<double> entered;
      for (const HeatSide& side : sides) {
        const auto host = test::host_copy(side.energy_in);
        entered.insert(entered.end(), host.data(), host.data() + host.extent(0));
      }
      return std::pair(test::host_copy(fields.g), entered);
    };
    const auto [all, entered] = fill(0, 7);
    const auto [below, entered_below] = fill(0, 3);
    const auto [above, entered_above] = fill(3, 4);
    const Lattice& lattice = box.lattice;
    for (int y = 0; y < lattice.ny; ++y)
      for (int x = 0; x < lattice.nx; ++x)
        for (int q = 1; q < box.directions(); ++q) {
          const int from_x = x - D2Q9::c(q, 0), from_y = y - D2Q9::c(q, 1);
          const int slot = q * lattice.size() + lattice.node(from_x, from_y);
          if (!lattice.inside(from_x, from_y)) {
            EXPECT_EQ(y < 3 ? below(slot) : above(slot), all(slot)) << x << ", " << y;
          }
        }
    for (std::size_t k = 0; k < entered.size(); ++k) {
      EXPECT_EQ(entered_below[k] + entered_above[k], entered[k]) << k;
      EXPECT_TRUE(entered_below[k] == 0 || entered_above[k] == 0) << k;
    }
  }
}

TEST(HeatSides, TakeAStretchWithAConditionOfItsOwn) {
  HeatBox<double> box(
      6, 9, {0.1, 0.1, 1}, [](int, int) { return true; }, [](int, int) { return 0.0; });
  box.side(make_heat_side(Side::left, 0, 2, HeatCondition::adiabatic));
  box.side(make_heat_side(Side::left, 3, 5, HeatCondition::flux, 0.5));
  box.side(make_heat_side(Side::left, 6, 8, HeatCondition::adiabatic));
  box.run(1);
  const std::vector<double> theta = box.theta();
  for (int y = 0; y < 9; ++y) EXPECT_NEAR(theta[y * 6], y >= 3 && y <= 5 ? 0.5 : 0.0, 1e-15) << y;
}

TEST(HeatSides, RefuseAnEmptyStretch) {
  EXPECT_THROW(make_heat_side(Side::left, 4, 3, HeatCondition::adiabatic, 0), InputError);
}

}  // namespace
}  // namespace vug
