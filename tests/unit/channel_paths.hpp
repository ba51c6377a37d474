#pragma once
// A channel with what is drawn into it, and what is found about its flow before the first step.
#include "base/require.hpp"
#include "coupling/flow_paths.hpp"
#include "coupling/simulation.hpp"

#include <string>
#include <vector>

namespace vug::test {

inline std::string rectangle(const char* from, const char* to) {
  return std::string("[[geometry.shapes]]\ntype = \"rectangle\"\nfrom = ") + from + "\nto = " + to + "\n";
}

/// A channel of 40 x 12 cells, lattice units, with what is drawn into it.
inline std::string channel(const std::string& shapes, const std::string& sides) {
  return "[lattice]\nsize = [40, 12]\nspacing = 1\ntime_step = 1\n[time]\nsteps = 10\n"
         "[flow]\nviscosity = 0.1\ndensity = 1\ninitial_pressure = 0\n[geometry]\n" +
         (shapes.empty() ? std::string() : "type = \"shapes\"\n" + shapes) + sides;
}

inline const std::string pressures =
    "[boundary.left]\nflow = { type = \"pressure\", pressure = 0.01 }\n"
    "[boundary.right]\nflow = { type = \"pressure\", pressure = 0 }\n";
inline const std::string inflow = "[boundary.left]\nflow = { type = \"velocity\", velocity = [0.02, 0] }\n";
inline const std::string outlet = "[boundary.right]\nflow = { type = \"outflow\" }\n";
inline const std::string dissolving =
    "[solute]\n[[solute.species]]\nname = \"A\"\ndiffusivity = 0.1\n"
    "[reaction]\nreactant = \"A\"\nrate_constant = 1e-3\nmolar_volume = 1e-3\n";
inline const std::string wall = rectangle("[20, 0]", "[23, 12]");

inline FlowPaths paths(const std::string& text) {
  const Scene scene = parse_scene(text, "a.toml");
  const Simulation simulation(scene);
  return find_flow_paths(scene, simulation.parts().geometry, simulation.parts().units);
}

inline std::vector<std::string> remarks(const std::string& text) {
  return paths(text).warnings;
}

inline std::string refusal(const std::string& text) {
  const Scene scene = parse_scene(text, "a.toml");
  try {
    const Simulation simulation(scene);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

}  // namespace vug::test
