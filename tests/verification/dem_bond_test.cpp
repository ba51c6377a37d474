// One bond between two triangles, its faces moved by hand: the law as the kernel applies it.
#include "dem/crack_aperture.hpp"
#include "support/one_bond.hpp"
#include "support/record.hpp"

namespace {

using namespace vug;
using vug::test::host_copy;
using vug::test::OneBond;

TEST_F(OneBond, ModeOneReleasesExactlyItsFractureEnergyAndPeaksAtItsStrength) {
  const double delta_f = 2 * 20 / 15e6;
  constexpr int steps = 20000;
  double work = 0, peak = 0, before = 0;
  for (int k = 1; k <= steps; ++k) {
    const double opening = 1.01 * delta_f * k / steps;
    const double stress = stress_at(opening, 0)[0];
    work += 0.5 * (before + stress) * 1.01 * delta_f / steps;
    peak = std::max(peak, stress);
    before = stress;
    if (k % 200 == 0)
      test::record("bond_curve", {{"angle", 0.0}, {"opening", opening}, {"normal", stress}, {"tangential", 0.0}});
  }
  test::record("bond_energy", {{"angle", 0.0}, {"energy", work / 20}, {"ellipse", std::pow(peak / 15e6, 2)}});
  // trapezoids of a piecewise linear curve: only the kink's cell errs, by (1/steps)^2
  EXPECT_NEAR(work, 20, 20 * 1e-6);
  EXPECT_NEAR(peak, 15e6, 15e6 * 1e-3);  // the sample next to the peak is at most one step (1e-3 of delta_0) away
  EXPECT_EQ(state(), BondState::failed_in_tension);
  EXPECT_EQ(host_copy(bonds.d_m)(0), 1);
}

class MixedModeBond : public OneBond, public ::testing::WithParamInterface<double> {};

TEST_P(MixedModeBond, EnergiesAddUpToOneAndThePeakLiesOnTheEllipse) {
  const double angle = GetParam() * Kokkos::numbers::pi / 180;
  constexpr int steps = 20000;
  const double last = 3e-5;
  const double k_n = 24.03e9 / bond_length(), k_t = 10.68e9 / bond_length();
  // end of the law on this path: sum of energies reaches one
  const double onset = 1 / std::hypot(k_n * std::cos(angle) / 15e6, k_t * std::sin(angle) / 95e6);
  const double end =
      std::min(last, 2 / (onset * (k_n * std::pow(std::cos(angle), 2) / 20 + k_t * std::pow(std::sin(angle), 2) / 64)));
  double work_n = 0, work_t = 0, peak = 0, peak_n = 0, peak_t = 0;
  std::array<double, 2> before{};
  for (int k = 1; k <= steps; ++k) {
    const double opening = 1.001 * end * k / steps, step = 1.001 * end / steps;
    const auto stress = stress_at(opening * std::cos(angle), opening * std::sin(angle));
    work_n += 0.5 * (before[0] + stress[0]) * step * std::cos(angle);
    work_t += 0.5 * (before[1] + stress[1]) * step * std::sin(angle);
    const double now = std::pow(stress[0] / 15e6, 2) + std::pow(stress[1] / 95e6, 2);
    if (now > peak) peak_n = stress[0], peak_t = stress[1];
    peak = std::max(peak, now);
    before = stress;
    if (k % 200 == 0)
      test::record("bond_curve",
                   {{"angle", GetParam()}, {"opening", opening}, {"normal", stress[0]}, {"tangential", stress[1]}});
  }
  test::record("bond_energy", {{"angle", GetParam()}, {"energy", work_n / 20 + work_t / 64}, {"ellipse", peak}});
  test::record("bond_ellipse", {{"angle", GetParam()}, {"normal", peak_n}, {"tangential", peak_t}});
  EXPECT_NEAR(work_n / 20 + work_t / 64, 1, 1e-6);
  EXPECT_NEAR(peak, 1, 2e-3);  // sampled next to the peak
  EXPECT_TRUE(has_failed(state()));
}

INSTANTIATE_TEST_SUITE_P(Degrees, MixedModeBond, ::testing::Values(15.0, 30.0, 45.0, 60.0, 75.0));

TEST_F(OneBond, PureShearSnapsAndReleasesWhatItHasStored) {
  // G_II = 64 N/m needs a bond shorter than 2 G_II M_t / c^2 = 0.1515 mm; this one is 0.76 mm long and stores more
  const double k_t = 10.68e9 / bond_length(), onset = 95e6 / k_t;
  EXPECT_NEAR(stress_at(0, 0.999 * onset)[1], 0.999 * 95e6, 1);
  EXPECT_FALSE(has_failed(state()));
  EXPECT_EQ(stress_at(0, 1.001 * onset)[1], 0);
  EXPECT_EQ(state(), BondState::failed_in_shear);
}

TEST_F(OneBond, ShortBondSoftensInShearAndReleasesG2) {
  set_bond_length(0.1e-3);
  // onset at 2/3 of the way, then a steep fall: the kink's cell errs by 3 / steps^2 of the area
  EXPECT_NEAR(work_until(0, 1.001 * 2 * 64 / 95e6), 64, 64 * 1e-6);
}

/// Mohr-Coulomb: pressed by sigma a bond bears a shear stress of c + tan(phi) sigma, a crack the contact's mu sigma.
TEST_F(OneBond, BearsMoreShearByItsInternalFrictionWherePressed) {
  const double k_n = 24.03e9 / bond_length(), k_t = 10.68e9 / bond_length();
  const double sigma = 40e6, strength = 95e6 + 0.47 * sigma;
  EXPECT_NEAR(stress_at(-sigma / k_n, 0.999 * strength / k_t)[1], 0.999 * strength, 1);
  EXPECT_EQ(state(), BondState::intact);
  EXPECT_NEAR(stress_at(-sigma / k_n, 1.001 * strength / k_t)[0], -sigma, 1);
  EXPECT_EQ(state(), BondState::failed_in_shear);
  EXPECT_NEAR(stress_at(-sigma / k_n, 2 * strength / k_t)[1], 0.3 * sigma, 1);
}

TEST_F(OneBond, UnloadsToTheOriginAndReloadsAlongTheSecant) {
  const double opening = 1e-6;
  const double loaded = stress_at(opening, 0)[0];
  const double d_m = host_copy(bonds.d_m)(0);
  ASSERT_GT(d_m, 0.1);
  EXPECT_NEAR(stress_at(0.5 * opening, 0)[0], 0.5 * loaded, 1e-9 * loaded);
  EXPECT_NEAR(stress_at(0, 0)[0], 0, 1e-9 * loaded);
  EXPECT_NEAR(stress_at(0.8 * opening, 0)[0], 0.8 * loaded, 1e-9 * loaded);
  EXPECT_EQ(host_copy(bonds.d_m)(0), d_m);
}

TEST_F(OneBond, RecoversItsFullStiffnessInCompressionDamagedOrBroken) {
  const double k_n = 24.03e9 / bond_length();
  stress_at(1e-6, 0);
  EXPECT_NEAR(stress_at(-1e-7, 0)[0], -k_n * 1e-7, 1e-9 * k_n * 1e-7);
  stress_at(1e-5, 0);
  ASSERT_TRUE(has_failed(state()));
  EXPECT_EQ(stress_at(1e-7, 0)[0], 0);
  EXPECT_NEAR(stress_at(-1e-7, 0)[0], -k_n * 1e-7, 1e-9 * k_n * 1e-7);
}

TEST_F(OneBond, BrokenFacesRubByTheContactsFriction) {
  const double k_n = 24.03e9 / bond_length(), k_t = 10.68e9 / bond_length();
  stress_at(1e-5, 0);
  stress_at(-1e-6, 0);
  EXPECT_NEAR(stress_at(-1e-6, 1e-8)[1], k_t * 1e-8, 1e-6 * k_t * 1e-8);
  EXPECT_NEAR(stress_at(-1e-6, 1e-5)[1], 0.3 * k_n * 1e-6, 1e-6 * k_n * 1e-6);
  EXPECT_NEAR(stress_at(-1e-6, 0.99e-5)[1], 0.3 * k_n * 1e-6 - k_t * 1e-7, 1e-6 * k_n * 1e-6);  // sticks going back
}

TEST_F(OneBond, BendingOpensOneEndAndNeedsNoRotationalModulus) {
  const double k_n = 24.03e9 / bond_length(), angle = 1e-6;
  // particle b turns about the middle of the edge
  const double arm = l / (2 * std::sqrt(3.0));
  test::place(particles, 1, arm * (std::cos(angle) - 1), arm * std::sin(angle), angle);
  compute_forces(Exec(), parameters, 0, particles, bonds, make_contacts(particles, bonds, false), NoAccounts{});
  const auto load = host_copy(bonds.load);
  // two points at ± l / (2 sqrt 3), each with k_n l / 2: torque k_n l^3 / 12 times the angle
  EXPECT_NEAR(load(0, 3) + arm * load(0, 1), -k_n * l * l * l / 12 * angle, 1e-5 * k_n * l * l * l / 12 * angle);
  EXPECT_NEAR(load(0, 0), 0, 1e-5 * k_n * l * l * angle);
}

/// Particle b turns about the middle of the edge, which opens by `middle`; by lubrication the wedge conducts like the
/// slot of (mean of 1/w^3)^(-1/3).
TEST_F(OneBond, GapesLikeTheSlotThatConductsAlike) {
  const double arm = l / (2 * std::sqrt(3.0)), unit = 1e-6, residual = 0.5e-6;
  const ScalarField<double> aperture("aperture", 1);
  const auto found = [&](double middle, double at_end, double d_m, double kept) {
    const double angle = at_end / (l / 2);
    test::place(particles, 1, middle + arm * (std::cos(angle) - 1), arm * std::sin(angle), angle);
    Kokkos::deep_copy(bonds.d_m, d_m);
    find_crack_apertures(Exec(), particles, bonds, 0, kept, unit, aperture);
    return host_copy(aperture)(0);
  };
  const auto slot = [&](double a, double b) {
    double sum = 0;
    constexpr int parts = 2000;
    for (int i = 0; i < parts; ++i) sum += std::pow(a + (b - a) * (i + 0.5) / parts, -3) / parts;
    return std::pow(sum, -1.0 / 3);
  };
  EXPECT_NEAR(found(2e-6, 0, 1, 0), 2, 1e-6);
  EXPECT_NEAR(found(2e-6, 0, 0.25, residual), 0.25 * 2.5, 1e-6);
  EXPECT_NEAR(found(2e-6, 1e-6, 1, 0), slot(1, 3), 1e-3);
  EXPECT_NEAR(found(2e-6, -1e-6, 1, 0), slot(3, 1), 1e-3);
  EXPECT_NEAR(found(0.5e-6, 1e-6, 1, residual), slot(0.5, 2), 1e-3);  // faces that touch keep what is left
  EXPECT_EQ(found(0.5e-6, 1e-6, 1, 0), 0);
  EXPECT_EQ(found(-2e-6, 0, 1, 0), 0);
  EXPECT_EQ(found(2e-6, 0, 0, residual), 0);  // intact
  Kokkos::deep_copy(bonds.state, BondState::dissolved);
  EXPECT_NEAR(found(2e-6, 0, 0, 0), 2, 1e-6);  // gapes as any that has failed, whatever its d_m
  test::edit(particles.solid_fraction, [](const auto& host) { host(1) = 0.01; });
  EXPECT_NEAR(found(9e-6, 0, 0, 0), 2, 1e-6);  // nobody is there any more: as it was
}

}  // namespace
