// Laws and kernels of conjugate heat on lattices small enough to check by hand.
#include "base/require.hpp"
#include "kernels/flow/guards.hpp"
#include "kernels/heat/heat_bands.hpp"
#include "kernels/heat/heat_kernels.hpp"
#include "support/heat_box.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace vug {
namespace {

using test::HeatBox;
using test::velocity_sets;

constexpr double contrasts[] = {1e-4, 0.01, 0.625, 1, 10, 1e3, 1e4};

TEST(ConjugateLink, IsTheHalfLinkConditionOnBothSides) {
  const double fluid_out = 0.3, solid_out = -0.7;
  for (const double sigma : contrasts) {
    const double r = interface_reflection(sigma);
    const double into_fluid = ((1 - sigma) * fluid_out + 2 * sigma * solid_out) / (1 + sigma);
    const double into_solid = (2 * fluid_out - (1 - sigma) * solid_out) / (1 + sigma);
    EXPECT_NEAR(solid_out + conjugate_gain(solid_out, fluid_out, r, 0.0, 1.0), into_fluid, 1e-15);
    EXPECT_NEAR(fluid_out + conjugate_gain(fluid_out, solid_out, r, 1.0, 0.0), into_solid, 1e-15);
    EXPECT_EQ(conjugate_gain(solid_out, fluid_out, r, 1.0, 1.0), 0);
  }
}

TEST(ConjugateLink, ConservesEnergyAtAnyContrast) {
  const double fluid_out = 0.3, solid_out = -0.7;
  for (const double sigma : contrasts) {
    const double r = interface_reflection(sigma);
    const double lost = fluid_out - solid_out - conjugate_gain(solid_out, fluid_out, r, 0.0, 1.0);
    const double gained = fluid_out + conjugate_gain(fluid_out, solid_out, r, 1.0, 0.0) - solid_out;
    EXPECT_NEAR(lost, sigma * gained, 1e-15 * std::max(1.0, sigma));
  }
}

TEST(HeatRates, RefuseWhatIsNotPositive) {
  EXPECT_THROW(heat_rates<double>({0, 1, 1}), InputError);
  EXPECT_THROW(heat_rates<double>({1, -1, 1}), InputError);
  EXPECT_THROW(heat_rates<double>({1, 1, std::nan("")}), InputError);
}

TEST(HeatFields, HaveAsManyLatticesAsAreCounted) {
  for (const ScalarVelocitySet set : velocity_sets) {
    const HeatBox<double> box(
        10, 6, {0.1, 0.2, 2, set}, [](int, int) { return false; }, [](int, int) { return 1.0; });
    const std::size_t slots = box.fields.lattice.size() * (set == ScalarVelocitySet::d2q9 ? D2Q9::Q : D2Q5::Q);
    EXPECT_EQ(box.fields.g.size() + box.fields.g_next.size(), heat_lattices * slots);
  }
}

/// The textbook form of one step: pull, both formulas of the link, two relaxation times; periodic, no flow.
template <class Set>
class PlainTwoRelaxationTimes {
 public:
  PlainTwoRelaxationTimes(int nx, int ny, HeatParameters p, std::vector<int> solid, const std::vector<double>& theta)
      : nx_(nx), ny_(ny), p_(p), solid_(std::move(solid)), g_(Q * theta.size()) {
    for (std::size_t n = 0; n < theta.size(); ++n)
      for (int q = 0; q < Q; ++q) g_[Q * n + q] = Set::w(q) * theta[n];
  }
  void step() {
    std::vector<double> next(g_.size());
    for (int y = 0; y < ny_; ++y)
      for (int x = 0; x < nx_; ++x) collide(x, y, &next[Q * node(x, y)]);
    g_ = next;
  }
  double theta(int x, int y) const {
    double sum = 0;
    for (int q = 0; q < Q; ++q) sum += g_[Q * node(x, y) + q];
    return sum;
  }

