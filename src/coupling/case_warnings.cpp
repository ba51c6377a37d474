#include "coupling/case_warnings.hpp"

#include "coupling/far_pressures.hpp"
#include "coupling/interval_warnings.hpp"
#include "coupling/minerals.hpp"
#include "coupling/rock_limits.hpp"

#include <fmt/format.h>

#include <cmath>

namespace vug {

namespace {

/// Pathways come in whole cuts through the rock, so that small porosities may be missed.
std::optional<std::string> remark_on_porosity(const RockSection& wanted, double found) {
  constexpr double noticeable = 0.1;
  if (wanted.pathway_width || std::abs(found - wanted.porosity) <= noticeable * wanted.porosity) return std::nullopt;
  return fmt::format(
      "rock.porosity = {:g}, and pathways and notches take {:.3g} of the rock, the nearest that was found: notches "
      "always do, and pathways come in whole cuts; other triangles or another rock.pathway_aperture may come closer",
      wanted.porosity, found);
}

}  // namespace

std::vector<std::string> warnings_of(const Scene& scene, const Parts& parts, const FlowPaths& paths) {
  std::vector<std::string> warnings = scene.warnings;
  for (std::string& warning : interval_warnings(scene)) warnings.push_back(std::move(warning));
  if (std::string far = warning_of_far_pressures(scene, paths, parts.units); !far.empty())
    warnings.push_back(std::move(far));
  if (!parts.warning.empty()) warnings.push_back(parts.warning);
  for (std::string& remark : remarks_on_absent_minerals(scene, parts.geometry.mineral))
    warnings.push_back(std::move(remark));
  if (parts.rock && (scene.flow || scene.heat || scene.solute))
    if (const auto remark = remark_on_triangles(parts.rock->assembly, scene.lattice.spacing))
      warnings.push_back(*remark);
  if (parts.rock && scene.rock->porosity > 0)
    if (const auto remark = remark_on_porosity(*scene.rock, parts.rock->porosity)) warnings.push_back(*remark);
  if (parts.rock)
    for (std::string& remark : remarks_on_notches_of_mesh(scene, parts.rock->assembly))
      warnings.push_back(std::move(remark));
  warnings.insert(warnings.end(), paths.warnings.begin(), paths.warnings.end());
  return warnings;
}

}  // namespace vug
