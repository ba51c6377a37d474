// What the rock shows of itself in pictures.
#include "coupling/rock_fields.hpp"

#include "dem/gauges.hpp"
#include "dem/out_of_place.hpp"
#include "dem_support.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <utility>
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

/// What output counts from is nothing that the rock feels: of the same motion the same triangles are out of place.
TEST(RockFields, CountMotionFromTheUnloadedRockOnRequest) {
  Loads loads;
  loads.support[static_cast<std::size_t>(RockSide::left)] = Support::roller;
  loads.support[static_cast<std::size_t>(RockSide::bottom)] = Support::roller;
  loads.traction[static_cast<std::size_t>(RockSide::right)] = {-5e6, 0};
  MechanicsParameters soft;  // a preload of a tenth of a millimetre
  soft.bond.normal_modulus = 4e8;
  soft.bond.tangential_modulus = 2e8;
  for (const bool from_unloaded : {true, false}) {
    soft.output_from_unloaded = from_unloaded;
    Mechanics rock(test::block(0.01, 0.01, 2e-3, 0.2), soft, loads);
    ASSERT_TRUE(rock.preload_statically(Exec()));
    const Particles& p = rock.particles();
    const auto x0 = host_copy(p.x0), u = host_copy(p.u);
    const auto angle = host_copy(p.angle);
    int i = 0;  // near the pressed side
    for (int t = 1; t < p.count; ++t)
      if (x0(t, 0) > x0(i, 0)) i = t;
    ASSERT_LT(u(i, 0), -5e-5);
    const double half = 0.5 * std::sqrt(host_copy(p.mass)(i) / soft.density);
    EXPECT_EQ(read(rock, "displacement")[2 * i], from_unloaded ? u(i, 0) : 0);
    EXPECT_EQ(read(rock, "rotation")[i], from_unloaded ? angle(i) : 0);
    EXPECT_EQ(displacement_of(Exec(), p, 0, {i, {}}).x, from_unloaded ? u(i, 0) : 0);
    EXPECT_EQ(count_out_of_place(Exec(), p), 0);
    for (const auto& [moved, out] : {std::pair{-0.99, 0}, {-1.01, 1}, {0.99, 0}, {1.01, 1}}) {
      test::place(p, i, u(i, 0) + moved * half, u(i, 1), angle(i));
      EXPECT_EQ(count_out_of_place(Exec(), p), out) << moved;
    }
  }
}

TEST(RockFields, OfRockThatHasLeftItsPlaceInThePreloadSaySo) {
  Mechanics rock(test::pair_of_triangles(2e-3), {}, {});
  const double half = 0.5 * std::sqrt(std::sqrt(3.0) / 4 * 4e-6);
  for (const auto& [moved, out] : {std::pair{0.99, 0}, {1.01, 1}}) {
    test::place(rock.particles(), 0, moved * half, 0, 0);
    Kokkos::deep_copy(rock.particles().u_reference, rock.particles().u);
    EXPECT_EQ(count_out_of_place(Exec(), rock.particles()), out) << moved;
  }
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