 private:
  static constexpr int Q = Set::Q;
  int node(int x, int y) const { return (y + ny_) % ny_ * nx_ + (x + nx_) % nx_; }
  double arriving(int x, int y, int q) const {
    const int here = node(x, y), there = node(x - Set::c(q, 0), y - Set::c(q, 1));
    const double own = g_[Q * here + Set::opposite(q)], other = g_[Q * there + q], sigma = p_.capacity_ratio;
    if (solid_[here] == solid_[there]) return other;
    if (solid_[here]) return (2 * other - (1 - sigma) * own) / (1 + sigma);
    return ((1 - sigma) * own + 2 * sigma * other) / (1 + sigma);
  }
  void collide(int x, int y, double* out) const {
    double in[Q], t = 0;
    for (int q = 0; q < Q; ++q) t += in[q] = arriving(x, y, q);
    const double d = solid_[node(x, y)] ? p_.solid_diffusivity : p_.fluid_diffusivity;
    const double odd = 1 / (0.5 + 3 * d), even = 1 / (0.5 + 0.25 / (3 * d));
    for (int q = 0; q < Q; ++q) {
      const int o = Set::opposite(q);
      out[q] = in[q] - even * (0.5 * (in[q] + in[o]) - Set::w(q) * t) - odd * 0.5 * (in[q] - in[o]);
    }
  }
  int nx_, ny_;
  HeatParameters p_;
  std::vector<int> solid_;
  std::vector<double> g_;
};

template <class Set>
void expect_plain_steps(ScalarVelocitySet set) {
  const HeatParameters p{0.056, 0.14, 0.625, set};
  const int n = 5;
  std::mt19937 random(7);
  std::vector<int> solid(n * n);
  std::vector<double> theta(n * n);
  for (int i = 0; i < n * n; ++i) {
    solid[i] = static_cast<int>(random() % 2);
    theta[i] = std::uniform_real_distribution<>(-1, 1)(random);
  }
  HeatBox<double> box(
      n, n, p, [&](int x, int y) { return solid[y * n + x] == 1; }, [&](int x, int y) { return theta[y * n + x]; },
      {true, true});
  PlainTwoRelaxationTimes<Set> plain(n, n, p, solid, theta);
  for (int step = 0; step < 20; ++step) plain.step();
  box.run(20);
  const std::vector<double> found = box.theta();
  for (int y = 0; y < n; ++y)
    for (int x = 0; x < n; ++x) EXPECT_NEAR(found[y * n + x], plain.theta(x, y), 1e-14);
}

TEST(Conduct, IsTwoRelaxationTimesWithTheConjugateLink) {
  expect_plain_steps<D2Q5>(ScalarVelocitySet::d2q5);
  expect_plain_steps<D2Q9>(ScalarVelocitySet::d2q9);
}

TEST(Conduct, ConservesEnergyWhileTheGeometryChanges) {
  for (const double sigma : contrasts) {
    const ScalarVelocitySet set = velocity_sets[sigma > 0.1 && sigma < 100];  // each at contrasts of its own
    std::mt19937 random(3);
    const int n = 12;
    std::vector<int> solid(n * n, 1);
    const auto is_solid = [&](int x, int y) { return solid[y * n + x] == 1; };
    HeatBox<double> box(n, n, {0.056, 0.14, sigma, set}, is_solid,
                        [](int x, int y) { return std::sin(3 * x + y * y); });
    double expected = box.energy();
    const ScalarField<double> booked("booked", 1);
    IndexList born("born", 1);
    double scale = 0;
    for (int round = 0; round < 60; ++round) {
      box.run(5);
      const int x = static_cast<int>(random() % n), y = static_cast<int>(random() % n);
      Kokkos::deep_copy(born, box.lattice.node(x, y));
      add_birth_energy(box.exec, box.fields, born, 0, 1, booked);
      solid[y * n + x] = 0;
      box.set_type(is_solid);
      set_heat_geometry(box.exec, box.type, {false, false}, box.fields);
      scale = std::max(scale, std::abs(box.energy()) + n * n * std::max(1.0, sigma));
    }
    expected += sum_in_order(booked);
    // 300 steps of sums over 144 nodes: round-off
    EXPECT_NEAR(box.energy(), expected, 1e-13 * scale) << "sigma = " << sigma;
  }
}

TEST(HeatExtremes, CountWhatIsNotFinite) {
  HeatBox<float> box(
      5, 4, {0.1, 0.1, 1}, [](int, int) { return false; }, [](int x, int y) { return x == 2 && y == 1 ? NAN : x - 1; });
  const HeatExtremes found = heat_extremes(box.exec, box.fields);
  EXPECT_EQ(found.not_finite, 1);
  EXPECT_EQ(found.lowest, -1);
  EXPECT_EQ(found.highest, 3);
}

/// Shear in both directions, free of divergence inside, against a staircase through which it would flow: e is large
/// beside every step.
std::array<double, 2> rough_flow(int x, int y) {
  return {0.1 * std::sin(0.35 * y), 0.08 * std::cos(0.3 * x)};
}
bool staircase(int x, int y) {
  return y < 3 + x / 3 || y > 14;
}

TEST(Advect, KeepsAUniformTemperatureUniformInAStairStepFlow) {
  for (const ScalarVelocitySet set : velocity_sets)
    for (const double sigma : contrasts) {
      HeatBox<double> box(20, 18, {0.02, 0.14, sigma, set}, staircase, [](int, int) { return 1.0; });
      box.flow(rough_flow);
      box.run(300);
      for (const double t : box.theta()) ASSERT_NEAR(t, 1, 1e-12) << "sigma = " << sigma;
    }
}

TEST(Advect, ConservesEnergyUpToTheBookedTerm) {
  for (const ScalarVelocitySet set : velocity_sets) {
    HeatBox<double> box(20, 18, {0.02, 0.14, 0.625, set}, staircase,
                        [](int x, int y) { return std::sin(x * 0.5 + y); });
    box.flow(rough_flow);
    const double before = box.energy();
    box.run(500);
    const double created = sum_in_order(box.created);
    EXPECT_GT(std::abs(created), 1e-3) << "the test should see the term at work";
    EXPECT_NEAR(box.energy() - before, created, 1e-11);
  }
}

/// A wave of temperature in uniform flow moves with the fluid: its phase falls by k . u a step.
TEST(Advect, CarriesAWaveAtTheVelocityOfTheFluid) {
  constexpr int nx = 32, ny = 24, steps = 100;
  const double pi = std::acos(-1.0), kx = 2 * pi / nx, ky = 2 * pi / ny, ux = 0.04, uy = -0.025;
  for (const ScalarVelocitySet set : velocity_sets) {
    HeatBox<double> box(
        nx, ny, {0.05, 0.05, 1, set}, [](int, int) { return false; },
        [&](int x, int y) { return std::sin(kx * x + ky * y); }, {true, true});
    box.flow([&](int, int) { return std::array<double, 2>{ux, uy}; });
    box.run(steps);
    const auto theta = box.theta();
    double sine = 0, cosine = 0;
    for (int y = 0; y < ny; ++y)
      for (int x = 0; x < nx; ++x) {
        sine += theta[y * nx + x] * std::sin(kx * x + ky * y);
        cosine += theta[y * nx + x] * std::cos(kx * x + ky * y);
      }
    EXPECT_NEAR(std::atan2(-cosine, sine) / ((kx * ux + ky * uy) * steps), 1, 0.04) << test::name_of(set);
  }
}

TEST(FirstOutside, IsTheLowestNodeThatIsNotFiniteOrBeyondTheBounds) {
  HeatBox<double> box(
      5, 4, {0.1, 0.1, 1}, [](int, int) { return false; },
      [](int x, int y) { return x == 3 && y == 2   ? NAN
                                : x == 1 && y == 3 ? -9.0
                                                   : 0.5 * y; });
  const auto first = [&](const HeatFields<double>& fields, double lowest, double highest) {
    return field_range(box.exec, temperatures(box.exec, fields), box.lattice.size(), lowest, highest).first_outside;
  };
  EXPECT_EQ(first(box.fields, -1, 2), box.lattice.node(3, 2));
  EXPECT_EQ(first(box.fields, -1, 0.4), box.lattice.node(0, 1));
  HeatBox<double> calm(
      5, 4, {0.1, 0.1, 1}, [](int, int) { return false; }, [](int, int) { return 0.0; });
  EXPECT_EQ(first(calm.fields, -1, 1), -1);
}

}  // namespace
}  // namespace vug
