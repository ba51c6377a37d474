// A cavity that acid has eaten bears the stress of one that was cut.
#include "dem/mean_stress.hpp"
#include "support/dissolving_rock.hpp"
#include "support/record.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>
#include <vector>

namespace {

using namespace vug;
using vug::test::dissolve;
using vug::test::elastic;
using vug::test::host_copy;

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

  /// (particle) where it lies.
  std::vector<Vec2> from_centre(const Particles& p) const {
    const auto x0 = host_copy(p.x0);
    std::vector<Vec2> from;
    for (int i = 0; i < p.count; ++i) from.push_back(Vec2{x0(i, 0), x0(i, 1)} - centre);
    return from;
  }

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
    const auto from = from_centre(p);
    for (int i = 0; i < p.count; ++i) {
      const Vec2 x = from[i];
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
    const auto from = from_centre(p);
    for (int i = 0; i < p.count; ++i) {
      const Vec2 x = from[i];
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

}  // namespace
