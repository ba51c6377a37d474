// What the rock shows of itself in pictures.
#include "coupling/rock_fields.hpp"

#include "dem_support.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

namespace {

using namespace vug;
using vug::test::host_copy;

std::vector<double> read(const Mechanics& rock, const std::string& name) {
  FieldList list;
  add_rock_fields(rock, list, {"mass"});
  for (const Field& field : list.particles) {
    if (field.name != name) continue;
    std::vector<double> values(static_cast<std::size_t>(field.components * rock.particles().count));
    field.read(values);
    return values;
  }
  ADD_FAILURE() << "no field " << name;
  return {};
}

TEST(RockFields, CountMotionFromTheEndOfThePreload) {
  Loads loads;
  loads.support[static_cast<std::size_t>(RockSide::left)] = Support::roller;
  loads.support[static_cast<std::size_t>(RockSide::bottom)] = Support::roller;
  loads.traction[static_cast<std::size_t>(RockSide::right)] = {-5e6, 0};
  Mechanics rock(test::block(0.01, 0.01, 2e-3, 0.2), {}, loads);
  rock.preload(Exec(), 2e-5);
  const auto u = host_copy(rock.particles().u);
  const auto angle = host_copy(rock.particles().angle);
  const int i = 7;
  const double x = u(i, 0), y = u(i, 1), turn = angle(i);
  ASSERT_GT(std::abs(x) + std::abs(y), 1e-8) << "the preload moves it";
  for (const double value : read(rock, "displacement")) EXPECT_EQ(value, 0);
  for (const double value : read(rock, "rotation")) EXPECT_EQ(value, 0);
  test::place(rock.particles(), i, x + 3e-6, y - 2e-6, turn + 1e-4);
  const auto moved = read(rock, "displacement");
  EXPECT_NEAR(moved[2 * i], 3e-6, 1e-18);
  EXPECT_NEAR(moved[2 * i + 1], -2e-6, 1e-18);
  EXPECT_NEAR(read(rock, "rotation")[i], 1e-4, 1e-16);
}

TEST(RockFields, TellWhichTrianglesAreGone) {
  Mechanics rock(test::pair_of_triangles(2e-3), {}, {});
  EXPECT_EQ(read(rock, "gone"), (std::vector<double>{0, 0}));
  const auto fraction = host_copy(rock.particles().solid_fraction);
  fraction(0) = 0.051, fraction(1) = 0.049;
  Kokkos::deep_copy(rock.particles().solid_fraction, fraction);
  EXPECT_EQ(read(rock, "gone"), (std::vector<double>{0, 1}));
}

/// A triangle moves with the mass that is left of it, but at least a fifth (docs/model.md).
TEST(RockFields, GiveTheMassOnRequest) {
  MechanicsParameters parameters;
  parameters.density = 2000;
  Mechanics rock(test::pair_of_triangles(2e-3), parameters, {});
  const double whole = 2000 * std::sqrt(3.0) / 4 * 4e-6;  // of an equilateral triangle, per m
  for (const auto& [left, share] : {std::pair{1.0, 1.0}, {0.5, 0.5}, {0.1, 0.2}, {0.01, 0.0}}) {
    const auto fraction = host_copy(rock.particles().solid_fraction);
    fraction(0) = left;
    Kokkos::deep_copy(rock.particles().solid_fraction, fraction);
    EXPECT_NEAR(read(rock, "mass")[0], share * whole, 1e-12 * whole) << left;
  }
  FieldList unasked;
  add_rock_fields(rock, unasked);
  for (const Field& field : unasked.particles) EXPECT_NE(field.name, "mass");
}

}  // namespace
