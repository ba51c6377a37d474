// One bond of which acid has taken a share: what that leaves of stiffness, strengths and energies, and when it fails.
#include "support/one_bond.hpp"

namespace {

using namespace vug;
using vug::test::host_copy;
using vug::test::OneBond;

// f1 and f2 of Eqs. 27 and 29 at d_c = 0.3, over those at 0
constexpr double strength_left = 0.9104 / 0.98, energy_left = 0.4841 / 1.01;

TEST_F(OneBond, DissolutionSoftensWeakensAndFinallyFailsIt) {
  const double k_n = 24.03e9 / bond_length();
  Kokkos::deep_copy(bonds.d_c, 0.3);
  EXPECT_NEAR(stress_at(1e-8, 0)[0], 0.7 * k_n * 1e-8, 1e-9 * k_n * 1e-8);
  EXPECT_NEAR(stress_at(-1e-8, 0)[0], -0.7 * k_n * 1e-8, 1e-9 * k_n * 1e-8);
  double peak = 0;
  for (int k = 1; k <= 4000; ++k) peak = std::max(peak, stress_at(k * 1e-9, 0)[0]);
  EXPECT_NEAR(peak, 15e6 * strength_left, 15e6 * 2e-3);
  Kokkos::deep_copy(bonds.d_c, 0.95);
  stress_at(0, 0);
  EXPECT_TRUE(has_failed(state()));
}

/// What has dissolved weakens the cohesion as it weakens the tensile strength, by f1 (Eq. 27).
TEST_F(OneBond, DissolutionWeakensItInShear) {
  Kokkos::deep_copy(bonds.d_c, 0.3);
  const double cohesion = 95e6 * strength_left, onset = cohesion / (0.7 * 10.68e9 / bond_length());
  EXPECT_NEAR(stress_at(0, 0.999 * onset)[1], 0.999 * cohesion, 1);
  EXPECT_FALSE(has_failed(state()));
  EXPECT_EQ(stress_at(0, 1.001 * onset)[1], 0);
  EXPECT_EQ(state(), BondState::failed_in_shear);
}

/// It takes the fracture energies by f2 (Eq. 29).
TEST_F(OneBond, DissolutionMakesItEasierToOpen) {
  Kokkos::deep_copy(bonds.d_c, 0.3);
  const double energy = 20 * energy_left, end = 2 * energy / (15e6 * strength_left);
  EXPECT_NEAR(work_until(1.01 * end, 0), energy, 1e-6 * energy);
}

TEST_F(OneBond, DissolutionMakesItEasierToShear) {
  set_bond_length(0.03e-3);  // too short to snap: it has stored half of the energy at the onset
  Kokkos::deep_copy(bonds.d_c, 0.3);
  const double energy = 64 * energy_left, end = 2 * energy / (95e6 * strength_left);
  EXPECT_NEAR(work_until(0, 1.01 * end), energy, 1e-6 * energy);
}

/// Whichever d_c that is; from then on its triangles' outlines count beside what is left of its faces.
TEST_F(OneBond, FailsAtTheChemicalDamageThatItIsTold) {
  parameters.chemical.failure_at = 0.6;
  Kokkos::deep_copy(bonds.d_c, 0.59);
  stress_at(0, 0);
  EXPECT_EQ(state(), BondState::intact);
  Kokkos::deep_copy(bonds.d_c, 0.61);
  stress_at(0, 0);
  EXPECT_EQ(state(), BondState::dissolved);
  EXPECT_EQ(host_copy(bonds.joint)(0), faces_dissolved);
}

}  // namespace
