// Rock that dissolves: what is left carries, what is gone carries nothing and weighs nothing.
#include "dem/mean_stress.hpp"
#include "dem_support.hpp"
#include "support/record.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <numbers>

namespace {

using namespace vug;
using vug::test::host_copy;

MechanicsParameters elastic(double local_damping) {
  MechanicsParameters p;
  p.bond.normal_strength = p.bond.cohesion = 1e15;
  p.bond.damping = 0;
  p.local_damping = local_damping;
  return p;
}

/// How much of a piece of rock is left: 1 all, 0 nothing.
using Left = std::function<double(Vec2)>;

/// Mean of `left` over a triangle, by the centroids of 25 equal parts.
double mean_left(const Triangle& t, const Left& left) {
  constexpr int n = 5;
  double sum = 0;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n - i; ++j)
      for (const int up : {1, 2}) {
        if (up == 2 && j == n - i - 1) continue;
        const double a = (i + up / 3.0) / n, b = (j + up / 3.0) / n;
        sum += left((1 - a - b) * t.corner[0] + a * t.corner[1] + b * t.corner[2]);
      }
  return sum / (n * n);
}

/// Dissolves rock as the lattice does, by the sectors between centroid and edge.
void dissolve(Mechanics& rock, double dt, const Assembly& assembly, const Left& left) {
  const Particles& particles = rock.particles();
  const Bonds& bonds = rock.bonds();
  const ScalarField<double> solid("solid", particles.count), d_c("d_c", bonds.count);
  const auto solid_host = Kokkos::create_mirror_view(solid), d_c_host = Kokkos::create_mirror_view(d_c);
  const auto point = [&](int v) { return Vec2{assembly.vertices[v][0], assembly.vertices[v][1]}; };
  for (int i = 0; i < particles.count; ++i) solid_host(i) = mean_left(triangle_of(assembly, i), left);
  const auto pair = host_copy(bonds.pair), vertex = host_copy(bonds.vertex);
  for (int k = 0; k < bonds.count; ++k) {
    double volume[2], share[2];
    for (int end = 0; end < 2; ++end) {
      const Triangle sector{{point(vertex(k, 0)), point(vertex(k, 1)), triangle_of(assembly, pair(k, end)).centroid()}};
      volume[end] = std::abs(sector.area());
      share[end] = side_left(mean_left(sector, left), solid_host(pair(k, end)));
    }
    d_c_host(k) = chemical_damage_of_sides(volume[0], share[0], volume[1], share[1]);
  }
  Kokkos::deep_copy(solid, solid_host);
  Kokkos::deep_copy(d_c, d_c_host);
  rock.dissolve(Exec(), dt, solid, d_c);
}

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

/// Stress round a hole of radius a in an infinite plate under s_x and s_y (Kirsch 1898), tension positive.
struct Kirsch {
  double a, s_x, s_y;
  struct Polar {
    double radial, hoop, shear;
  };
  Polar at(Vec2 from_centre) const {
    const double q = a * a / dot(from_centre, from_centre), angle = 2 * std::atan2(from_centre.y, from_centre.x);
    const double mean = 0.5 * (s_x + s_y), half = 0.5 * (s_x - s_y);
    return {mean * (1 - q) + half * (1 - 4 * q + 3 * q * q) * std::cos(angle),
            mean * (1 + q) - half * (1 + 3 * q * q) * std::cos(angle),
            -half * (1 + 2 * q - 3 * q * q) * std::sin(angle)};
  }
  /// Force per area on a surface with normal n.
  Vec2 traction(Vec2 from_centre, Vec2 n) const {
    const Vec2 r = (1 / norm(from_centre)) * from_centre, t{-r.y, r.x};
    const Polar s = at(from_centre);
    return (s.radial * dot(r, n) + s.shear * dot(t, n)) * r + (s.shear * dot(r, n) + s.hoop * dot(t, n)) * t;
  }
};

/// A square plate under the tractions that an infinite one would put on it.
struct Plate {
  static constexpr double a = 0.01, size = 0.06;
  Kirsch kirsch{a, -5e6, -7.5e6};
  Vec2 centre{0.5 * size, 0.5 * size};

  Vec2 from_centre(const Particles& p, int i) const { return Vec2{p.x0(i, 0), p.x0(i, 1)} - centre; }

  void load(Mechanics& rock, const Assembly& assembly) const {
    const auto force = host_copy(rock.particles().force);
    Vec2 sum;
    double edges = 0;
    const Vec2 normal[4] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
    for (const bool balance : {false, true})
      for (const BoundaryEdge& edge : rock.boundary()) {
        if (edge.side < 0) continue;
        const auto &p = assembly.vertices[edge.vertex[0]], &q = assembly.vertices[edge.vertex[1]];
        const double length = norm({q[0] - p[0], q[1] - p[1]});
        const Vec2 middle = Vec2{0.5 * (p[0] + q[0]), 0.5 * (p[1] + q[1])} - centre;
        const Vec2 f = balance ? (-1 / edges) * sum : length * kirsch.traction(middle, normal[edge.side]);
        force(edge.particle, 0) += f.x;
        force(edge.particle, 1) += f.y;
        if (balance) continue;
        sum = sum + f;
        edges += 1;
      }
    Kokkos::deep_copy(rock.particles().force, force);
  }

  /// Strained as the plate would be without a hole (modulus and Poisson's ratio of the laboratory).
  void strain(const Mechanics& rock) const {
    const double modulus = 27.8e9, poisson = 0.237;
    const Particles& p = rock.particles();
    const auto u = host_copy(p.u);
    for (int i = 0; i < p.count; ++i) {
      const Vec2 x = from_centre(p, i);
      u(i, 0) = (kirsch.s_x - poisson * kirsch.s_y) / modulus * x.x;
      u(i, 1) = (kirsch.s_y - poisson * kirsch.s_x) / modulus * x.y;
    }
    Kokkos::deep_copy(p.u, u);
  }

