#include "coupling/narrow_passages.hpp"

#include "coupling/pore_runs.hpp"
#include "coupling/temperature_range.hpp"
#include "kernels/flow/mrt.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace vug {

std::vector<std::string> remarks_on_narrow_passages(const Scene& scene, const FluidPicture& picture,
                                                    const LatticeUnits& units) {
  constexpr double notable = 0.5;
  const FlowSection& flow = *scene.flow;
  const double tau = 0.5 + 3 * lowest_viscosity(scene) / units.diffusivity();
  const double magic = wall_magic(relaxation_rates(flow.collision, tau)), carried = carried_by_rows(1, magic);
  if (carried >= notable) return {};
  std::vector<std::string> remarks;
  const std::vector<double> width = shorter_widths(scene, picture);
  if (const auto narrow = std::count(width.begin(), width.end(), 1.0); narrow > 0)
    remarks.push_back(fmt::format(
        "flow.collision: {} of {} fluid nodes are in passages one cell wide, which carry {:.2g} of what flows between "
        "plates (two cells: {:.2g}); trt carries {:.2g} and {:.2g} (docs/model.md, \"Walls and pressure sides\")",
        narrow, picture.fluid_nodes(), carried, carried_by_rows(2, magic), carried_by_rows(1, exact_wall_magic),
        carried_by_rows(2, exact_wall_magic)));
  if (scene.damage && scene.damage->aperture == ApertureLaw::opening)
    remarks.push_back(fmt::format(
        "flow.collision: a crack narrower than a cell conducts as it gapes with trt only; here a row of nodes carries "
        "{:.2g} of what flows between plates, not {:.2g}, before the drag of the crack is added",
        carried, carried_by_rows(1, exact_wall_magic)));
  return remarks;
}

}  // namespace vug
