// Rock that dissolves: what is left carries, what is gone carries nothing and weighs nothing.
#include "support/dissolving_rock.hpp"
#include "support/record.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace {

using namespace vug;
using vug::test::dissolve;
using vug::test::elastic;
using vug::test::host_copy;

TEST(ChemicalDamage, OfEqualSidesIsTheShareOfTheSolidThatIsGone) {
  for (const double left : {1.0, 0.7, 0.3, 0.1})
    for (const double volume : {0.2, 1.0, 5.0})
      EXPECT_NEAR(chemical_damage_of_sides(volume, left, 1, left), 1 - left, 1e-15);
  EXPECT_EQ(chemical_damage_of_sides(1, 1, 2, 1), 0);
  // to first order in the loss it is Eq. 25, whichever side has lost it
  EXPECT_NEAR(chemical_damage_of_sides(1, 1 - 1e-6, 3, 1 - 2e-6), (1e-6 + 3 * 2e-6) / 4, 1e-11);
  // springs in series: half the length of a tenth of the stiffness
  EXPECT_NEAR(1 - chemical_damage_of_sides(1, 0.1, 1, 1), 2 / (1 / 0.1 + 1), 1e-15);
}

TEST(ChemicalDamage, IsWholeAndContinuousWhenOneSideGoes) {
  EXPECT_EQ(chemical_damage_of_sides(1, 0, 1, 1), 1);
  EXPECT_EQ(chemical_damage_of_sides(1, 1, 5, 0), 1);
  EXPECT_EQ(chemical_damage_of_sides(0, 1, 0, 1), 0) << "no solid from the start";
  EXPECT_EQ(chemical_damage_of_sides(0, 0, 1, 1), 1) << "no solid beside that edge, and its triangle is gone";
  double before = 0;
  for (int k = 0; k <= 1000; ++k) {  // a triangle that keeps one of its three sectors longest
    const double solid = 1 - k / 1000.0;
    const double d_c = chemical_damage_of_sides(1, side_left(std::min(1.0, 3 * solid), solid), 1, 1);
    EXPECT_GE(d_c, before);
    EXPECT_LT(d_c - before, 0.02) << solid;
    if (is_gone(solid)) {
      EXPECT_EQ(d_c, 1);
    }
    before = d_c;
  }
}

/// A column between platens whose middle row of elements dissolves away.
struct Seam {
  static constexpr double l = 1e-3, width = 5e-3;
  static constexpr int rows = 7;
  double thickness = l * std::sqrt(3.0) / 2, height = rows * thickness;
  Assembly assembly = test::block(width, height, l, 0);

  Mechanics column(const MechanicsParameters& parameters) const {
    Loads loads;
    loads.support[static_cast<std::size_t>(RockSide::bottom)] = Support::roller;
    loads.support[static_cast<std::size_t>(RockSide::top)] = Support::roller;
    return {assembly, parameters, loads};
  }
  void dissolve_middle(Mechanics& rock, double dt, double left) const {
    dissolve(rock, dt, assembly, [&](Vec2 x) { return std::abs(x.y - 0.5 * height) < 0.499 * thickness ? left : 1.0; });
  }
};

