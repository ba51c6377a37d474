#include "coupling/far_pressures.hpp"

#include "coupling/body_forces.hpp"
#include "io/each_boundary.hpp"

#include <fmt/format.h>

#include <cmath>

namespace vug {

std::optional<PressureLevels> pressure_levels(const Scene& scene, const FlowPaths& paths, const LatticeUnits& units) {
  if (!scene.flow) return std::nullopt;
  const double start = scene.flow->initial_pressure;
  std::optional<Span> all;
  for_each_boundary(scene, [&](const BoundarySection& given) {
    const FlowBoundary& flow = given.flow;
    if (flow.kind != FlowBoundaryKind::pressure && flow.kind != FlowBoundaryKind::outflow) return;
    const bool free = flow.kind == FlowBoundaryKind::outflow;
    const Span here{free ? start : flow.pressure.lowest(), free ? start : flow.pressure.highest()};
    all = all ? all->with(here) : here;
  });
  if (!all) return std::nullopt;
  const BodyForces forces = body_forces(scene, units);
  const double weight = std::max(forces.largest(0) * scene.lattice.nx, forces.largest(1) * scene.lattice.ny);
  return PressureLevels{std::max(std::abs(all->low - start), std::abs(all->high - start)),
                        std::max(all->high - all->low, units.pressure() * std::max(paths.passage_pressure, weight)),
                        (all->low + all->high) / 2};
}

std::string warning_of_far_pressures(const Scene& scene, const FlowPaths& paths, const LatticeUnits& units) {
  constexpr double far = 20;  // from there on the velocity is off by 1e-5 to 1e-4 (docs/model.md)
  if (scene.accuracy.precision != Precision::single_precision) return "";
  const std::optional<PressureLevels> levels = pressure_levels(scene, paths, units);
  if (!levels || levels->difference == 0 || levels->distance <= far * levels->difference) return "";
  return fmt::format(
      "single precision: the given pressures are up to {:.3g} Pa from flow.initial_pressure and drive the flow by "
      "{:.3g} Pa only, so that velocities lose digits; set flow.initial_pressure to about {:.4g} Pa, or "
      "accuracy.precision = \"double\"",
      levels->distance, levels->difference, levels->middle);
}

}  // namespace vug
