#pragma once
// Whether a case may have cracks narrower than a cell.
#include "io/scene.hpp"

#include <algorithm>

namespace vug {

/// The key that gives pathways or cracks widths in metres; null where they are a number of cells wide, or there are
/// none.
inline const char* key_of_true_widths(const Scene& scene) {
  if (!scene.rock) return nullptr;
  if (scene.rock->pathway_width) return "rock.pathway_width";
  return scene.damage && scene.damage->aperture == ApertureLaw::opening ? "damage.aperture = \"opening\"" : nullptr;
}

/// Whether pathways are as wide as their cracks open, or some have a width in metres below the spacing.
inline bool has_cracks_below_a_cell(const Scene& scene) {
  if (!scene.rock) return false;
  if (scene.damage && scene.damage->aperture == ApertureLaw::opening) return true;
  const RockSection& rock = *scene.rock;
  if (!rock.pathway_width) return false;
  const double cell = scene.lattice.spacing;
  const double broken = scene.damage ? scene.damage->minimum_width.value_or(*rock.pathway_width) : cell;
  return *rock.pathway_width < cell || broken < cell ||
         std::any_of(rock.notches.begin(), rock.notches.end(),
                     [&](const Notch& notch) { return notch.width.value_or(cell) < cell; });
}

}  // namespace vug
