// Intervals that are chosen as the run goes (accuracy.tolerance), at the extremes of the maps of docs/stability.md:
// they lose nothing that holds when every step is taken.
#include "base/require.hpp"
#include "coupling/simulation.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <optional>
#include <vector>

namespace vug {
namespace {

constexpr int nx = 48, ny = 24, steps = 4000;
constexpr double cold = 300, hot = 340;
/// A tolerance speaks of whole fields; single nodes overshoot by 0.003 more at the most, with either.
constexpr double alike = 0.005;

/// Hot acid that a flow of this speed at the inlet carries past grains which conduct and react; lattice units.
std::string grains(double heat, double acid, double contrast, double speed) {
  return fmt::format(
      "[lattice]\nsize = [{}, {}]\nspacing = 1\ntime_step = 1\n[time]\nsteps = 100000\n"
      "[geometry]\ntype = \"shapes\"\n[[geometry.shapes]]\ntype = \"disc\"\ncentre = [18, 11]\nradius = 5\n"
      "[[geometry.shapes]]\ntype = \"disc\"\ncentre = [34, 4]\nradius = 5\n"
      "[flow]\nviscosity = 0.2\ndensity = 1\ninitial_pressure = 0\n"
      "[heat]\nfluid_diffusivity = {}\nsolid_diffusivity = {}\ninitial_temperature = {}\n"
      "[solute]\n[[solute.species]]\nname = \"A\"\ndiffusivity = {}\n"
      "[reaction]\nreactant = \"A\"\nrate_constant = 0.01\nmolar_volume = 1e-3\nactivation_energy = 3e4\n"
      "reference_temperature = 300\n"
      "[boundary.left]\nflow = {{ type = \"velocity\", velocity = [{}, 0], ramp_time = 400 }}\n"
      "heat = {{ type = \"temperature\", temperature = {} }}\n"
      "solute = {{ type = \"concentration\", concentration = {{ A = 1 }} }}\n"
      "[boundary.right]\nflow = {{ type = \"pressure\", pressure = 0 }}\nheat = {{ type = \"outflow\" }}\n"
      "solute = {{ type = \"outflow\" }}\n",
      nx, ny, heat, heat * contrast, cold, acid, speed, hot);
}

/// How far temperatures and concentrations lie outside of what comes in and what was there, in shares of the
/// difference; nothing where the run is lost.
std::optional<double> overshoot(const std::string& text) {
  Simulation simulation(parse_scene(text, "case.toml"));
  double found = 0;
  try {
    for (int step = 1; step <= steps; ++step) {
      simulation.step();
      if (step % 250 != 0) continue;
      simulation.guard();
      const FieldList fields = simulation.fields();
      for (const Field& field : fields.lattice) {
        const bool heat = field.name == "temperature";
        if (!heat && field.name != "concentration_A") continue;
        std::vector<double> values(nx * ny);
        field.read(values);
        const double low = heat ? cold : 0, range = heat ? hot - cold : 1;
        for (const double value : values) {
          const double share = (value - low) / range;
          found = std::max({found, -share, share - 1});
        }
      }
    }
  } catch (const StabilityError&) {
    return std::nullopt;
  }
  // that which has grown so far is lost, and only has not come to the bounds at which a run ends
  return found < 2 ? std::optional(found) : std::nullopt;
}

std::string word(const std::optional<double>& found) {
  return found ? fmt::format("{:.3f}", *found) : "lost";
}

/// Diffusivities of heat from 3e-4 to 2, of the acid from 1e-4 to 0.5, conductivities of rock from a hundredth to
/// hundredfold, speeds at the inlet up to 0.1 (between the grains twice that).
TEST(ChosenIntervals, LoseNothingThatHoldsWithEveryStep) {
  const std::string every = "[accuracy]\nupdate_interval = 1\nwall_interval = 1\n";
  int held = 0, lost = 0;
  for (const auto& [heat, acid] : {std::pair{2.0, 0.5}, {0.5, 0.1}, {0.05, 0.02}, {0.01, 1e-3}, {3e-4, 1e-4}})
    for (const double contrast : {0.01, 2.5, 100.0})
      for (const double speed : {0.003, 0.02, 0.05, 0.1}) {
        const std::string scene = grains(heat, acid, contrast, speed);
        const std::optional<double> before = overshoot(scene + every);
        for (const double tolerance : {1e-3, 0.1}) {
          const std::string chosen = fmt::format("[accuracy]\ntolerance = {}\nprecision = \"double\"\n", tolerance);
          const std::optional<double> now = overshoot(scene + chosen);
          std::printf("    D %g and %g, contrast %g, u %g: %s, with tolerance %g %s\n", heat, acid, contrast, speed,
                      word(before).c_str(), tolerance, word(now).c_str());
          if (!before) continue;
          ASSERT_TRUE(now) << heat << " " << acid << " " << contrast << " " << speed;
          EXPECT_LT(*now, *before + alike) << heat << " " << acid << " " << contrast << " " << speed;
        }
        (before ? held : lost) += 1;
      }
  EXPECT_GT(held, 30);
  EXPECT_GT(lost, 5) << "the map goes beyond what holds";
}

}  // namespace
}  // namespace vug
