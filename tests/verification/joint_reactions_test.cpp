// Reactions at one wall of which one reads what another one changes, against the exact steady fluxes in a gap of fluid
// between a side with given concentrations and the wall.
#include "base/require.hpp"
#include "support/coupled_run.hpp"
#include "support/record.hpp"

#include <Eigen/Dense>
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace vug {
namespace {

constexpr double gap = 1.6e-4, dx = 1e-5, dt = 1e-4, height = 4 * dx;
constexpr std::array<double, 3> D{2e-7, 1e-7, 3e-7};                    // of a, b and c
constexpr std::array<double, 3> given{1000, 700, 50};                   // at the side, mol/m3
constexpr std::array<double, 3> d{D[0] / gap, D[1] / gap, D[2] / gap};  // flux per difference, m/s

/// Three species in the gap; reactions as lines of an inline table each.
std::string scene(const std::vector<std::string>& reactions) {
  std::string text = fmt::format(
      "[lattice]\nsize = [2e-4, 4e-5]\nspacing = {}\ntime_step = {}\n[time]\nsteps = 1000000\n[geometry]\n"
      "type = \"shapes\"\n[[geometry.shapes]]\ntype = \"rectangle\"\nfrom = [1.6e-4, -1]\nto = [1, 1]\n[solute]\n",
      dx, dt);
  for (int s = 0; s < 3; ++s)
    text += fmt::format("[[solute.species]]\nname = \"{}\"\ndiffusivity = {}\n", "abc"[s], D[s]);
  text += "[reaction]\nreference_concentration = 400\n" + reactions[0];
  for (std::size_t r = 1; r < reactions.size(); ++r) text += "[[reaction.further]]\n" + reactions[r];
  return text + fmt::format(
                    "[boundary.left]\nsolute = {{ type = \"concentration\", concentration = {{ a = {}, b = {}, c = {} "
                    "}} }}\n",
                    given[0], given[1], given[2]);
}

/// What leaves the side of each species per area and time, mol/m2/s, once it is steady.
std::array<double, 3> fluxes(const std::vector<std::string>& reactions, const std::vector<std::string>& settings) {
  test::CoupledRun run(scene(reactions), settings);
  run.steps(24000);
  const auto injected = [&](int s) { return run.gain(std::string(1, "abc"[s]), "injected"); };
  std::array<double, 3> before{injected(0), injected(1), injected(2)}, flux{};
  run.steps(400);
  for (int s = 0; s < 3; ++s) flux[s] = (injected(s) - before[s]) / (400 * dt * height);
  EXPECT_LT(run.worst_balance(), 1e-12);
  return flux;
}

/// The same for every order of the reactions and with steps of four lattice steps, to the digits of a steady state.
void expect_fluxes(const char* name, std::vector<std::string> reactions, const std::array<double, 3>& exact) {
  for (int turn = 0; turn < 2; ++turn) {
    for (const int interval : {1, 4}) {
      const auto found = fluxes(reactions, {fmt::format("accuracy.solute_interval={}", interval)});
      for (int s = 0; s < 3; ++s) {
        const double error = found[s] - exact[s], scale = d[s] * given[s];
        EXPECT_NEAR(found[s], exact[s], 1e-8 * scale) << name << ", "
                                                      << "abc"[s] << ", order " << turn;
        test::record("joint_reactions", {{"case", name},
                                         {"species", std::string(1, "abc"[s])},
                                         {"turned", turn},
                                         {"interval", interval},
                                         {"error", error / scale}});
      }
    }
    std::swap(reactions[0], reactions[1]);
  }
}

/// a -> 2 c for good and b <-> c: fluxes J_a = k C_a and J_b = k (C_b - 2 C_c) with C what diffusion leaves at the
/// wall.
TEST(JointReactions, ACommonProductThatTurnsBack) {
  const double k = 2e-3, q = 2;
  Eigen::Matrix3d M;
  M << d[0] + k, 0, 0, 0, d[1] + k, -k * q, -2 * k, -k, d[2] + k * q;
  const Eigen::Vector3d C = M.partialPivLu().solve(Eigen::Vector3d{d[0] * given[0], d[1] * given[1], d[2] * given[2]});
  const double of_a = k * C[0], of_b = k * (C[1] - q * C[2]);
  expect_fluxes("common product",
                {"reactant = \"a\"\nproduct = \"c\"\nrate_constant = 2e-3\nproduct_stoichiometry = 2\n",
                 "reactant = \"b\"\nproduct = \"c\"\nrate_constant = 2e-3\nequilibrium_constant = 0.5\n"},
                {of_a, of_b, -2 * of_a - of_b});
}

/// Both turn back, at rates that diffusion hardly follows.
TEST(JointReactions, TwoThatAreNearEquilibrium) {
  const double k = 1, q_a = 3, q_b = 0.4;
  Eigen::Matrix3d M;
  M << d[0] + k, 0, -k * q_a, 0, d[1] + k, -k * q_b, -k, -k, d[2] + k * (q_a + q_b);
  const Eigen::Vector3d C = M.partialPivLu().solve(Eigen::Vector3d{d[0] * given[0], d[1] * given[1], d[2] * given[2]});
  const double of_a = d[0] * (given[0] - C[0]), of_b = d[1] * (given[1] - C[1]);
  expect_fluxes(
      "near equilibrium",
      {fmt::format("reactant = \"a\"\nproduct = \"c\"\nrate_constant = 1\nequilibrium_constant = {}\n", 1 / q_a),
       fmt::format("reactant = \"b\"\nproduct = \"c\"\nrate_constant = 1\nequilibrium_constant = {}\n", 1 / q_b)},
      {of_a, of_b, -of_a - of_b});
}

/// a -> b -> c.
TEST(JointReactions, AChain) {
  const double k = 3e-3, of_a = d[0] * given[0] * k / (d[0] + k), of_b = k * (d[1] * given[1] + of_a) / (d[1] + k);
  expect_fluxes("chain",
                {"reactant = \"a\"\nproduct = \"b\"\nrate_constant = 3e-3\n",
                 "reactant = \"b\"\nproduct = \"c\"\nrate_constant = 3e-3\n"},
                {of_a, of_b - of_a, -of_b});
}

/// The same where b reacts with k C_ref (C/C_ref)^2, C_ref = 400 mol/m3: a quadratic equation.
TEST(JointReactions, AChainOfAnotherOrder) {
  const double k = 3e-3, of_a = d[0] * given[0] * k / (d[0] + k);
  const double k2 = k / 400, in = d[1] * given[1] + of_a, C = (std::sqrt(d[1] * d[1] + 4 * k2 * in) - d[1]) / (2 * k2);
  expect_fluxes("chain of order 2",
                {"reactant = \"a\"\nproduct = \"b\"\nrate_constant = 3e-3\n",
                 "reactant = \"b\"\nproduct = \"c\"\nrate_constant = 3e-3\norder = 2\n"},
                {of_a, k2 * C * C - of_a, -k2 * C * C});
}

/// a <-> b and back again by another reaction: a circle, whose flow is not that of any equilibrium.
TEST(JointReactions, ACircle) {
  const double k = 2e-3, q = 0.5;
  Eigen::Matrix2d M;
  M << d[0] + k, -k * q - k, -k, d[1] + k * q + k;
  const Eigen::Vector2d C = M.partialPivLu().solve(Eigen::Vector2d{d[0] * given[0], d[1] * given[1]});
  const double there = k * (C[0] - q * C[1]), back = k * C[1];
  expect_fluxes("circle",
                {"reactant = \"a\"\nproduct = \"b\"\nrate_constant = 2e-3\nequilibrium_constant = 2\n",
                 "reactant = \"b\"\nproduct = \"a\"\nrate_constant = 2e-3\n"},
                {there - back, back - there, 0});
}

/// a -> b with k C_ref (C/C_ref)^n and b -> a with k C, at rates a hundred times what diffusion across a cell carries:
/// d_a (a_0 - a) = k C_ref (a/C_ref)^n - k b = -d_b (b_0 - b), found by bisection.
TEST(JointReactions, ACircleOfAnotherOrder) {
  for (const double n : {0.5, 2.0}) {
    constexpr double k = 1;
    double low = 0, high = given[0] + d[1] / d[0] * given[1];
    for (int round = 0; round < 200; ++round) {
      const double a = 0.5 * (low + high), b = given[1] + d[0] / d[1] * (given[0] - a);
      (k * 400 * std::pow(a / 400, n) - k * b > d[0] * (given[0] - a) ? high : low) = a;
    }
    const double flux = d[0] * (given[0] - low);
    expect_fluxes("circle of another order",
                  {fmt::format("reactant = \"a\"\nproduct = \"b\"\nrate_constant = 1\norder = {}\n", n),
                   "reactant = \"b\"\nproduct = \"a\"\nrate_constant = 1\n"},
                  {flux, -flux, 0});
  }
}

/// a -> y b -> z a; where both turn back, the circle the other way round as well.
TEST(JointReactions, CirclesThatMakeMoreThanTheyTakeAreWarnedOf) {
  const auto warnings = [](double there, double back, const char* turns_back = "") {
    const auto reaction = [&](const char* names, double moles) {
      return fmt::format("{}\nrate_constant = 1\nproduct_stoichiometry = {}\n{}", names, moles, turns_back);
    };
    const std::string text = scene(
        {reaction("reactant = \"a\"\nproduct = \"b\"", there), reaction("reactant = \"b\"\nproduct = \"a\"", back)});
    return parse_scene(text, "case.toml").warnings;
  };
  const auto of = [](int moles) {
    return std::vector{fmt::format(
        "[reaction]: in a circle of reactions a mole of a becomes {} moles of it; where that is faster than "
        "diffusion, no concentrations at the wall satisfy the rates, and results have no meaning",
        moles)};
  };
  const std::vector<std::string> none;
  EXPECT_EQ(warnings(2, 2), of(4));
  EXPECT_EQ(warnings(2, 0.5), none);
  EXPECT_EQ(warnings(3, 0.3), none);
  EXPECT_EQ(warnings(0.25, 2), none);
  EXPECT_EQ(warnings(0.25, 2, "equilibrium_constant = 1e3\n"), of(2));
}

TEST(JointReactions, MoreThanSixAreRefused) {
  std::string text = scene({"reactant = \"a\"\nproduct = \"b\"\nrate_constant = 1e-3\n"});
  std::string species, further;
  for (char name = 'd'; name < 'j'; ++name) {
    species += fmt::format("[[solute.species]]\nname = \"{}\"\ndiffusivity = 1e-7\n", name);
    further += fmt::format("[[reaction.further]]\nreactant = \"{}\"\nproduct = \"a\"\nrate_constant = 1e-3\n", name);
  }
  text.insert(text.find("[boundary.left]"), further);
  text.insert(text.find("[reaction]"), species);
  try {
    test::CoupledRun run(text);
    FAIL() << "accepted";
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(),
                 "case.toml: reaction.further: one reaction reads what another one changes, and then there may be 6 of "
                 "them in all, not 7");
  }
}

}  // namespace
}  // namespace vug
