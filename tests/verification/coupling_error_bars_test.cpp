// Error bars against answers that are known: they hold the true error, and are not much wider.
#include "coupling/error_bars.hpp"
#include "support/temporary_folder.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <functional>
#include <numbers>
#include <string>
#include <vector>

namespace vug {
namespace {

constexpr double pi = std::numbers::pi;

/// A case and what a column of its history must be at time t.
struct Known {
  std::string name, text, column;
  std::function<double(double t)> exact;
};

constexpr double L = 1e-3, H = 5e-4, D = 1e-9, C0 = 2;  // m, m, m2/s, mol/m3

/// Lattice of n cells along L and 16 across, run to the Fourier number Fo = D t / L².
std::string lattice(int n, double Fo) {
  const double dx = L / n;
  return fmt::format("[lattice]\nsize = [{}, {:.17g}]\nspacing = {:.17g}\ntime_step = {:.17g}\n[time]\nend = {:.17g}\n",
                     L, 16 * dx, dx, 0.03 * dx * dx / D, Fo * L * L / D);
}
double height(int n) {
  return 16 * L / n;
}

std::string acid(double initial) {
  return fmt::format("[solute]\n[[solute.species]]\nname = \"A\"\ndiffusivity = {}\ninitial = {}\n", D, initial);
}
const std::string open = "[geometry]\ntype = \"open\"\n";
const std::string given_left =
    fmt::format("[boundary.left]\nsolute = {{ type = \"concentration\", concentration = {{ A = {} }} }}\n", C0);

/// Share of a slab between a given value and a closed side that is filled at Fo (Crank 1975, Eq. 4.18).
double filled(double Fo) {
  double left = 0;
  for (int n = 0; n < 200; ++n) {
    const double k = (2 * n + 1) * pi / 2;
    left += 2 / (k * k) * std::exp(-k * k * Fo);
  }
  return 1 - left;
}

/// Share of a slab's acid that is left at Fo when one side reacts with Da = k L / D and the other is closed
/// (Crank 1975, Eq. 4.53: roots of b tan b = Da).
double unreacted(double Da, double Fo) {
  double left = 0;
  for (int n = 0; n < 60; ++n) {
    double low = n * pi, high = n * pi + pi / 2;
    for (int k = 0; k < 200; ++k) {
      const double b = (low + high) / 2;
      (b * std::tan(b) < Da ? low : high) = b;
    }
    const double b = (low + high) / 2;
    left += 2 * Da * Da * std::exp(-b * b * Fo) / (b * b * (b * b + Da * Da + Da));
  }
  return left;
}

std::vector<Known> diffusion_into_a_slab() {
  std::vector<Known> cases;
  for (const int n : {16, 32})
    for (const double Fo : {0.02, 0.05, 0.1, 0.3, 0.8}) {
      const double all = C0 * L * height(n);
      cases.push_back({fmt::format("diffusion {} {}", n, Fo), lattice(n, Fo) + open + acid(0) + given_left,
                       "A_stored_mol_per_m", [=](double t) { return all * filled(D * t / (L * L)); }});
    }
  return cases;
}

std::vector<Known> warming_of_a_slab() {
  std::vector<Known> cases;
  for (const int n : {16, 32})
    for (const double Fo : {0.03, 0.07, 0.15, 0.4, 1.0}) {
      const std::string text =
          lattice(n, Fo) + open +
          fmt::format("[heat]\nfluid_diffusivity = {0}\nsolid_diffusivity = {0}\ninitial_temperature = 300\n", D) +
          "[boundary.right]\nheat = { type = \"temperature\", temperature = 320 }\n";
      const double all = 4e6 * 20 * L * height(n);
      cases.push_back({fmt::format("heat {} {}", n, Fo), text, "heat_stored_J_per_m",
                       [=](double t) { return all * filled(D * t / (L * L)); }});
    }
  return cases;
}

/// Half of the length is rock that reacts with the acid in the other half.
std::string reacting_right_half(double Da) {
  return "[geometry]\ntype = \"shapes\"\n[[geometry.shapes]]\ntype = \"rectangle\"\n" +
         fmt::format("from = [{:.17g}, -1]\nto = [1, 1]\n", L / 2) +
         fmt::format("[reaction]\nreactant = \"A\"\nrate_constant = {:.17g}\nmolar_volume = 0\n", Da * D / (L / 2));
}

std::vector<Known> acid_that_reacts_away() {
  std::vector<Known> cases;
  for (const double Da : {0.1, 0.5, 2.0, 10.0, 50.0})
    for (const double Fo : {0.05, 0.2, 0.6}) {  // of the half
      const double all = C0 * L / 2 * height(32);
      cases.push_back({fmt::format("reaction {} {}", Da, Fo), lattice(32, Fo / 4) + acid(C0) + reacting_right_half(Da),
                       "A_stored_mol_per_m", [=](double t) { return all * unreacted(Da, 4 * D * t / (L * L)); }});
    }
  return cases;
}

std::vector<Known> steady_supply_of_a_wall() {
  std::vector<Known> cases;
  for (const double Da : {0.2, 1.0, 5.0, 20.0, 100.0}) {
    const double all = C0 * L / 2 * height(32);
    cases.push_back({fmt::format("steady {}", Da), lattice(32, 2.0) + acid(0) + reacting_right_half(Da) + given_left,
                     "A_stored_mol_per_m", [=](double) { return all * (1 - Da / (2 * (1 + Da))); }});
  }
  return cases;
}

std::vector<Known> diffusion_into_a_square() {
  std::vector<Known> cases;
  for (const int n : {16, 32})
    for (const double Fo : {0.01, 0.02, 0.05, 0.1, 0.2}) {  // all four sides given: (1 - C/C0) is a product
      const double dx = L / n;
      std::string text =
          fmt::format(
              "[lattice]\nsize = [{0}, {0}]\nspacing = {1:.17g}\ntime_step = {2:.17g}\n[time]\nend = {3:.17g}\n", L, dx,
              0.03 * dx * dx / D, Fo * L * L / D) +
          open + acid(0);
      for (const char* side : {"left", "right", "bottom", "top"})
        text += fmt::format("[boundary.{}]\nsolute = {{ type = \"concentration\", concentration = {{ A = {} }} }}\n",
                            side, C0);
      cases.push_back({fmt::format("square {} {}", n, Fo), text, "A_stored_mol_per_m", [=](double t) {
                         const double empty = 1 - filled(4 * D * t / (L * L));
                         return C0 * L * L * (1 - empty * empty);
                       }});
    }
  return cases;
}

TEST(ErrorBars, HoldTheTrueErrorOfFiftyKnownAnswersAndAreNotMuchWider) {
  std::vector<Known> cases;
  for (const auto& family : {diffusion_into_a_slab(), warming_of_a_slab(), acid_that_reacts_away(),
                             steady_supply_of_a_wall(), diffusion_into_a_square()})
    cases.insert(cases.end(), family.begin(), family.end());
  ASSERT_GE(cases.size(), 50u);
  int held = 0, tight = 0;
  for (const Known& known : cases) {
    const test::TemporaryFolder folder;
    const std::string path = folder / "case.toml";
    std::ofstream(path) << known.text;
    RunOptions options;
    options.directory = folder / "run";
    run_with_error_bars(read_scene(path), options);
    const History bars = read_history(folder / "run/error_bars.csv");
    const int at = bars.find(known.column);
    ASSERT_GE(at, 0) << known.name;
    const double value = bars.values[static_cast<std::size_t>(at)].back(),
                 bar = bars.values[static_cast<std::size_t>(at) + 1].back();
    const double exact = known.exact(bars.time().back()), error = std::abs(value - exact);
    held += error <= bar;
    tight += bar <= 5 * error;
    RecordProperty(known.name,
                   fmt::format("{:.6g} +- {:.2g}, error {:.2g}", value / exact, bar / exact, error / exact));
  }
  RecordProperty("held", held);
  RecordProperty("within five times", tight);
  EXPECT_GE(held, 0.9 * static_cast<double>(cases.size()));
  EXPECT_GE(tight, 0.5 * static_cast<double>(cases.size()));
}

}  // namespace
}  // namespace vug
