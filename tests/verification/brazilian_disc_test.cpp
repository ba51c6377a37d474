// The Brazilian test: a disc that is split between two flats, against the closed form of the elastic disc.
#include "dem/mean_stress.hpp"
#include "dem/splitting.hpp"
#include "support/specimens.hpp"

#include <gtest/gtest.h>

namespace {

using namespace vug;
using namespace vug::test;

/// Particles whose centroids lie within `radius` of a point.
std::vector<int> around(const Particles& p, double x, double y, double radius) {
  const auto x0 = host_copy(p.x0);
  std::vector<int> inside;
  for (int i = 0; i < p.count; ++i)
    if (std::hypot(x0(i, 0) - x, x0(i, 1) - y) < radius) inside.push_back(i);
  return inside;
}

constexpr double diameter = 0.05, flat_width_of_20_degrees = 0.174;

constexpr double averaged = 0.08;  // of the diameter: radius of the circle whose mean stress is that of the centre

/// Stress around the centre of an elastic disc over that which its press calls the splitting stress.
Stress centre_over_splitting(double flats) {
  const Assembly disc = generate_disc(diameter, flats, elements(1.25e-3));
  PlatenTest test;
  test.specimen = Specimen::disc;
  test.speed = 0.1;
  test.largest_strain = 4e-4;
  MechanicsParameters parameters = unbreakable();
  parameters.local_damping = 0.1;
  Stress centre;
  load_between_platens(Exec(), disc, parameters, test, [&](const Mechanics& rock, const PlatenResult& r, bool last) {
    if (!last) return;
    EXPECT_NEAR(flat_width(disc, rock.boundary()), flats, 1e-9);
    const double y = 0.5 * diameter * std::sqrt(1 - flats * flats);
    centre =
        mean_stress(rock.particles(), rock.bonds(), around(rock.particles(), 0.5 * diameter, y, averaged * diameter));
    centre = {centre.xx / r.stress.back(), centre.xy / r.stress.back(), centre.yy / r.stress.back()};
  });
  return centre;
}

/// A pressure p on two arcs of 2a (Hondros 1959), F = p D sin a: across the load (2 p/pi)(sin 2a - a), along it -(2
/// p/pi) (sin 2a + a). The mean over a circle is less: it falls as ((1 - s)/(1 + s))^2, s = (2 x/D)^2, off the axis of
/// the load, and not along it. Rigid platens press more at the ends of their flats than in the middle, which wide flats
/// show.
TEST(BrazilianDisc, HasTheElasticStressOfTheClosedFormAtItsCentre) {
  for (const auto& [flats, tolerance] : {std::pair{0.0872, 0.02}, {flat_width_of_20_degrees, 0.06}, {0.3, 0.1}}) {
    const Stress centre = centre_over_splitting(flats);
    const double a = std::asin(flats), along = (std::sin(2 * a) + a) / (std::sin(2 * a) - a);
    const double across = centre.xx / (1 - std::pow(2 * averaged, 2));
    record("brazilian_centre",
           {{"flats", flats}, {"across", across}, {"along", centre.yy}, {"along_exact", -along}, {"shear", centre.xy}});
    EXPECT_NEAR(across, 1, tolerance) << flats;
    EXPECT_NEAR(centre.yy, -along, std::max(0.05, tolerance) * along) << flats;
    EXPECT_NEAR(centre.xy, 0, 0.05) << flats;
  }
}

/// Of pairs of opposite radial forces dF at angles from the load, each of which pulls by 2 dF/(pi D) at right angles to
/// itself and presses by 6 dF/(pi D) along itself: across the load 2 dF/(pi D) (cos^2 - 3 sin^2), along it dF cos of
/// force.
TEST(BrazilianDisc, SplitsByTheShareOfForcesAllOverItsArcs) {
  EXPECT_EQ(splitting_share(0), 1);
  for (const double half : {1e-3, 0.1, 0.175, 0.3, 0.6}) {
    double tension = 0, force = 0;
    const int parts = 2000;
    for (int k = 0; k < parts; ++k) {
      const double angle = half * ((k + 0.5) / parts);
      tension += std::pow(std::cos(angle), 2) - 3 * std::pow(std::sin(angle), 2);
      force += std::cos(angle);
    }
    EXPECT_NEAR(splitting_share(half), tension / force, 1e-6) << half;
  }
  EXPECT_NEAR(splitting_share(10 * std::acos(-1.0) / 180), 0.964, 1e-3);  // Wang et al. 2004
}

TEST(BrazilianDisc, BreaksFirstAlongTheLoadedDiameterAndSplits) {
  const Assembly disc = generate_disc(diameter, flat_width_of_20_degrees, elements(1.5e-3));
  PlatenTest test;
  test.specimen = Specimen::disc;
  test.speed = 0.1;
  const double y = 0.5 * diameter * std::sqrt(1 - flat_width_of_20_degrees * flat_width_of_20_degrees);
  double first_x = 0, first_y = 0, first_count = 0, first_strain = 0;
  const PlatenResult r = load_between_platens(
      Exec(), disc, rock_of(95e6), test, [&](const Mechanics& rock, const PlatenResult& so_far, bool last) {
        if (last) record_cracks("brazilian_cracks", disc, rock.bonds());
        if (first_count >= 10) return;  // the first crack: ten failed bonds
        const auto state = host_copy(rock.bonds().state);
        const auto pair = host_copy(rock.bonds().pair);
        const auto x0 = host_copy(rock.particles().x0);
        first_x = first_y = first_count = 0;
        for (int k = 0; k < rock.bonds().count; ++k) {
          if (!has_failed(state(k))) continue;
          first_x += std::abs(0.5 * (x0(pair(k, 0), 0) + x0(pair(k, 1), 0)) - 0.5 * diameter);
          first_y += std::abs(0.5 * (x0(pair(k, 0), 1) + x0(pair(k, 1), 1)) - y);
          first_count += 1;
        }
        first_strain = so_far.strain.back();
      });
  record_curve("brazilian_curve", 95e6, r);
  record("brazilian_strength", {{"strength", r.strength},
                                {"first_off_axis", first_x / first_count / (0.5 * diameter)},
                                {"first_off_centre", first_y / first_count / (0.5 * diameter)},
                                {"first_strain", first_strain},
                                {"peak_strain", r.peak_strain}});
  EXPECT_GT(r.bonds_at_end.failed_in_tension, 5 * r.bonds_at_end.failed_in_shear);
  // failures at random over the disc would lie 0.42 of the radius off the axis in the mean
  EXPECT_LT(first_x / first_count, 0.2 * 0.5 * diameter);
  EXPECT_LT(first_y / first_count, 0.6 * 0.5 * diameter);
  EXPECT_GT(r.strength, 5e6);
  EXPECT_LT(r.strength, 15e6);  // mean strength of the bonds
}

/// With the fracture energies those of the bonds, on which the share of 0.70 was measured, and those of the rock.
TEST(BrazilianDiscLong, TensileStrengthsStandBesideTheCompressiveOne) {
  for (const double path_ratio : {1.0, generated_path_ratio})
    for (const double cohesion : {95e6, calibrated_cohesion}) {
      std::vector<double> direct, splitting;
      for (std::uint64_t seed = 1; seed <= 5; ++seed) {
        const MechanicsParameters rock = rock_of(cohesion, seed, path_ratio);
        PlatenTest pull;
        pull.speed = -0.1;
        direct.push_back(load_between_platens(Exec(), specimen(3e-3, seed), rock, pull).strength);
        PlatenTest split;
        split.specimen = Specimen::disc;
        split.speed = 0.1;
        const Assembly disc = generate_disc(diameter, flat_width_of_20_degrees, elements(2e-3, seed));
        splitting.push_back(load_between_platens(Exec(), disc, rock, split).strength);
      }
      const Spread t = spread_of(direct), b = spread_of(splitting);
      record("tensile_strengths", {{"path_ratio", path_ratio},
                                   {"cohesion", cohesion},
                                   {"direct", t.mean},
                                   {"direct_deviation", t.deviation},
                                   {"brazilian", b.mean},
                                   {"brazilian_deviation", b.deviation}});
      if (path_ratio == 1) {
        EXPECT_NEAR(t.mean, 10.5e6, 0.1 * 10.5e6);  // 0.70 of the bonds' mean strength of 15 MPa
      }
      EXPECT_GT(b.mean, 0.7 * t.mean);
      EXPECT_LT(b.mean, 1.5 * t.mean);
    }
}

}  // namespace
