#pragma once
// The widths of pathways, notches and broken bonds, as given by the case.
#include "base/require.hpp"
#include "coupling/pathways.hpp"
#include "coupling/slit.hpp"
#include "io/scene.hpp"

#include <fmt/format.h>

namespace vug {

/// The widths given by the case, in cells.
struct PathwayWidths {
  bool cubic;                              ///< widths are those of slots of any width; otherwise of rows of nodes
  double spacing, of_pathways, of_broken;  ///< m, cells, cells; of_broken is the least width of a broken bond

  explicit PathwayWidths(const Scene& scene)
      : cubic(scene.rock->pathway_width.has_value()), spacing(scene.lattice.spacing) {
    const double in_metres = scene.rock->pathway_width.value_or(0);
    const DamageSection damage = scene.damage.value_or(DamageSection{});
    of_pathways = cubic ? in_metres / spacing : scene.rock->pathway_aperture;
    of_broken = cubic ? damage.minimum_width.value_or(in_metres) / spacing : damage.minimum_aperture;
    if (!cubic) return;
    require_width(scene, "rock.pathway_width", of_pathways);
    if (of_broken > 0) require_width(scene, "damage.minimum_width", of_broken);
    for (const Notch& notch : scene.rock->notches)
      if (notch.width.value_or(0) > 0)
        require_width(scene, fmt::format("rock.notches.{}.width", notch.entry).c_str(), of(notch));
  }
  double of(const Notch& notch) const {
    if (!cubic) return notch.aperture;
    return notch.width ? *notch.width / spacing : of_pathways;
  }
  /// Throws InputError for a width below narrowest_slit, because such a pathway would never open.
  void require_width(const Scene& scene, const char* key, double width) const {
    constexpr double rounding = 1e-9;
    if (width < narrowest_slit * (1 - rounding))
      throw InputError(fmt::format("{}: {} is {:g} m, {:.2g} cells; pathways have {:g} cells or more", scene.path, key,
                                   width * spacing, width, narrowest_slit));
  }
  /// Aperture of the strip of nodes that a pathway opens.
  double strip(double width) const { return cubic ? strip_of_slot(width) : width; }
  /// Whether the strip needs drag to conduct no more than the pathway.
  bool drags(double width, double slope) const {
    return width > 0 && slit_resistance(cubic ? cubic_law(width) : slot_conductivity(width), slope) > 0;
  }
};

}  // namespace vug
