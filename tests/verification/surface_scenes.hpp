#pragma once
// Small scenes whose sides and shapes tell what acts on them and passes through them.
#include <fmt/format.h>

#include <string>

namespace vug::test::surfaces {

inline constexpr double dx = 2e-3, dt = 1e-3, density = 800;

inline std::string lattice(int nx, int ny) {
  return fmt::format("[lattice]\nsize = [{:.17g}, {:.17g}]\nspacing = 2e-3\ntime_step = 1e-3\n[time]\nsteps = 100000\n",
                     nx * dx, ny * dx);
}

inline const std::string flow =
    "[flow]\ndensity = 800\nviscosity = 1.2e-3\ninitial_pressure = 3e5\npressure_scale = 5\n";
inline const std::string told = "[output]\nforces = true\nflows = true\n";

inline const std::string heat =
    "[heat]\nfluid_diffusivity = 3e-4\nsolid_diffusivity = 5e-4\nfluid_density = 900\nfluid_heat_capacity = 3500\n"
    "solid_density = 2600\nsolid_heat_capacity = 850\ninitial_temperature = 350\n";

}  // namespace vug::test::surfaces
