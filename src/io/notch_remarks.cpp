#include "io/notch_remarks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace vug {
namespace {

/// Names of the keys that make broken bonds wider than `width`.
std::string what_widens(double width, double least, double by_damage, bool metres) {
  std::string own = metres ? "damage.minimum_width" : "damage.minimum_aperture";
  if (width >= by_damage) return own;
  return width < least ? own + " and damage.pathway_factor" : "damage.pathway_factor";
}

}  // namespace

/// A notch consists of broken bonds, which [damage] widens to (or by) c_d times the distance of their centroids, or to
/// its own least width.
std::vector<std::string> remarks_on_notches(const Scene& scene, double element_size) {
  const RockSection& rock = *scene.rock;
  const DamageSection& damage = *scene.damage;
  if (damage.aperture == ApertureLaw::opening) return {};
  const bool metres = rock.pathway_width.has_value();
  const double cell = metres ? 1 : scene.lattice.spacing;  // in the unit of the widths
  const double least = metres ? damage.minimum_width.value_or(*rock.pathway_width) : damage.minimum_aperture;
  const double by_distance = damage.pathway_factor * element_size / std::sqrt(3.0) / cell;  // of the mean triangle
  const bool added = damage.widening == PathwayWidening::added;
  const auto by_damage = [&](double width) { return (added ? width : 0) + by_distance; };
  std::map<int, double> narrow;  // width of notches that may be rows of lines
  for (const Notch& notch : rock.notches) {
    const double width = metres ? notch.width.value_or(*rock.pathway_width) : notch.aperture;
    if (width > 0 && width < std::max(least, by_damage(width))) narrow[notch.entry] = width;
  }
  std::vector<std::string> remarks;
  for (const auto& [entry, width] : narrow)
    remarks.push_back(
        fmt::format("rock.notches.{} is {:g} {} wide only until the first update, and about {:.3g} wide from then on, "
                    "like every broken bond: lower {} to keep it narrower",
                    entry, width, metres ? "m" : "cells", std::max(least, by_damage(width)),
                    what_widens(width, least, by_damage(width), metres)));
  return remarks;
}

}  // namespace vug
