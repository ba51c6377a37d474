// Pressures that no fluid has.
#include "coupling/flow_module.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace vug {

template <class T>
std::vector<Concern> FlowModule<T>::concerns(const Exec& exec) const {
  // without a side that has a pressure, the level of all pressures is arbitrary; from 0, pressures below it are meant
  const bool known = std::any_of(boundaries_.begin(), boundaries_.end(), [](const StretchLinks& boundary) {
    const FlowBoundaryKind kind = boundary.stretch.conditions.flow.kind;
    return kind == FlowBoundaryKind::pressure || kind == FlowBoundaryKind::outflow;
  });
  if (!known || section_.initial_pressure == 0) return {};
  const auto by = std::find_if(boundaries_.begin(), boundaries_.end(), [](const StretchLinks& boundary) {
    const Stretch& stretch = boundary.stretch;
    return draws(stretch.conditions.flow, stretch.opening ? std::nullopt : std::optional(stretch.side));
  });
  if (by == boundaries_.end()) return {};
  constexpr double noise = 1e-3;  // share of the pressure differences
  const Ranks& ranks = geometry_.split.ranks();
  const FieldRange density = field_range(exec, densities(exec, geometry_.fluid, fields_), geometry_.fluid.share());
  const double pascal = units_.pressure() / 3;
  const double lowest = pascal * ranks.least(density.min), highest = pascal * ranks.most(density.max);
  const double absolute = units_.reference_pressure + lowest;
  if (absolute >= -noise * (highest - lowest)) return {};
  return {{"absolute pressures below 0",
           fmt::format(" (down to {:.3g} Pa): {} draws faster than the pressures of the case can drive the fluid",
                       absolute, by->stretch.key)}};
}

template std::vector<Concern> FlowModule<float>::concerns(const Exec&) const;
template std::vector<Concern> FlowModule<double>::concerns(const Exec&) const;

}  // namespace vug