TEST(DissolvedSeam, CarriesNothingUntilThePiecesOnBothSidesMeet) {
  const Seam seam;
  Mechanics rock = seam.column(elastic(0.7));
  const double dt = 0.3 * rock.critical_step(), speed = 20;
  rock.set_platen_velocity(RockSide::top, {0, -0.1});
  rock.advance(Exec(), dt, 500);
  rock.set_platen_velocity(RockSide::top, {0, 0});
  rock.advance(Exec(), dt, 500);
  const double squeezed = rock.reaction(RockSide::bottom).y;
  EXPECT_GT(squeezed, 0);
  for (const double left : {0.5, 0.2, 0.1, 0.06}) {
    seam.dissolve_middle(rock, dt, left);
    rock.advance(Exec(), dt, 500);
    EXPECT_LT(rock.reaction(RockSide::bottom).y, squeezed);
    EXPECT_GT(rock.reaction(RockSide::bottom).y, 0) << left;
  }
  seam.dissolve_middle(rock, dt, 0);
  rock.advance(Exec(), dt, 2000);
  EXPECT_NEAR(rock.reaction(RockSide::bottom).y, 0, 1e-6 * squeezed);
  rock.set_platen_velocity(RockSide::top, {0, -speed});
  double travelled = 0;
  while (travelled < 1.2 * seam.thickness && rock.reaction(RockSide::bottom).y < squeezed) {
    rock.advance(Exec(), dt, 1);
    travelled += speed * dt;
  }
  EXPECT_NEAR(travelled, seam.thickness, 0.03 * seam.thickness);
}

TEST(DissolvedSeam, IsAsWideAsTheOutlinesHaveShrunk) {
  const double l = 2e-3, speed = 20;
  for (const double left : {0.64, 0.25, 0.06}) {
    Mechanics rock(test::pair_of_triangles(l), elastic(0), {});
    const Particles& p = rock.particles();
    const auto v = host_copy(p.v);
    v(1, 0) = -speed;
    Kokkos::deep_copy(p.v, v);
    const ScalarField<double> solid("solid", 2), d_c("d_c", 1);
    const auto solid_host = Kokkos::create_mirror_view(solid);
    solid_host(0) = left, solid_host(1) = 1;
    Kokkos::deep_copy(solid, solid_host);
    Kokkos::deep_copy(d_c, 1.0);
    const double dt = 0.1 * rock.critical_step();
    rock.dissolve(Exec(), dt, solid, d_c);
    // the edge recedes towards the centroid, a third of the height away; the rounding stays
    const double gap = (1 - std::sqrt(left)) * (l * std::sqrt(3.0) / 6 - p.radius);
    double travelled = 0;
    while (travelled < l && host_copy(rock.contacts().push)(1, 0) == 0) {
      travelled = -host_copy(p.u)(1, 0);
      rock.advance(Exec(), dt, 1);
    }
    EXPECT_NEAR(travelled, gap, 2 * speed * dt) << left;
  }
}

/// What a reaction that runs back gives to a side of a bond does not mend it.
TEST(DissolvedRock, GivenBackLeavesTheDamageOfBonds) {
  Mechanics rock(test::pair_of_triangles(2e-3), elastic(0), {});
  const ScalarField<double> solid("solid", 2), d_c("d_c", 1);
  Kokkos::deep_copy(solid, 1.0);
  for (const auto& [given, kept] : {std::pair{0.3, 0.3}, {0.1, 0.3}, {0.4, 0.4}}) {
    Kokkos::deep_copy(d_c, given);
    rock.dissolve(Exec(), 0.1 * rock.critical_step(), solid, d_c);
    EXPECT_EQ(host_copy(rock.bonds().d_c)(0), kept);
  }
}

TEST(DissolvedRock, WeighsNothingAndStaysWhereItIs) {
  const Seam seam;
  Mechanics rock = seam.column(elastic(0));
  const Particles& p = rock.particles();
  Kokkos::deep_copy(p.v, 1.0);
  Kokkos::deep_copy(p.spin, 100.0);
  const double sound = rock.critical_step();
  seam.dissolve_middle(rock, 0.3 * sound, 0.04);
  EXPECT_GE(rock.critical_step(), 0.99 * sound) << "what is gone asks for no smaller step";
  const auto fraction = host_copy(p.solid_fraction);
  const auto force = host_copy(p.force);
  const int gone =
      static_cast<int>(std::find_if(fraction.data(), fraction.data() + p.count, is_gone) - fraction.data());
  ASSERT_LT(gone, p.count);
  force(gone, 0) = 1e6;
  Kokkos::deep_copy(p.force, force);
  const auto before = host_copy(p.u);
  const double x = before(gone, 0);
  rock.advance(Exec(), 0.3 * sound, 200);
  EXPECT_EQ(host_copy(p.u)(gone, 0), x);
  EXPECT_EQ(host_copy(p.spin)(gone), 0);
  EXPECT_EQ(rock.lost().triangles, std::count_if(fraction.data(), fraction.data() + p.count, is_gone));
}

