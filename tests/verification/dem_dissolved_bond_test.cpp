// One bond of which acid has taken a share: what that leaves of stiffness, strengths and energies, and when it fails.
#include "support/one_bond.hpp"

#include <tuple>

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

/// With damage.normalised = false the fits of Eq. 29 themselves, 2 % below and 1 % above.
TEST_F(OneBond, DissolutionWeakensItByTheFitsThemselvesIfTheyAreNotNormalised) {
  parameters.chemical.normalised = false;
  Kokkos::deep_copy(bonds.d_c, 0.3);
  const double strength = 0.9104 * 15e6, energy = 0.4841 * 20;
  const double onset = strength / (0.7 * 24.03e9 / bond_length()), end = 2 * energy / strength;
  EXPECT_NEAR(stress_at(0.9995 * onset, 0)[0], 0.9995 * strength, 1e-6 * strength);
  EXPECT_EQ(state(), BondState::intact);
  stress_at(1.0005 * onset, 0);
  EXPECT_EQ(state(), BondState::damaged_in_tension);
  EXPECT_GT(stress_at(0.999 * end, 0)[0], 0);
  EXPECT_EQ(stress_at(1.001 * end, 0)[0],
            0);  // a straight line down to there: the energy is half its length times strength
}

/// With fits of its own: f1 = 2 - d and f2 = 4 d^2 - 4 d + 2 leave 0.75 and 0.5 at d_c = 0.5, and f2 no more at 0.6.
TEST_F(OneBond, DissolutionWeakensItByTheFitsOfItsRock) {
  parameters.chemical.strength = {0, -1, 2};
  parameters.chemical.energy = {4, -4, 2};
  for (const auto& [d_c, strength_share, energy_share] : {std::tuple{0.5, 0.75, 0.5}, {0.6, 0.7, 0.5}}) {
    const Assembly pair = vug::test::pair_of_triangles(l);
    particles = make_particles(pair, parameters);
    bonds = make_bonds(pair, particles, parameters);
    Kokkos::deep_copy(bonds.d_c, d_c);
    const double energy = 20 * energy_share, end = 2 * energy / (15e6 * strength_share);
    EXPECT_NEAR(work_until(1.01 * end, 0), energy, 1e-6 * energy) << d_c;
  }
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

/// A crack presses and rubs like two contact points, each with the dashpots of a contact times the share that
/// dissolution has left.
TEST_F(OneBond, DashpotsOfItsCrackAreThoseOfTwoContacts) {
  parameters.contact.tangential_damping = 500;
  const double c_n = parameters.contact.normal_damping, width = l / 2;
  const auto moving = [&](double closing, double along) {  // m/s
    const auto v = host_copy(particles.v);
    v(1, 0) = -closing;
    v(1, 1) = along;
    Kokkos::deep_copy(particles.v, v);
  };
  stress_at(1e-5, 0);
  ASSERT_EQ(state(), BondState::failed_in_tension);
  for (const double left : {1.0, 0.7}) {
    Kokkos::deep_copy(bonds.d_c, 1 - left);
    const double spring = left * 24.03e9 / bond_length() * 1e-7;  // Pa
    for (const double closing : {0.0, 1.0, -0.5})
      for (const double along : {0.0, 0.3, -0.2}) {  // below the friction
        moving(closing, along);
        const auto stress = stress_at(-1e-7, 0);
        EXPECT_NEAR(-stress[0], spring + left * c_n / width * closing, 1e-9 * spring) << left << ' ' << closing;
        EXPECT_NEAR(stress[1], left * 500 / width * along, 1e-9 * spring) << left << ' ' << along;
      }
  }
  moving(1, 0.3);
  EXPECT_EQ(stress_at(1e-7, 0)[0], 0) << "open";
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
