// The Brazilian test: a disc that is split between two flats, against the closed form of the elastic disc.
#include "dem/mean_stress.hpp"
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

constexpr double diameter = 0.05, flat_width = 0.174;  // flats of 20 degrees of arc

TEST(BrazilianDisc, HasTheElasticStressOfTheClosedFormAtItsCentre) {
  // Point loads: 2 P / (pi D) across, -6 P / (pi D) along the load. Loads spread evenly over an arc of 2 alpha (Hondros
  // 1959): across 2 P / (pi D) (sin 2 alpha / alpha - 1): 0.990 of it for the narrow flats of alpha = 5 degrees
  constexpr double narrow = 0.0872;
  const Assembly disc = generate_disc(diameter, narrow, elements(1.25e-3));
  PlatenTest test;
  test.specimen = Specimen::disc;
  test.speed = 0.1;
  test.largest_strain = 4e-4;
  MechanicsParameters parameters = unbreakable();
  parameters.local_damping = 0.1;
  Stress centre;
  load_between_platens(Exec(), disc, parameters, test, [&](const Mechanics& rock, const PlatenResult& r, bool last) {
    if (!last) return;
    const double y = 0.5 * diameter * std::sqrt(1 - narrow * narrow);
    centre = mean_stress(rock.particles(), rock.bonds(), around(rock.particles(), 0.5 * diameter, y, 0.08 * diameter));
    centre = {centre.xx / r.stress.back(), centre.xy / r.stress.back(), centre.yy / r.stress.back()};
  });
  record("brazilian_centre", {{"across", centre.xx}, {"along", centre.yy}, {"shear", centre.xy}});
  EXPECT_NEAR(centre.xx, 1, 0.05);
  EXPECT_NEAR(centre.yy, -3, 0.05 * 3);
  EXPECT_NEAR(centre.xy, 0, 0.05);
}

TEST(BrazilianDisc, BreaksFirstAlongTheLoadedDiameterAndSplits) {
  const Assembly disc = generate_disc(diameter, flat_width, elements(1.5e-3));
  PlatenTest test;
  test.specimen = Specimen::disc;
  test.speed = 0.1;
  const double y = 0.5 * diameter * std::sqrt(1 - flat_width * flat_width);
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

TEST(BrazilianDiscLong, TensileStrengthsStandBesideTheCompressiveOne) {
  for (const double cohesion : {95e6, calibrated_cohesion}) {
    std::vector<double> direct, splitting;
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
      PlatenTest pull;
      pull.speed = -0.1;
      direct.push_back(load_between_platens(Exec(), specimen(3e-3, seed), rock_of(cohesion, seed), pull).strength);
      PlatenTest split;
      split.specimen = Specimen::disc;
      split.speed = 0.1;
      const Assembly disc = generate_disc(diameter, flat_width, elements(2e-3, seed));
      splitting.push_back(load_between_platens(Exec(), disc, rock_of(cohesion, seed), split).strength);
    }
    const Spread t = spread_of(direct), b = spread_of(splitting);
    record("tensile_strengths", {{"cohesion", cohesion},
                                 {"direct", t.mean},
                                 {"direct_deviation", t.deviation},
                                 {"brazilian", b.mean},
                                 {"brazilian_deviation", b.deviation}});
    EXPECT_NEAR(t.mean, 10.5e6, 0.1 * 10.5e6);  // 0.70 of the bonds' mean strength of 15 MPa
    EXPECT_GT(b.mean, 0.7 * t.mean);
    EXPECT_LT(b.mean, 1.5 * t.mean);
  }
}

}  // namespace