/// A free block that rings while its middle dissolves and is gone half way.
struct RingingBlock {
  Assembly assembly = test::block(0.012, 0.012, 2e-3, 0.2);
  Mechanics rock;
  explicit RingingBlock(double fraction_of_step, double mass_scaling = 1, int times = 8)
      : rock(assembly, with_ledger(mass_scaling), {}) {
    const Particles& p = rock.particles();
    const auto v = host_copy(p.v), x0 = host_copy(p.x0);
    for (int i = 0; i < p.count; ++i) {
      v(i, 0) = 3 + 400 * (x0(i, 0) - 0.006);
      v(i, 1) = -300 * (x0(i, 1) - 0.004);
    }
    Kokkos::deep_copy(p.v, v);
    rock.reset_ledger(Exec());
    start = moment();
    const double dt = fraction_of_step * 4e-8;  // times do not depend on it
    for (int k = 1; k <= times; ++k) {
      dissolve(rock, dt, assembly, [&](Vec2 x) {
        const double r = std::hypot(x.x - 0.006, x.y - 0.006);
        return r < 0.002 ? 1 - static_cast<double>(k) / times : r < 0.004 ? 1 - 0.5 * k / times : 1.0;
      });
      rock.advance(Exec(), dt, static_cast<int>(std::lround(1.6e-6 / dt)));
    }
  }
  static MechanicsParameters with_ledger(double mass_scaling) {
    MechanicsParameters p = elastic(0);
    p.mass_scaling = mass_scaling;
    p.energy_ledger = true;
    return p;
  }
  Vec2 moment() const {
    const Particles& p = rock.particles();
    const auto v = host_copy(p.v);
    const auto mass = host_copy(p.mass), fraction = host_copy(p.solid_fraction);
    Vec2 sum;
    for (int i = 0; i < p.count; ++i)
      sum = sum + presence(fraction(i)) * mass_fraction(fraction(i)) * mass(i) * Vec2{v(i, 0), v(i, 1)};
    return sum;
  }
  Vec2 start;
};

TEST(DissolvedRock, TakesItsMomentumAlong) {
  const RingingBlock block(1);
  const LostWithRock lost = block.rock.lost();
  ASSERT_GT(lost.triangles, 3);
  const Vec2 now = block.moment(), scale = block.start;
  EXPECT_GT(std::abs(lost.momentum.x), 0.05 * std::abs(scale.x));
  EXPECT_NEAR(now.x + lost.momentum.x, scale.x, 1e-12 * std::abs(scale.x));
  EXPECT_NEAR(now.y + lost.momentum.y, scale.y, 1e-12 * std::abs(scale.x));
}

TEST(DissolvedRock, TakesItsEnergyAlongAndTheLedgerClosesToSecondOrder) {
  for (const double scaling : {1.0, 4.0}) {
    double before = 0;
    for (const double fraction : {1.0, 0.5, 0.25}) {
      const RingingBlock block(fraction, scaling);
      const Energies e = block.rock.energies(Exec());
      EXPECT_GT(e.dissolved, 0.1 * e.initial);
      const double error = std::abs(e.imbalance()) / e.initial;
      if (scaling == 1) test::record("dissolved_ledger", {{"fraction", fraction}, {"imbalance", error}});
      if (before > 0) {
        EXPECT_LT(error, before / 3) << scaling;  // a quarter
      }
      before = error;
    }
    EXPECT_LT(before, 1e-4) << scaling;
  }
}

}  // namespace