  /// Until it is at rest.
  static void settle(Mechanics& rock, double dt) {
    const double largest = 3e-5;
    double kinetic = 1;
    for (int looks = 0; kinetic > largest && looks < 100; ++looks) {
      rock.advance(Exec(), dt, 100);
      const Energies e = rock.energies(Exec());
      kinetic = e.kinetic / e.elastic;
    }
    EXPECT_LE(kinetic, largest);
  }

  /// Hoop stress over that of Kirsch, means over rings of elements and thirds of a quadrant.
  std::vector<double> hoop(const Mechanics& rock) const {
    constexpr int rings = 3, thirds = 3;
    const double radius[rings + 1] = {1.3 * a, 1.6 * a, 2 * a, 2.5 * a};
    std::vector<double> sum(rings * thirds), exact(rings * thirds);
    const Particles& p = rock.particles();
    const auto mass = host_copy(p.mass);
    for (int i = 0; i < p.count; ++i) {
      const Vec2 x = from_centre(p, i);
      const int ring = static_cast<int>(std::upper_bound(radius, radius + rings + 1, norm(x)) - radius) - 1;
      if (ring < 0 || ring >= rings) continue;
      const double angle = std::atan2(std::abs(x.y), std::abs(x.x));
      const int bin = ring * thirds + std::min(thirds - 1, static_cast<int>(angle / (std::numbers::pi / 2) * thirds));
      const Stress s = mean_stress(p, rock.bonds(), {i});
      const Vec2 t = (1 / norm(x)) * Vec2{-x.y, x.x};
      sum[bin] += mass(i) * (s.xx * t.x * t.x + 2 * s.xy * t.x * t.y + s.yy * t.y * t.y);
      exact[bin] += mass(i) * kirsch.at(x).hoop;
    }
    for (std::size_t k = 0; k < sum.size(); ++k) sum[k] /= exact[k];
    return sum;
  }
};

TEST(DissolvedCavity, BearsTheStressOfKirschAndThatOfAHoleThatWasCut) {
  const Plate plate;
  const Assembly whole = test::block(Plate::size, Plate::size, 1.5e-3, 0.2);
  Assembly cut = whole;
  std::erase_if(cut.triangles, [&](const auto& triangle) {
    Vec2 c;
    for (const int v : triangle) c = c + (1 / 3.0) * Vec2{whole.vertices[v][0], whole.vertices[v][1]};
    return norm(c - plate.centre) < Plate::a;
  });
  std::vector<double> dissolved, control;
  {
    Mechanics rock(whole, elastic(0.7), {});
    plate.load(rock, whole);
    plate.strain(rock);
    const double dt = 0.5 * rock.critical_step();
    for (int k = 1; k <= 20; ++k) {  // acid eats from the middle outwards
      const double radius = Plate::a * k / 20;
      dissolve(rock, dt, whole, [&](Vec2 x) { return norm(x - plate.centre) < radius ? 0.0 : 1.0; });
      rock.advance(Exec(), dt, 50);
    }
    Plate::settle(rock, dt);
    EXPECT_GT(rock.critical_step(), 0.7 * dt / 0.5);
    dissolved = plate.hoop(rock);
    // nothing is left in the cavity that carries
    const auto stress = host_copy(rock.bonds().stress);
    const auto pair = host_copy(rock.bonds().pair);
    const auto fraction = host_copy(rock.particles().solid_fraction);
    const auto push = host_copy(rock.contacts().push);
    int gone = 0;
    for (int k = 0; k < rock.bonds().count; ++k) {
      if (!is_gone(fraction(pair(k, 0))) && !is_gone(fraction(pair(k, 1)))) continue;
      ++gone;
      EXPECT_EQ(stress(k, 0), 0);
      EXPECT_EQ(stress(k, 1), 0);
    }
    EXPECT_GT(gone, 100);
    for (int i = 0; i < rock.particles().count; ++i) EXPECT_EQ(push(i, 0), 0) << i;
  }
  {
    Mechanics rock(cut, elastic(0.7), {});
    plate.load(rock, cut);
    plate.strain(rock);
    Plate::settle(rock, 0.5 * rock.critical_step());
    control = plate.hoop(rock);
  }
  for (std::size_t k = 0; k < control.size(); ++k) {
    test::record("dissolved_cavity", {{"ring", static_cast<int>(k / 3)},
                                      {"third", static_cast<int>(k % 3)},
                                      {"dissolved", dissolved[k]},
                                      {"cut", control[k]}});
    EXPECT_NEAR(dissolved[k], 1, 0.05) << k;
    EXPECT_NEAR(control[k], 1, 0.05) << k;
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
  explicit RingingBlock(double fraction_of_step, int times = 8) : rock(assembly, with_ledger(), {}) {
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
  static MechanicsParameters with_ledger() {
    MechanicsParameters p = elastic(0);
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
  double before = 0;
  for (const double fraction : {1.0, 0.5, 0.25}) {
    const RingingBlock block(fraction);
    const Energies e = block.rock.energies(Exec());
    EXPECT_GT(e.dissolved, 0.1 * e.initial);
    const double error = std::abs(e.imbalance()) / e.initial;
    test::record("dissolved_ledger", {{"fraction", fraction}, {"imbalance", error}});
    if (before > 0) {
      EXPECT_LT(error, before / 3);  // a quarter
    }
    before = error;
  }
  EXPECT_LT(before, 1e-4);
}

}  // namespace
